//! What a repository can hold of a report: a page in Markdown, the key pictures, the tables as CSV and the verdicts as JSON.

use std::borrow::Cow;
use std::path::Path;

use serde::Serialize;

use crate::record::{BRIEF_CSV_FILES, Records, Ruling, Verdict, write_brief_csv, write_json};

use super::folder::Folder;
use super::markdown::Text;
use super::plot::{self, Subject};
use super::{ReportError, names, page, write_page, write_pictures};

const VERDICTS: &str = "verdicts.json";
/// Schema of the file of verdicts.
const SCHEMA: &str = "polhode/verdicts/1";

/// Verdicts without the evidence behind them.
#[derive(Serialize)]
struct Verdicts<'a> {
    schema: &'static str,
    polhode: &'a str,
    made_at: &'a str,
    /// Whether everything was measured; a file of them is written of a whole survey alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    complete: Option<bool>,
    verdicts: Cow<'a, [Verdict]>,
}

/// Writes `report.md`, the key pictures, `verdicts.json` and the tables as CSV into a folder.
///
/// # Errors
/// A file cannot be written, or a picture or the page cannot be made.
pub fn write_brief(
    records: &Records,
    out: &Path,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(), ReportError> {
    let subjects = plot::key_subjects(records);
    let pages = [&["report.md", VERDICTS][..], &BRIEF_CSV_FILES].concat();
    let folder = Folder::open(out, VERDICTS)?;
    folder.begin(&names(&pages, subjects.iter()))?;
    let main = records.without_apart();
    let figures = write_pictures(records, &main, &subjects, out, progress)?;
    let drawn: Vec<&Subject> = figures.iter().map(|figure| &figure.subject).collect();
    write_json(&out.join(VERDICTS), &verdicts(&main))?;
    write_brief_csv(out, &main)?;
    let page = page::compose(records, &main, &figures);
    let data = [VERDICTS].into_iter().chain(BRIEF_CSV_FILES);
    let text = Text::new(records, &main, &page, &figures).with_data(data);
    write_page(&out.join("report.md"), |file| text.render(file))?;
    Ok(folder.finish(&names(&pages, drawn.into_iter()))?)
}

/// Every verdict with its words, for a program that reads standard output.
pub fn verdicts_in_json(records: &Records) -> String {
    let Records { polhode, made_at, verdicts, .. } = records;
    let (complete, verdicts) = (Some(records.complete), Cow::Borrowed(verdicts.as_slice()));
    let all = Verdicts { schema: SCHEMA, polhode, made_at, complete, verdicts };
    serde_json::to_string_pretty(&all).expect("keys are text") + "\n"
}

/// Every verdict that applies; one that holds, without words.
fn verdicts(records: &Records) -> Verdicts<'_> {
    let short = |verdict: &Verdict| match verdict.verdict {
        Ruling::Pass => Verdict { detail: String::new(), ..verdict.clone() },
        _ => verdict.clone(),
    };
    let judged = records.verdicts.iter().filter(|verdict| verdict.verdict != Ruling::NotApplicable);
    Verdicts {
        schema: SCHEMA,
        polhode: &records.polhode,
        made_at: &records.made_at,
        complete: None,
        verdicts: judged.map(short).collect(),
    }
}
