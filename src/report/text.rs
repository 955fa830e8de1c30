//! The verdicts for the terminal: a line a scheme, a line for each scheme and scene that is not green, a summary.

use std::collections::HashMap;

use crate::record::{ClaimName, Records, Ruling, Verdict};

use super::survey::{self, Outcome};

/// Most lines that `verbose` gives to a scheme in a scene.
const MOST_LINES: usize = 10;
/// Quantities that are named before they are counted.
const NAMED: usize = 3;

/// A scheme in a scene.
struct Cell<'a> {
    scene: &'a str,
    scheme: &'a str,
    verdicts: Vec<&'a Verdict>,
}

/// The verdicts as text: a line a scheme with its counts; a line for each scheme and scene with a claim that fails, breaks or stays
/// undecided, the size of the error first and then the rule; a summary. `verbose` adds at most ten lines for each scheme and scene.
pub fn verdict_table(records: &Records, verbose: bool) -> String {
    let cells = cells(records);
    let mut text = String::new();
    if verbose {
        for cell in &cells {
            text += &format!("{}\n\n", listed(cell).join("\n"));
        }
    }
    text += &by_scheme(&cells);
    let red = remarks(records).into_iter().filter(|remark| !remark.outcome.is_green());
    let line =
        |one: Remark| format!("{}: {} in {}: {}", one.outcome.words(), one.scheme, one.scene, one.words);
    let red: Vec<String> = red.map(line).collect();
    if !red.is_empty() {
        text += &format!("\n{}\n", red.join("\n"));
    }
    text + &format!("\n{}\n", summary(records))
}

/// The verdicts on each scheme in each scene, where there are any.
fn cells(records: &Records) -> Vec<Cell<'_>> {
    let mut cells: HashMap<(&str, &str), Vec<&Verdict>> = HashMap::new();
    for verdict in &records.verdicts {
        cells.entry((&verdict.scene, &verdict.scheme)).or_default().push(verdict);
    }
    let schemes = survey::schemes(records);
    let places =
        survey::scenes(records).into_iter().flat_map(|scene| schemes.iter().map(move |s| (scene, *s)));
    let cell = |(scene, scheme)| {
        let mut verdicts = cells.remove(&(scene, scheme))?;
        verdicts.sort_by_key(|verdict| Outcome::of(verdict));
        Some(Cell { scene, scheme, verdicts })
    };
    places.filter_map(cell).collect()
}

/// A line a scheme: its name, its worst outcome, its counts, and in how many scenes.
fn by_scheme(cells: &[Cell<'_>]) -> String {
    let schemes = survey::distinct(cells.iter().map(|cell| cell.scheme));
    let width = schemes.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let line = |scheme: &str| {
        let own = || cells.iter().filter(|cell| cell.scheme == scheme);
        let verdicts = own().flat_map(|cell| cell.verdicts.iter().copied());
        let worst = verdicts.clone().map(Outcome::of).filter(|outcome| !outcome.is_green()).min();
        let judged = || verdicts.clone().any(|verdict| Outcome::of(verdict) != Outcome::NotApplicable);
        let word = match worst {
            Some(outcome) => outcome.words(),
            None if judged() => Outcome::Pass.words(),
            None => "not judged",
        };
        let counts = survey::tally_words(&survey::tally(verdicts.clone()));
        let scenes = own().count();
        let plural = if scenes == 1 { "" } else { "s" };
        format!("{scheme:width$}  {word:12}  {scenes} scene{plural}: {counts}\n")
    };
    schemes.into_iter().map(line).collect()
}

/// The error of each quantity at the finest step, as words.
struct Sizes<'a>(HashMap<(&'a str, &'a str, &'a str), (f64, String)>);

impl Sizes<'_> {
    fn of(records: &Records) -> Sizes<'_> {
        let mut sizes: HashMap<(&str, &str, &str), (f64, String)> = HashMap::new();
        for row in &records.measurements {
            let Some(value) = row.value else { continue };
            let Some(quantity) = row.metric.strip_suffix("-end") else { continue };
            let known = sizes.entry((&row.scene, &row.scheme, quantity)).or_insert((f64::MAX, String::new()));
            if row.step_s < known.0 {
                let (unit, step) = (&row.unit, row.step_s);
                *known = (step, format!("{quantity} off by {value:.2e} {unit} at h = {step:.1e} s; "));
            }
        }
        Sizes(sizes)
    }
}

/// The worst of a scheme in a scene.
pub(super) struct Remark<'a> {
    pub(super) scheme: &'a str,
    pub(super) scene: &'a str,
    pub(super) outcome: Outcome,
    /// What the first verdict that it speaks of is about.
    pub(super) claim: ClaimName,
    /// Whether something is worse than on record.
    pub(super) on_record: bool,
    /// The size of the error, then the rule; for a program that solves another motion, what explains it.
    pub(super) words: String,
}

