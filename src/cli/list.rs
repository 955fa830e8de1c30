//! `polhode list`: what there is.

use clap::{Args, ValueEnum};
use comfy_table::{ColumnConstraint, ContentArrangement, Table, TableComponent, Width, presets};

use super::output::print;
use super::{Failure, select};
use crate::claim::Claim;
use crate::measure;
use crate::model::Quantity;
use crate::model::forces::Law;
use crate::record::stability::Stability;
use crate::scenes;
use crate::simulate::Contestant;

/// Options of `polhode list`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    /// What to list
    #[arg(value_enum)]
    what: What,
    /// One law alone, for `forces`
    name: Option<String>,
    /// The JSON Schema of scene files, for `forces`
    #[arg(long, conflicts_with = "name")]
    schema: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum What {
    Schemes,
    Scenes,
    Metrics,
    Claims,
    Forces,
}

pub(super) fn list(options: &Options) -> Result<u8, Failure> {
    if !matches!(options.what, What::Forces) && (options.name.is_some() || options.schema) {
        return Err(Failure::Usage("list: a NAME and --schema belong to `polhode list forces`".to_owned()));
    }
    print(&match options.what {
        What::Schemes => format!("{}\n\n{}\n", schemes(), select::SUBSTEPS),
        What::Scenes => format!("{}\n", scenes()),
        What::Metrics => format!("{}\n", metrics()),
        What::Claims => format!("{}\n", claims()),
        What::Forces => forces(options)?,
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
    if let Some(law) = Law::ALL.iter().find(|law| law.name == name) {
        return Ok(scenes::block(law));
    }
    let known = Law::ALL.map(|law| law.name);
    let meant = select::meant(name, known.iter().copied());
    Err(Failure::Usage(format!("no law '{name}'{meant}; laws: {}", known.join(", "))))
}

/// Width from which on there is room for titles too.
const WIDE: u16 = 140;

fn schemes() -> Table {
    const HEADER: [&str; 8] =
        ["name", "order", "evaluations", "family", "claims", "fails where", "source", "title"];
    let stability = Stability::built_in();
    let rows = Contestant::everyone().into_iter().map(|contestant| {
        let card = contestant.card;
        let count = |count: u32| if count == 0 { "–".to_owned() } else { count.to_string() };
        vec![
            card.name.to_owned(),
            count(card.order()),
            count(card.evaluations()),
            card.family.to_owned(),
            promises(card.claims),
            stability.line(card.name).unwrap_or("not on record").to_owned(),
            card.source.to_owned(),
            card.title.to_owned(),
        ]
    });
    let mut table = table(&HEADER, rows);
    if !table.is_tty() {
        // One scheme a line, for grep and awk.
        table.set_content_arrangement(ContentArrangement::Disabled);
        for between_rows in [
            TableComponent::HorizontalLines,
            TableComponent::MiddleIntersections,
            TableComponent::LeftBorderIntersections,
            TableComponent::RightBorderIntersections,
        ] {
            table.remove_style(between_rows);
        }
        return table;
    }
    let title = HEADER.len() - 1;
    if table.width().is_none_or(|width| width < WIDE)
        && let Some(column) = table.column_mut(title)
    {
        column.set_constraint(ColumnConstraint::Hidden);
    }
    // Names stand whole, to be copied; the claims get what is left.
    for whole in [0, 2] {
        if let Some(column) = table.column_mut(whole) {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }
    if let Some(claims) = table.column_mut(4) {
        claims.set_constraint(ColumnConstraint::LowerBoundary(Width::Percentage(24)));
    }
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
    }
    table
}

/// Claims in words; those of exactness that are made for the same scenes in one.
fn promises(claims: &[Claim]) -> String {
    let mut words: Vec<String> = Vec::new();
    for (index, claim) in claims.iter().enumerate() {
        let Claim::Exact(_, when) = claim else {
            words.push(claim.to_string());
            continue;
        };
        let alike = |other: &Claim| match other {
            Claim::Exact(quantity, same) if same == when => Some(quantity.name()),
            _ => None,
        };
        if !claims[..index].iter().any(|earlier| alike(earlier).is_some()) {
            let quantities: Vec<&str> = claims.iter().filter_map(alike).collect();
            words.push(format!("exact {when}: {}", quantities.join(", ")));
        }
    }
    words.join("; ")
}

fn scenes() -> Table {
    let rows = scenes::built_in().into_iter().map(|scene| {
        vec![
            scene.name.clone(),
            scene.title.clone(),
            format!("{} s", scene.duration),
            scene.system.least().name().to_owned(),
            scene.why.clone(),
        ]
    });
    table(&["name", "title", "duration", "model", "why"], rows)
}

fn metrics() -> Table {
    let errors = Quantity::ALL
        .into_iter()
        .map(|q| vec![q.name().to_owned(), q.unit().to_owned(), measure::describe(q).to_owned()]);
    let others = measure::ALL.iter().map(|m| vec![m.name.to_owned(), m.unit.to_owned(), m.what.to_owned()]);
    table(&["metric (-end and -max)", "unit", "what it is"], errors.chain(others))
}

fn claims() -> Table {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for contestant in Contestant::everyone() {
        for claim in contestant.card.claims {
            rows.push(vec![contestant.card.name.to_owned(), claim.name().to_string(), claim.to_string()]);
        }
    }
    table(&["scheme", "claim", "what it promises"], rows)
}

fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(140);
    }
    table.set_header(header.iter().copied()).add_rows(rows);
    table
}
