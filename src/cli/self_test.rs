//! `polhode self-test`: planted defects, each of which must go red.

mod json;

use std::collections::{BTreeMap, BTreeSet};

use clap::Args;
use comfy_table::{Table, presets};

use super::Failure;
use super::output::{Format, print};
use super::progress::{with_bar, with_word};
use crate::scenes::random::{self, Family};
use crate::self_test::random::Finding;
use crate::self_test::{self, Findings, Outcome};

/// Options of `polhode self-test`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Judge correct schemes in this many random scenes instead: none may fail
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    random: Option<u64>,
    /// Seed of the random scenes
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Random scenes that are extreme: far away, fast, thin, flipping, of the size of a molecule or a planet, by turns
    #[arg(long)]
    extreme: bool,
    /// Print random scene K of the seed as a scene file
    #[arg(long, value_name = "K", conflicts_with = "random")]
    print: Option<u64>,
    /// Form of the findings
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
Plants defects in the scheme, the force laws, the start, what a run shows, the reference and the claims, and prints which gates
caught each. A defect is judged until two gates have caught it. With --random, correct schemes are judged in scenes that
nobody has chosen.

Examples:
  polhode self-test
  polhode self-test --random 1000 --seed 7
  polhode self-test --seed 7 --print 412 > scene.toml      then: polhode gate --scene scene.toml

Exit code: 0 every defect was caught and the faithful copy of the scheme stayed green, or no correct scheme failed;
1 otherwise.";

pub(super) fn self_test(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let families: &[Family] = if options.extreme { &Family::EXTREME } else { &[Family::Ordinary] };
    if let Some(number) = options.print {
        let family = families[number as usize % families.len()];
        print(&random::text(family, options.seed, number))?;
        return Ok(0);
    }
    if let Some(count) = options.random {
        return judge_random_scenes(families, (options.seed, count), options.format, quiet);
    }
    let findings = with_bar(quiet, "planting", |progress| self_test::run(progress));
    print(&match options.format {
        Format::Text => format!("{}\n\n{}", matrix(&findings), summary(&findings)),
        Format::Json => json::of_defects(&findings),
    })?;
    Ok(u8::from(!findings.sound()))
}

/// Defects by gates, a column a gate under its number, and what the numbers stand for.
fn matrix(findings: &Findings) -> String {
    let gates: BTreeSet<&str> =
        findings.outcomes.iter().flat_map(|o| o.caught_by.iter().map(|gate| kind(gate))).collect();
    let mut table = Table::new();
    table.load_preset(presets::NOTHING);
    let numbers = (1..=gates.len()).map(|number| number.to_string());
    table.set_header(["defect".to_owned(), "in".to_owned()].into_iter().chain(numbers));
    for outcome in &findings.outcomes {
        let caught = |column: &&str| {
            if outcome.caught_by.iter().any(|gate| kind(gate) == *column) { "×" } else { "·" }
        };
        let cells = gates.iter().map(caught);
        table.add_row([outcome.name.as_str(), outcome.place].into_iter().chain(cells));
    }
    for column in table.column_iter_mut().skip(2) {
        column.set_padding((0, 1));
    }
    let key: String = gates.iter().zip(1..).map(|(gate, number)| format!("\n  {number:2}  {gate}")).collect();
    format!("{table}\n\n×: the gate of this number goes red{key}")
}

