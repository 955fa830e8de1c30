//! `polhode list`: what there is.

use clap::{Args, ValueEnum};
use comfy_table::{ContentArrangement, Table, presets};

use super::{Failure, select};
use crate::claim::Claim;
use crate::metrics;
use crate::model::Quantity;
use crate::model::forces::Law;
use crate::record::stability::Stability;
use crate::scenes;

/// Options of `polhode list`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    /// What to list
    #[arg(value_enum)]
    what: What,
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
    let table = match options.what {
        What::Schemes => schemes(),
        What::Scenes => scenes(),
        What::Metrics => metrics(),
        What::Claims => claims(),
        What::Forces => table(
            &["law", "formula"],
            Law::NAMES.map(|(name, formula)| vec![name.to_owned(), formula.to_owned()]),
        ),
    };
    super::run::print(&format!("{table}\n"))?;
    Ok(0)
}

fn schemes() -> Table {
    let rows = select::everyone().into_iter().map(|contestant| {
        let card = contestant.card;
        vec![
            card.name.to_owned(),
            card.title.to_owned(),
            card.order().to_string(),
            card.evaluations().to_string(),
            card.family.to_owned(),
            card.claims.iter().map(Claim::to_string).collect::<Vec<_>>().join("; "),
            Stability::built_in().line(card.name).unwrap_or("not on record").to_owned(),
            card.source.to_owned(),
        ]
    });
    table(&["name", "title", "order", "evaluations", "family", "claims", "fails where", "source"], rows)
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
        .map(|q| vec![q.name().to_owned(), q.unit().to_owned(), metrics::describe(q).to_owned()]);
    let others = metrics::ALL.iter().map(|m| vec![m.name.to_owned(), m.unit.to_owned(), m.what.to_owned()]);
    table(&["metric (-end and -max)", "unit", "what it is"], errors.chain(others))
}

fn claims() -> Table {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for contestant in select::everyone() {
        for claim in contestant.card.claims {
            rows.push(vec![contestant.card.name.to_owned(), claim.name().to_owned(), claim.to_string()]);
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
