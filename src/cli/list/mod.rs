//! `polhode list`: what there is.

mod card;

use clap::{Args, ValueEnum};

use super::output::print;
use super::{Failure, select};
use crate::measure;
use crate::model::Quantity;
use crate::model::forces::Law;
use crate::record::ClaimName;
use crate::scenes;
use crate::simulate::Contestant;

/// Options of `polhode list`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// What to list
    #[arg(value_enum)]
    what: What,
    /// One of them alone, with all that is known of it
    name: Option<String>,
    /// The JSON Schema of scene files, for `forces`
    #[arg(long, conflicts_with = "name")]
    schema: bool,
}

const EXAMPLES: &str = "\
Examples:
  polhode list schemes               name, order, evaluations a step, family, title
  polhode list schemes peskin-rk2    its claims, where it fails, its source
  polhode list scenes kovalevskaya
  polhode list forces spring         a block to paste into a scene file";

#[derive(Clone, Copy, Debug, ValueEnum)]
enum What {
    Schemes,
    Scenes,
    Metrics,
    Claims,
    Forces,
}

pub(super) fn list(options: &Options) -> Result<u8, Failure> {
    if !matches!(options.what, What::Forces) && options.schema {
        return Err(Failure::Usage("list: --schema belongs to `polhode list forces`".to_owned()));
    }
    let name = options.name.as_deref();
    print(&match (options.what, name) {
        (What::Schemes, None) => format!("{}\n{}\n", schemes(), select::SUBSTEPS),
        (What::Schemes, Some(name)) => card::scheme(&select::contestant(name)?.card),
        (What::Scenes, None) => scenes(),
        (What::Scenes, Some(name)) => card::scene(&scenes::Scene::find(name)?),
        (What::Metrics, name) => metrics(name)?,
        (What::Claims, name) => claims(name)?,
        (What::Forces, _) => forces(options)?,
    })?;
    Ok(0)
}

/// The laws, each as a table to paste into a scene.
fn forces(options: &Options) -> Result<String, Failure> {
    if options.schema {
        return Ok(format!("{:#}\n", scenes::schema()));
    }
    let Some(name) = &options.name else {
        return Ok(Law::ALL.map(|law| scenes::block(&law)).join("\n"));
    };
    let known = Law::ALL.map(|law| law.name);
    match Law::ALL.iter().find(|law| law.name == name) {
        Some(law) => Ok(scenes::block(law)),
        None => Err(unknown("law", name, &known)),
    }
}

fn unknown(kind: &str, name: &str, known: &[&str]) -> Failure {
    let meant = select::meant(name, known.iter().copied());
    Failure::Usage(format!("no {kind} '{name}'{meant}; {kind}s: {}", known.join(", ")))
}

fn schemes() -> String {
    let count = |count: u32| if count == 0 { "–".to_owned() } else { count.to_string() };
    let row = |contestant: Contestant| {
        let card = contestant.card;
        [
            card.name.to_owned(),
            count(card.order()),
            count(card.evaluations()),
            card.family.to_owned(),
            card.title.to_owned(),
        ]
    };
    columns(["name", "order", "evals", "family", "title"], Contestant::everyone().into_iter().map(row))
}

fn scenes() -> String {
    let row = |scene: scenes::Scene| {
        let (duration, model) = (format!("{} s", scene.duration), scene.system.least().name().to_owned());
        [scene.name, duration, model, scene.title]
    };
    columns(["name", "duration", "model", "title"], scenes::built_in().into_iter().map(row))
}

fn metrics(name: Option<&str>) -> Result<String, Failure> {
    let errors = Quantity::ALL.into_iter().map(|q| [q.name(), q.unit(), measure::describe(q)]);
    let others = measure::ALL.iter().map(|metric| [metric.name, metric.unit, metric.what]);
    let rows: Vec<[&str; 3]> = errors.chain(others).collect();
    let known: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    match name {
        None => {
            Ok(columns(["metric", "unit", "what it is"], rows.into_iter().map(|row| row.map(str::to_owned))))
        }
        Some(name) => match rows.iter().find(|row| row[0] == name) {
            Some([name, unit, what]) => Ok(format!("{name} [{unit}]: {what}\n")),
            None => Err(unknown("metric", name, &known)),
        },
    }
}

/// The claims of every scheme; with a name those of this kind.
fn claims(name: Option<&str>) -> Result<String, Failure> {
    let known = ClaimName::ALL.map(ClaimName::word);
    if let Some(name) = name.filter(|name| !known.contains(name)) {
        return Err(unknown("claim", name, &known));
    }
    let mut rows: Vec<[String; 3]> = Vec::new();
    for contestant in Contestant::everyone() {
        for claim in contestant.card.claims {
            let kind = claim.name().word();
            if name.is_none_or(|name| name == kind) {
                rows.push([contestant.card.name.to_owned(), kind.to_owned(), claim.to_string()]);
            }
        }
    }
    match name {
        Some(name) if rows.is_empty() => {
            Ok(format!("{name}: on no card; every scheme or reference is held to it where it applies\n"))
        }
        _ => Ok(columns(["scheme", "claim", "what it promises"], rows.into_iter())),
    }
}

/// Width of a list.
const WIDTH: usize = 100;

/// Columns two blanks apart, a row a line of at most 100 columns: the last column is cut where it is too long.
fn columns<const N: usize>(header: [&str; N], rows: impl Iterator<Item = [String; N]>) -> String {
    let rows: Vec<[String; N]> = std::iter::once(header.map(str::to_owned)).chain(rows).collect();
    let length = |text: &String| text.chars().count();
    let widths: [usize; N] =
        std::array::from_fn(|column| rows.iter().map(|row| length(&row[column])).max().unwrap_or(0));
    let left = WIDTH.saturating_sub(widths[..N - 1].iter().map(|width| width + 2).sum());
    let mut text = String::new();
    for row in &rows {
        for (cell, width) in row[..N - 1].iter().zip(&widths) {
            text += &format!("{cell:width$}  ");
        }
        let last = &row[N - 1];
        if length(last) > left {
            text.extend(last.chars().take(left - 1));
            text += "…\n";
        } else {
            text += &format!("{last}\n");
        }
    }
    text
}
