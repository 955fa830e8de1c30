//! The verdicts for GitHub Actions: workflow commands, which it shows on a pull request.

use crate::record::Records;

use super::survey::{self, Outcome};
use super::text;

/// One workflow command for each scheme in each scene that a reader must see, each on its own line and with the scene's file: `::error` for a failed
/// claim and a broken run, `::warning` for what is undecided, `::notice` for known deviations.
pub fn annotations(records: &Records) -> String {
    text::remarks(records).iter().map(|remark| annotation(records, remark)).collect()
}

fn annotation(records: &Records, remark: &text::Remark) -> String {
    let level = match remark.outcome {
        Outcome::Fail | Outcome::Broken => "error",
        Outcome::Inconclusive => "warning",
        Outcome::KnownDeviation | Outcome::Pass | Outcome::NotApplicable => "notice",
    };
    let title = format!("{}: {} in {}", remark.outcome.words(), remark.scheme, remark.scene);
    let file = survey::scene(records, remark.scene).map_or("", |scene| scene.file.as_str());
    let file = if file.is_empty() { String::new() } else { format!("file={},line=1,", property(file)) };
    format!("::{level} {file}title={}::{}\n", property(&title), message_text(&remark.words))
}

/// The text of a command: the signs that would end it are escaped.
fn message_text(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// A property of a command, which a colon or a comma would end as well.
fn property(text: &str) -> String {
    message_text(text).replace(':', "%3A").replace(',', "%2C")
}
