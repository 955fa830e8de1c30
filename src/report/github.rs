//! The verdicts as workflow commands of GitHub Actions, which shows them on a pull request.

use crate::record::{Records, Verdict};

use super::survey::Outcome;

/// One workflow command a verdict that a reader must see, each on its own line: `::error` for a failed claim and
/// a broken run, `::warning` for what is inconclusive, `::notice` for a known deviation.
pub fn annotations(records: &Records) -> String {
    records.verdicts.iter().filter_map(annotation).collect()
}

fn annotation(verdict: &Verdict) -> Option<String> {
    let outcome = Outcome::of(verdict);
    let level = match outcome {
        Outcome::Fail | Outcome::Broken => "error",
        Outcome::Inconclusive => "warning",
        Outcome::KnownDeviation => "notice",
        Outcome::Pass | Outcome::NotApplicable => return None,
    };
    let title = format!("{}: {} on {}: {}", outcome.words(), verdict.scheme, verdict.scene, verdict.claim);
    let reason = verdict.known_deviation.as_ref().map(|why| format!(" (known: {why})")).unwrap_or_default();
    let message = format!("{} of {}: {}{reason}", verdict.claim, verdict.quantity, verdict.detail);
    Some(format!("::{level} title={}::{}\n", property(&title), message_text(&message)))
}

/// The text of a command: the signs that would end it are escaped.
fn message_text(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// A property of a command, which a colon or a comma would end as well.
fn property(text: &str) -> String {
    message_text(text).replace(':', "%3A").replace(',', "%2C")
}
