//! The verdicts for the terminal.

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
    for scene in survey::scenes(records) {
        for scheme in survey::schemes(records) {
            let own = |v: &&Verdict| v.scene == scene && v.scheme == scheme;
            let mut fails = records.verdicts.iter().filter(own).filter(|v| v.verdict == Ruling::Fail);
            let cause = records.verdicts.iter().filter(own).find(|v| v.quantity == "cause");
            if let (Some(first), Some(cause)) = (fails.next(), cause) {
                let what = first.detail.split(" (").next().unwrap_or_default();
                text += &format!("{scheme} in {scene}, {}: {what}; {}\n", first.quantity, cause.detail);
            }
        }
    }
    text
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
    for scene in survey::scenes(records) {
        for scheme in survey::schemes(records) {
            let mine = records.verdicts.iter().filter(|row| row.scene == scene && row.scheme == scheme);
            let Some(worst) = mine.clone().map(Outcome::of).min() else { continue };
            table.add_row([scene, scheme, worst.words(), &survey::tally_words(&survey::tally(mine))]);
        }
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
