//! The verdicts as Markdown for the summary of a build: what got worse against the record first.

use std::fmt::Write as _;

use crate::record::Records;

use super::survey::{self, Outcome};
use super::text::{self, Remark};

/// The first line, by which a file of this kind is known.
pub const MARK: &str = "<!-- polhode gate -->";

/// Most rows of a table: a summary of GitHub holds 1 MiB.
const MOST_ROWS: usize = 200;

/// The summary: what is worse than on record, what else fails, what is undecided, and the counts of each scheme.
pub fn step_summary(records: &Records) -> String {
    let remarks = text::remarks(records);
    let fails = |remark: &&Remark| matches!(remark.outcome, Outcome::Fail | Outcome::Broken);
    let of = |keep: &dyn Fn(&&Remark) -> bool| remarks.iter().filter(|one| keep(one)).collect::<Vec<_>>();
    let sections = [
        ("Worse than on record", of(&|one| fails(one) && one.on_record)),
        ("Fails", of(&|one| fails(one) && !one.on_record)),
        ("Undecided", of(&|one| one.outcome == Outcome::Inconclusive)),
    ];
    let mut markdown = format!("{MARK}\n## polhode gate: {}\n", text::summary(records));
    for (title, rows) in &sections {
        if !rows.is_empty() {
            let _ = write!(markdown, "\n### {title}\n\n| scheme | scene | what |\n|---|---|---|\n");
            rows.iter().take(MOST_ROWS).for_each(|row| {
                let _ = writeln!(markdown, "| {} | {} | {} |", row.scheme, row.scene, cell(&row.words));
            });
            if rows.len() > MOST_ROWS {
                let _ = writeln!(markdown, "\n{} more are not shown.", rows.len() - MOST_ROWS);
            }
        }
    }
    markdown + &counts(records)
}

fn counts(records: &Records) -> String {
    let mut markdown = "\n### Schemes\n\n| scheme | verdicts |\n|---|---|\n".to_owned();
    for scheme in survey::schemes(records) {
        let own = records.verdicts.iter().filter(|verdict| verdict.scheme == scheme);
        let _ = writeln!(markdown, "| {} | {} |", cell(scheme), survey::tally_words(&survey::tally(own)));
    }
    markdown
}

/// A text in a cell of a table: a bar or a new line would end it.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ").replace('<', "&lt;")
}
