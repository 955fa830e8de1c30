//! What the records hold: which scenes and schemes, how many verdicts of each kind, and which rows belong
//! together.

use crate::record::{Order, OrderStatus, Records, Ruling, SceneRow, Verdict};

use super::number;

/// The result of a verdict as the report counts it: the five rulings, and failures that are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Outcome {
    /// The claim does not hold.
    Fail,
    /// The run or its reference failed.
    Broken,
    /// The measurement cannot decide.
    Inconclusive,
    /// The claim does not hold, for a reason that is recorded.
    KnownDeviation,
    /// The claim holds.
    Pass,
    /// The claim says nothing about the scene.
    NotApplicable,
}

impl Outcome {
    /// Every outcome, the worst first.
    pub(super) const ALL: [Outcome; 6] = [
        Outcome::Fail,
        Outcome::Broken,
        Outcome::Inconclusive,
        Outcome::KnownDeviation,
        Outcome::Pass,
        Outcome::NotApplicable,
    ];

    /// The outcome of a verdict.
    pub(super) fn of(verdict: &Verdict) -> Outcome {
        let settled = matches!(verdict.verdict, Ruling::Pass | Ruling::NotApplicable);
        match verdict.verdict {
            _ if verdict.known_deviation.is_some() && !settled => Outcome::KnownDeviation,
            Ruling::Pass => Outcome::Pass,
            Ruling::Fail => Outcome::Fail,
            Ruling::Inconclusive => Outcome::Inconclusive,
            Ruling::NotApplicable => Outcome::NotApplicable,
            Ruling::Broken => Outcome::Broken,
        }
    }

    /// The outcome in words.
    pub(super) fn words(self) -> &'static str {
        match self {
            Outcome::Fail => "fail",
            Outcome::Broken => "broken",
            Outcome::Inconclusive => "inconclusive",
            Outcome::KnownDeviation => "known deviation",
            Outcome::Pass => "pass",
            Outcome::NotApplicable => "not applicable",
        }
    }

    /// The outcome as a class of the page's style sheet.
    pub(super) fn class(self) -> &'static str {
        match self {
            Outcome::Fail => "fail",
            Outcome::Broken => "broken",
            Outcome::Inconclusive => "inconclusive",
            Outcome::KnownDeviation => "known",
            Outcome::Pass => "pass",
            Outcome::NotApplicable => "apart",
        }
    }

    /// True where a reader must see the detail.
    pub(super) fn needs_attention(self) -> bool {
        self < Outcome::Pass
    }

    /// True where a gate counts nothing against the scheme.
    pub(super) fn is_green(self) -> bool {
        self >= Outcome::KnownDeviation
    }
}

/// How many verdicts have each outcome, in the order of [`Outcome::ALL`], those with none left in.
pub(super) fn tally<'a>(verdicts: impl Iterator<Item = &'a Verdict> + Clone) -> Vec<(Outcome, usize)> {
    let count = |outcome| verdicts.clone().filter(|verdict| Outcome::of(verdict) == outcome).count();
    Outcome::ALL.into_iter().map(|outcome| (outcome, count(outcome))).collect()
}

/// A tally in words: `412 pass, 3 fail`; outcomes that nothing has are left out.
pub(super) fn tally_words(tally: &[(Outcome, usize)]) -> String {
    let words: Vec<String> = tally
        .iter()
        .filter(|(_, count)| *count > 0)
        .map(|(outcome, count)| match outcome {
            Outcome::KnownDeviation => number::counted(*count, outcome.words()),
            _ => format!("{count} {}", outcome.words()),
        })
        .collect();
    if words.is_empty() { "no verdicts".into() } else { words.join(", ") }
}

