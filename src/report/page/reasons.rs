//! What does not hold, gathered by its reason: a row a reason, the single verdicts behind it.

use serde::Serialize;

use super::VerdictRow;
use crate::record::Verdict;
use crate::report::survey::{self, Outcome};

/// Why verdicts do not hold.
#[derive(Serialize)]
pub(super) struct Reason {
    class: &'static str,
    outcome: &'static str,
    claim: &'static str,
    /// The reason on record, or what the rule says, its numbers left out.
    words: String,
    count: usize,
    schemes: String,
    scenes: String,
    rows: Vec<VerdictRow>,
}

/// What makes verdicts one row.
type Key = (Outcome, &'static str, String);

/// Names that are listed before they are counted.
const LISTED: usize = 3;

/// The verdicts that need attention by reason, the worst outcome first and then the most.
pub(super) fn reasons(verdicts: &[Verdict]) -> Vec<Reason> {
    let mut groups: Vec<(Key, Vec<&Verdict>)> = Vec::new();
    for verdict in verdicts.iter().filter(|verdict| Outcome::of(verdict).needs_attention()) {
        let key = (Outcome::of(verdict), verdict.claim.word(), words(verdict));
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, own)) => own.push(verdict),
            None => groups.push((key, vec![verdict])),
        }
    }
    groups.sort_by_key(|((outcome, ..), own)| (*outcome, std::cmp::Reverse(own.len())));
    let reason = |((outcome, claim, words), own): (Key, Vec<&Verdict>)| Reason {
        class: outcome.class(),
        outcome: outcome.words(),
        claim,
        words,
        count: own.len(),
        schemes: listed(&survey::distinct(own.iter().map(|row| row.scheme.as_str())), "schemes"),
        scenes: listed(&survey::distinct(own.iter().map(|row| row.scene.as_str())), "scenes"),
        rows: own.into_iter().map(VerdictRow::new).collect(),
    };
    groups.into_iter().map(reason).collect()
}

fn words(verdict: &Verdict) -> String {
    verdict.known_deviation.clone().unwrap_or_else(|| without_numbers(&verdict.detail))
}

/// A few names, or how many there are.
pub(super) fn listed(names: &[&str], noun: &str) -> String {
    if names.len() > LISTED { format!("{} {noun}", names.len()) } else { names.join(", ") }
}

/// A text with an ellipsis for each number: two verdicts of one rule differ in their numbers.
fn without_numbers(text: &str) -> String {
    let part_of_number = |letter: char| letter.is_ascii_digit() || ".,×⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹−".contains(letter);
    let word = |word: &str| {
        let bare = word.trim_matches(|c: char| "()[]:;,".contains(c));
        let starts = bare.trim_start_matches(['-', '−', '+', '±']).starts_with(|c: char| c.is_ascii_digit());
        let number = starts && bare.chars().all(|c| part_of_number(c) || "-+±eE".contains(c));
        if number { word.replace(bare, "…") } else { word.to_owned() }
    };
    let mut words: Vec<String> = text.split_whitespace().map(word).collect();
    words.dedup_by(|a, b| a == b && a.as_str() == "…");
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Ruling;

    #[test]
    fn verdicts_that_differ_in_numbers_share_a_row_and_those_of_other_rules_do_not() {
        let fail = |scene: &str, detail: &str| Verdict {
            scene: scene.into(),
            scheme: "euler".into(),
            verdict: Ruling::Fail,
            detail: detail.into(),
            ..Verdict::default()
        };
        let known = Verdict { known_deviation: Some("on record".into()), ..fail("a", "order 3.2") };
        let rows = [
            fail("a", "order 1.02 ± 0.01 is below 2"),
            fail("b", "order 1.5 ± 0.02 is below 4"),
            fail("a", "broke"),
            known,
        ];
        let reasons = reasons(&rows);
        let counts: Vec<usize> = reasons.iter().map(|reason| reason.count).collect();
        assert_eq!(counts, [2, 1, 1]);
        assert_eq!(reasons[2].words, "on record");
    }
}