/// What a reader must see: a remark for each scheme in each scene that has more than passes.
pub(super) fn remarks(records: &Records) -> Vec<Remark<'_>> {
    let sizes = Sizes::of(records);
    cells(records).iter().filter_map(|cell| remark(&sizes, cell)).collect()
}

fn remark<'a>(sizes: &Sizes<'a>, cell: &Cell<'a>) -> Option<Remark<'a>> {
    let first = cell.verdicts.first().copied()?;
    let outcome = Outcome::of(first);
    if !outcome.needs_attention() {
        return None;
    }
    let alike = || cell.verdicts.iter().copied().filter(|verdict| Outcome::of(verdict) == outcome);
    let of_record = || alike().filter(|verdict| verdict.claim == ClaimName::OrderOnRecord);
    let whole = |verdict: &&Verdict| verdict.quantity == "body-point";
    let budget = alike().find(|verdict| verdict.claim == ClaimName::Budget);
    let lead = of_record().find(whole).or(of_record().next()).or(budget);
    let lead = lead.or(alike().find(whole)).unwrap_or(first);
    let red = cell.verdicts.iter().filter(|verdict| !Outcome::of(verdict).is_green()).count();
    let more = if red > 1 { format!(" (and {} more)", red - 1) } else { String::new() };
    let (scheme, scene) = (cell.scheme, cell.scene);
    let on_record = alike().any(|verdict| verdict.claim.is_on_record());
    let remark = |claim, words| Remark { scheme, scene, outcome, claim, on_record, words };
    let cause = cell.verdicts.iter().find(|verdict| verdict.quantity == "cause");
    if let (Ruling::Fail, Some(cause)) = (first.verdict, cause) {
        let what = first.detail.split(" (").next().unwrap_or_default();
        let words = format!("{}: {what}; {}{more}", first.quantity, cause.detail);
        return Some(remark(first.claim, words));
    }
    let size = sizes.0.get(&(scene, scheme, lead.quantity.as_str()));
    let size = size.map_or("", |(_, words)| words);
    let words = match (lead.claim, &lead.known_deviation) {
        (ClaimName::OrderOnRecord, _) => {
            format!("{}: {}; {size}{}{more}", lead.quantity, lead.detail, lead.claim)
        }
        (claim, Some(why)) => format!("{size}{claim}, {}: {} (known: {why})", lead.quantity, lead.detail),
        (claim, None) => format!("{size}{claim}, {}: {}{more}", lead.quantity, lead.detail),
    };
    Some(remark(lead.claim, words))
}

/// All verdicts of a scheme in a scene: counts, then a line for each claim and outcome, the worst first.
fn listed(cell: &Cell<'_>) -> Vec<String> {
    let counts = survey::tally_words(&survey::tally(cell.verdicts.iter().copied()));
    let mut lines = vec![format!("{} in {}: {counts}", cell.scheme, cell.scene)];
    let mut groups: Vec<Vec<&Verdict>> = Vec::new();
    let kind = |verdict: &Verdict| (Outcome::of(verdict), verdict.claim);
    for verdict in &cell.verdicts {
        match groups.iter_mut().find(|group| kind(group[0]) == kind(verdict)) {
            Some(group) => group.push(verdict),
            None => groups.push(vec![verdict]),
        }
    }
    let shown = if groups.len() < MOST_LINES { groups.len() } else { MOST_LINES - 2 };
    lines.extend(groups[..shown].iter().map(|group| group_line(group)));
    if shown < groups.len() {
        let rest: Vec<String> = groups[shown..].iter().map(|group| group[0].claim.to_string()).collect();
        let rest = survey::distinct(rest.iter().map(String::as_str)).join(", ");
        lines.push(format!("  and, in the records (--json): {rest}"));
    }
    lines
}

/// The verdicts on one claim with one outcome: the quantities, and the detail of the first.
fn group_line(group: &[&Verdict]) -> String {
    let first = group[0];
    let quantities = if group.len() <= NAMED {
        group.iter().map(|verdict| verdict.quantity.as_str()).collect::<Vec<_>>().join(", ")
    } else {
        format!("{} and {} more", first.quantity, group.len() - 1)
    };
    let known = first.known_deviation.as_ref().map(|why| format!(" (known: {why})")).unwrap_or_default();
    format!("  {:15}  {}, {quantities}: {}{known}", Outcome::of(first).words(), first.claim, first.detail)
}

pub(super) fn summary(records: &Records) -> String {
    let counts = survey::tally_words(&survey::tally(records.verdicts.iter()));
    let cut = if records.complete { "" } else { " · interrupted: not everything was measured" };
    format!("{} verdicts: {counts}{cut}", records.verdicts.len())
}
