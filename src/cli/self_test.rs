//! `polhode self-test`: planted defects, each of which must go red.

use std::collections::BTreeSet;

use clap::Args;
use comfy_table::{ContentArrangement, Table, presets};

use super::Failure;
use super::gate::progress_bar;
use crate::self_test::{self, Findings, Outcome};

/// Options of `polhode self-test`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {}

const EXAMPLES: &str = "\
Plants defects in the scheme, the force laws, the start, what a run shows, the reference and the claims, and prints which gates
caught each. A defect is judged until two gates have caught it.

Exit code: 0 every defect was caught and the faithful copy of the scheme stayed green, 1 otherwise.";

pub(super) fn self_test(_options: &Options, quiet: bool) -> Result<u8, Failure> {
    let bar = progress_bar(quiet, "planting");
    let findings = self_test::run(&|done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    super::run::print(&format!("{}\n\n{}", matrix(&findings), summary(&findings)))?;
    Ok(u8::from(!findings.sound()))
}

/// Defects by gates.
fn matrix(findings: &Findings) -> Table {
    let gates: BTreeSet<&str> =
        findings.outcomes.iter().flat_map(|o| o.caught_by.iter().map(String::as_str)).collect();
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(200);
    }
    table.set_header(["defect", "in"].into_iter().chain(gates.iter().copied()));
    for outcome in &findings.outcomes {
        let caught = |gate: &&str| if outcome.caught_by.contains(*gate) { "red" } else { "" };
        let cells = gates.iter().map(caught);
        table.add_row([outcome.name.as_str(), outcome.place].into_iter().chain(cells));
    }
    table
}

fn summary(findings: &Findings) -> String {
    let mut text = String::new();
    let caught = findings.outcomes.iter().filter(|outcome| !outcome.caught_by.is_empty()).count();
    text += &format!("{caught} of {} defects caught", findings.outcomes.len());
    let single: Vec<&Outcome> =
        findings.outcomes.iter().filter(|outcome| outcome.caught_by.len() == 1).collect();
    text += &format!("; {} by one gate only", single.len());
    for outcome in single {
        let gate = outcome.caught_by.first().map_or("", String::as_str);
        text += &format!("\n  {} ({}): {gate}", outcome.name, outcome.place);
    }
    for outcome in findings.survivors() {
        text += &format!("\nSURVIVES: {} ({})", outcome.name, outcome.place);
    }
    match findings.held_against_the_copy.as_slice() {
        [] => text += "\nThe faithful copy of the scheme stays green.",
        held => text += &format!("\nHELD AGAINST THE FAITHFUL COPY:\n  {}", held.join("\n  ")),
    }
    if !findings.complete {
        text += "\nInterrupted: not every defect was planted.";
    }
    text + "\n"
}