/// The schemes: those with a card first, then any that only appear in rows.
pub(super) fn schemes(records: &Records) -> Vec<&str> {
    let carded = records.schemes.iter().map(|row| row.name.as_str());
    let measured = records.measurements.iter().map(|row| row.scheme.as_str());
    let judged = records.verdicts.iter().map(|row| row.scheme.as_str());
    let ordered = records.orders.iter().map(|row| row.scheme.as_str());
    let drawn = records.series.iter().map(|row| row.scheme.as_str());
    distinct(carded.chain(measured).chain(judged).chain(ordered).chain(drawn))
}

/// The schemes that were run: a reference has verdicts of its own, but no line in a picture.
pub(super) fn measured_schemes(records: &Records) -> Vec<&str> {
    let runs = |name: &&str| {
        records.measurements.iter().any(|row| row.scheme == **name)
            || records.series.iter().any(|row| row.scheme == **name)
            || records.precision.iter().any(|row| row.scheme == **name)
    };
    schemes(records).into_iter().filter(runs).collect()
}

/// The scenes: those with a row of their own first, then any that only appear in other rows.
pub(super) fn scenes(records: &Records) -> Vec<&str> {
    let rowed = records.scenes.iter().map(|row| row.name.as_str());
    let measured = records.measurements.iter().map(|row| row.scene.as_str());
    let judged = records.verdicts.iter().map(|row| row.scene.as_str());
    let ordered = records.orders.iter().map(|row| row.scene.as_str());
    let drawn = records.series.iter().map(|row| row.scene.as_str());
    distinct(rowed.chain(measured).chain(judged).chain(ordered).chain(drawn))
}

/// The names that are not empty, each once, in the order of their first appearance.
pub(super) fn distinct<'a>(names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = std::collections::HashSet::new();
    names.filter(|name| !name.is_empty() && seen.insert(*name)).collect()
}

/// A scene's row, if the records hold one.
pub(super) fn scene<'a>(records: &'a Records, name: &str) -> Option<&'a SceneRow> {
    records.scenes.iter().find(|row| row.name == name)
}

/// A scene's title, or its name where the records hold no title.
pub(super) fn title<'a>(records: &'a Records, name: &'a str) -> &'a str {
    scene(records, name).map(|row| row.title.as_str()).filter(|title| !title.is_empty()).unwrap_or(name)
}

/// The claimed order of a scheme, if it claims one.
pub(super) fn claimed_order(records: &Records, scheme: &str) -> Option<u32> {
    records.schemes.iter().find(|row| row.name == scheme).map(|row| row.order).filter(|order| *order > 0)
}

/// The order of a scene, scheme and quantity; a place that it is taken at is left out.
pub(super) fn order<'a>(
    records: &'a Records,
    scene: &str,
    scheme: &str,
    quantity: &str,
) -> Option<&'a Order> {
    let same = |row: &&Order| row.scene == scene && row.scheme == scheme && row.quantity == base(quantity);
    records.orders.iter().find(same)
}

/// A metric without the place that it is taken at: that of `orientation-end` is `orientation`.
pub(super) fn base(metric: &str) -> &str {
    metric.trim_end_matches("-end").trim_end_matches("-max")
}

/// True where a step belongs to the runs that decide an order.
pub(super) fn in_window(order: &Order, step_s: f64) -> bool {
    order.status == OrderStatus::Decided
        && order.steps_used_s.iter().any(|used| (used - step_s).abs() <= 1e-9 * step_s.abs())
}

/// A name of a scene as a file name, so that no scene can write outside the folder of plots.
pub(super) fn file_stem(name: &str) -> String {
    let safe = |letter: char| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '-' };
    name.chars().map(safe).collect::<String>().trim_start_matches('.').to_string()
}

/// A quantity in words, without the place that it is taken at: `angular velocity`.
pub(super) fn quantity_words(quantity: &str) -> String {
    base(quantity).replace('-', " ")
}

/// A text with a capital first letter.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first: String = letters.next().map(|letter| letter.to_uppercase().collect()).unwrap_or_default();
    format!("{first}{}", letters.as_str())
}
