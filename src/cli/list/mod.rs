//! `polhode list`: what there is.

mod card;

use clap::{Args, ValueEnum};

use super::output::{Format, Listing, print};
use super::{Failure, select};
use crate::measure;
use crate::model::Quantity;
use crate::model::forces::Law;
use crate::record::{ClaimName, Rule};
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
    /// Form of a list
    #[arg(long, value_enum, default_value_t, conflicts_with = "schema")]
    format: Format,
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
    let format = options.format;
    if let (Format::Json, true) = (format, name.is_some() && !matches!(options.what, What::Claims)) {
        return Err(Failure::Usage(
            "list: --format json belongs to a list, not to one NAME of it".to_owned(),
        ));
    }
    print(&match (options.what, name) {
        (What::Schemes, None) if format == Format::Text => {
            format!("{}\n{}\n", schemes().text(), select::SUBSTEPS)
        }
        (What::Schemes, None) => schemes().write(format),
        (What::Schemes, Some(name)) => card::scheme(&select::contestant(name)?.card),
        (What::Scenes, None) => scenes().write(format),
        (What::Scenes, Some(name)) => card::scene(&scenes::Scene::find(name)?),
        (What::Metrics, name) => metrics(name, format)?,
        (What::Claims, name) => claims(name, format)?,
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
        if options.format == Format::Json {
            let laws = Law::ALL;
            let parameters = laws.iter().flat_map(|law| law.parameters.iter().map(move |one| (law, one)));
            let row = |(law, one): (&crate::model::forces::Described, &crate::model::forces::Parameter)| {
                let default = one.default.as_ref().map_or(String::new(), ToString::to_string);
                [law.name, one.key, one.unit, &default, one.what].map(str::to_owned)
            };
            let header = ["law", "parameter", "unit", "default", "what it is"];
            return Ok(Listing::of(header, parameters.map(row)).write(Format::Json));
        }
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

fn schemes() -> Listing {
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
    Listing::of(["name", "order", "evals", "family", "title"], Contestant::everyone().into_iter().map(row))
}

fn scenes() -> Listing {
    let row = |scene: scenes::Scene| {
        let (duration, model) = (format!("{} s", scene.duration), scene.system.least().name().to_owned());
        [scene.name, duration, model, scene.title]
    };
    Listing::of(["name", "duration", "model", "title"], scenes::built_in().into_iter().map(row))
}

fn metrics(name: Option<&str>, format: Format) -> Result<String, Failure> {
    let errors = Quantity::ALL.into_iter().map(|q| [q.name(), q.unit(), measure::describe(q)]);
    let others = measure::ALL.iter().map(|metric| [metric.name, metric.unit, metric.what]);
    let rows: Vec<[&str; 3]> = errors.chain(others).collect();
    let known: Vec<&str> = rows.iter().map(|row| row[0]).collect();
    match name {
        None => {
            let rows = rows.into_iter().map(|row| row.map(str::to_owned));
            Ok(Listing::of(["metric", "unit", "what it is"], rows).write(format))
        }
        Some(name) => match rows.iter().find(|row| row[0] == name) {
            Some([name, unit, what]) => Ok(format!("{name} [{unit}]: {what}\n")),
            None => Err(unknown("metric", name, &known)),
        },
    }
}

/// The claims of every scheme; with a name those of this kind.
fn claims(name: Option<&str>, format: Format) -> Result<String, Failure> {
    if let Some(rule) = Rule::ALL.into_iter().find(|rule| Some(rule.word()) == name) {
        return Ok(format!("{rule}: {}\n", rule.explained()));
    }
    let rules = Rule::ALL.into_iter().map(Rule::word);
    let known: Vec<&str> = ClaimName::ALL.into_iter().map(ClaimName::word).chain(rules).collect();
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
    let listing = |rows: Vec<[String; 3]>| {
        Listing::of(["scheme", "claim", "what it promises"], rows.into_iter()).write(format)
    };
    if format == Format::Json {
        return Ok(listing(rows));
    }
    let rule = ClaimName::ALL.into_iter().find(|claim| Some(claim.word()) == name);
    let explained = rule.map_or(String::new(), |rule| format!("{rule}: {}\n\n", rule.explained()));
    if rows.is_empty() {
        return Ok(format!(
            "{explained}On no card; every scheme or reference is held to it where it applies.\n"
        ));
    }
    Ok(explained + &listing(rows))
}
