//! The verdicts for the terminal.

use std::collections::HashMap;

use comfy_table::{Attribute, Cell, ContentArrangement, Table, TableComponent, presets};

use crate::record::{Records, Ruling, Verdict};

use super::survey::{self, Outcome};

/// Columns that the tables are fit to.
const WIDTH: u16 = 100;

/// The verdicts as text of at most 100 columns: a line a scene and scheme with counts, then every verdict that
/// needs attention with its detail, then a summary line. `verbose` lists every verdict.
pub fn verdict_table(records: &Records, verbose: bool) -> String {
    let mut text = format!("{}\n", counts_table(records));
    let listed = |verdict: &&Verdict| verbose || Outcome::of(verdict).needs_attention();
    let mut verdicts: Vec<&Verdict> = records.verdicts.iter().filter(listed).collect();
    verdicts.sort_by_key(|verdict| Outcome::of(verdict));
    if !verdicts.is_empty() {
        text += &format!("\n{}\n", detail_table(&verdicts));
    }
    text += &format!("\n{}\n", summary(records));
    text
}

/// A line for each program that solves another motion, in each scene: the size of the error, and what explains it.
pub fn elsewhere(records: &Records) -> String {
    let mut text = String::new();
    for (scene, scheme, own) in cells(records) {
        let first = own.iter().find(|verdict| verdict.verdict == Ruling::Fail);
        let cause = own.iter().find(|verdict| verdict.quantity == "cause");
        if let (Some(first), Some(cause)) = (first, cause) {
            let what = first.detail.split(" (").next().unwrap_or_default();
            text += &format!("{scheme} in {scene}, {}: {what}; {}\n", first.quantity, cause.detail);
        }
    }
    text
}

/// The verdicts on each scheme in each scene, where there are any.
fn cells(records: &Records) -> Vec<(&str, &str, Vec<&Verdict>)> {
    let mut cells: HashMap<(&str, &str), Vec<&Verdict>> = HashMap::new();
    for verdict in &records.verdicts {
        cells.entry((&verdict.scene, &verdict.scheme)).or_default().push(verdict);
    }
    let schemes = survey::schemes(records);
    let places =
        survey::scenes(records).into_iter().flat_map(|scene| schemes.iter().map(move |s| (scene, *s)));
    places.filter_map(|place| Some((place.0, place.1, cells.remove(&place)?))).collect()
}

fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    table
        .set_width(WIDTH)
        .set_header(header.iter().map(|word| Cell::new(word).add_attribute(Attribute::Bold)));
    table
}

fn counts_table(records: &Records) -> Table {
    let mut table = table(&["scene", "scheme", "worst", "verdicts"]);
    table.remove_style(TableComponent::HorizontalLines);
    for (scene, scheme, own) in cells(records) {
        let own = || own.iter().copied();
        let Some(worst) = own().map(Outcome::of).min() else { continue };
        table.add_row([scene, scheme, worst.words(), &survey::tally_words(&survey::tally(own()))]);
    }
    table
}

fn detail_table(verdicts: &[&Verdict]) -> Table {
    let mut table = table(&["verdict", "what", "detail"]);
    for verdict in verdicts {
        let outcome = Outcome::of(verdict);
        let reason =
            verdict.known_deviation.as_ref().map(|why| format!("\nknown: {why}")).unwrap_or_default();
        table.add_row([
            outcome.words().to_string(),
            format!("{}: {}\n{}: {}", verdict.scene, verdict.scheme, verdict.claim, verdict.quantity),
            format!("{}{reason}", verdict.detail),
        ]);
    }
    table
}

fn summary(records: &Records) -> String {
    let counts = survey::tally_words(&survey::tally(records.verdicts.iter()));
    let cut = if records.complete { "" } else { " · interrupted: not everything was measured" };
    format!("{} verdicts: {counts}{cut}", records.verdicts.len())
}