/// The gate, or for a judge that a made-up ladder exposes all ladders together.
fn kind(gate: &str) -> &str {
    gate.split_once(": ").map_or(gate, |(kind, _)| kind)
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

/// Longest list of findings that is printed.
const MOST_SHOWN: usize = 50;

/// Scenes of correct schemes for each in which wrong orders are judged.
const SCENES_FOR_A_WRONG_ORDER: u64 = 10;

fn judge_random_scenes(
    families: &[Family],
    (seed, count): (u64, u64),
    format: Format,
    quiet: bool,
) -> Result<u8, Failure> {
    let findings =
        with_bar(quiet, "judging", |progress| self_test::random::run(families, seed, count, progress));
    if format == Format::Text {
        print(&random_summary(seed, &findings))?;
    }
    let scenes = count.div_ceil(SCENES_FOR_A_WRONG_ORDER);
    let judge_wrong = || with_word(quiet, "judging wrong orders", || self_test::power::run(seed, scenes));
    let wrong_orders = (families == [Family::Ordinary]).then(judge_wrong);
    match (format, &wrong_orders) {
        (Format::Text, Some(rows)) => print(&power_summary(scenes, rows))?,
        (Format::Text, None) => {}
        (Format::Json, rows) => {
            print(&json::of_scenes(seed, &findings, rows.as_deref().unwrap_or_default()))?
        }
    }
    Ok(u8::from(!findings.sound()))
}

/// What the order gate says of wrong orders.
fn power_summary(scenes: u64, rows: &[self_test::power::Row]) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY);
    table.set_header([
        "wrong order",
        "fails",
        "undecided",
        "passes",
        "no order there",
        "power",
        "quantities that pass",
    ]);
    for row in rows {
        let scenes = &row.scenes;
        let counts = [scenes.fail + scenes.broken, scenes.inconclusive, scenes.pass, scenes.not_applicable];
        let quantities =
            format!("{} of {}", row.quantities.pass, row.quantities.all() - row.quantities.not_applicable);
        let cells = counts.map(|count| count.to_string());
        let ends = [format!("{:.1} %", 100.0 * row.power()), quantities];
        table.add_row(std::iter::once(row.name.to_owned()).chain(cells).chain(ends));
    }
    let mut text = format!("\nWrong orders in the first {scenes} of them, by scene:\n{table}\n");
    for row in rows.iter().filter(|row| !row.passed.is_empty()) {
        text += &format!("passes in scenes {:?}: {}\n", row.passed, row.name);
    }
    let mut causes: BTreeMap<&str, usize> = BTreeMap::new();
    for (cause, count) in rows.iter().flat_map(|row| &row.causes) {
        *causes.entry(cause).or_default() += count;
    }
    let mut causes: Vec<_> = causes.into_iter().collect();
    causes.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    text += "Undecided, by cause:\n";
    for (cause, count) in causes {
        text += &format!("{count:6}  {cause}\n");
    }
    text
}

/// How often each cause left a verdict undecided, a line each, and in which families and of which schemes.
fn causes_summary(findings: &self_test::random::Findings) -> String {
    let mut causes: Vec<_> = findings
        .causes()
        .into_iter()
        .map(|(cause, kinds)| (kinds.values().sum::<usize>(), cause, kinds))
        .collect();
    causes.sort_by_key(|(count, ..)| std::cmp::Reverse(*count));
    let mut text = "\nUndecided, by cause:\n".to_owned();
    for (count, cause, kinds) in causes {
        let (mut families, mut schemes): (BTreeMap<String, usize>, BTreeMap<&str, usize>) =
            Default::default();
        for ((family, scheme), count) in &kinds {
            *families.entry(family.to_string()).or_default() += count;
            *schemes.entry(scheme).or_default() += count;
        }
        let of_families = families.iter().map(|(name, count)| format!("{name} {count}"));
        let of_schemes = schemes.iter().map(|(name, count)| format!("{name} {count}"));
        let kinds: Vec<String> = of_families.chain(of_schemes).collect();
        text += &format!("{count:6}  {cause}\n        {}\n", kinds.join(", "));
    }
    text
}

fn random_summary(seed: u64, findings: &self_test::random::Findings) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY);
    table.set_header(["verdicts on", "pass", "fail", "inconclusive", "not applicable", "broken", "decided"]);
    let mut row = |name: &str, tally: &self_test::random::Tally| {
        let counts = [tally.pass, tally.fail, tally.inconclusive, tally.not_applicable, tally.broken];
        let decided = format!("{:.2} %", 100.0 * tally.decided());
        let cells = counts.map(|count| count.to_string());
        table.add_row(std::iter::once(name.to_owned()).chain(cells).chain([decided]));
    };
    for (scheme, tally) in &findings.verdicts {
        row(scheme, tally);
    }
    row("scheme in a scene, its worst", &findings.gates);
    let mut text = format!(
        "{} random scenes of seed {seed}, {} of them without a reference\n\n{table}\n",
        findings.scenes, findings.without_reference
    );
    text += &causes_summary(findings);
    let mut groups: BTreeMap<(u64, &str, &str), Vec<&Finding>> = BTreeMap::new();
    for finding in &findings.against {
        let verdict = &finding.verdict;
        groups.entry((finding.number, &verdict.scheme, verdict.claim.word())).or_default().push(finding);
    }
    for ((number, scheme, claim), found) in groups.iter().take(MOST_SHOWN) {
        let (first, more) = (&found[0].verdict, found.len() - 1);
        let extreme = if found[0].family == Family::Ordinary { "" } else { " --extreme" };
        text += &format!(
            "\nAGAINST A CORRECT SCHEME: {scheme} {claim} {}: {}{}\n  polhode self-test{extreme} --seed {seed} --print {number}\n",
            first.quantity,
            first.detail,
            if more > 0 { format!(" … and {more} more") } else { String::new() },
        );
    }
    text += &match findings.against.len() {
        0 => "\nNothing is held against a correct scheme.\n".to_owned(),
        count => format!("\n{count} verdicts are held against correct schemes.\n"),
    };
    if !findings.complete {
        text += "Interrupted: not every scene was judged.\n";
    }
    text
}
