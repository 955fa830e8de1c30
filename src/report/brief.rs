//! What a repository can hold of a report: a page in Markdown, the key pictures, the tables as CSV and the verdicts as JSON.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

use serde::Serialize;

use crate::record::{BRIEF_CSV_FILES, Records, Ruling, Verdict, write_brief_csv, write_json};

use super::folder::Folder;
use super::paper::{self, Language};
use super::plot::{self, Subject};
use super::survey::{self, Outcome};
use super::{ReportError, markdown, names, page, template, write_page, write_pictures};

const PAGE: &str = include_str!("template/brief.md");
const VERDICTS: &str = "verdicts.json";
/// Schema of the file of verdicts.
const SCHEMA: &str = "polhode/verdicts/1";

/// Every verdict on a main scheme, without the evidence behind it; one that holds, without words.
#[derive(Serialize)]
struct Verdicts<'a> {
    schema: &'static str,
    polhode: &'a str,
    made_at: &'a str,
    verdicts: Vec<Verdict>,
}

/// The page.
#[derive(Serialize)]
struct Brief {
    version: String,
    made_at: String,
    machine: String,
    complete: bool,
    verdicts: String,
    scenes: usize,
    schemes: Option<String>,
    rankings: Vec<String>,
    orders: Option<String>,
    drifts: Option<String>,
    reasons: Vec<Reason>,
    pictures: Vec<Picture>,
}

/// Why verdicts are not green, and how many.
#[derive(Serialize)]
struct Reason {
    outcome: &'static str,
    words: String,
    count: usize,
    scenes: usize,
    schemes: usize,
}

#[derive(Serialize)]
struct Picture {
    caption: &'static str,
    file: String,
    data: &'static str,
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
    write_page(&out.join("report.md"), |file| render(&Brief::new(records, &drawn), file))?;
    Ok(folder.finish(&names(&pages, drawn.into_iter()))?)
}

fn render(brief: &Brief, writer: impl Write) -> Result<(), minijinja::Error> {
    template::fill(&markdown::environment()?, PAGE, brief, writer)
}

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
        verdicts: judged.map(short).collect(),
    }
}

impl Brief {
    fn new(records: &Records, drawn: &[&Subject]) -> Brief {
        let main = records.without_apart();
        let written = |table: Option<paper::Table>| Some(table?.written(Language::Markdown));
        let rankings = paper::rankings(records).into_iter().filter_map(|table| written(Some(table)));
        Brief {
            version: records.polhode.clone(),
            made_at: records.made_at.clone(),
            machine: page::machine_words(&records.machine),
            complete: records.complete,
            verdicts: survey::tally_words(&survey::tally(records.verdicts.iter())),
            scenes: records.scenes.len(),
            schemes: written(paper::schemes(&main)),
            rankings: rankings.collect(),
            orders: written(paper::orders(&main)),
            drifts: written(paper::drifts(&main)),
            reasons: reasons(records),
            pictures: drawn.iter().filter_map(|subject| picture(subject)).collect(),
        }
    }
}

fn picture(subject: &Subject) -> Option<Picture> {
    let (caption, data) = match subject {
        Subject::Overview => ("Errors against radians a step, and every measured order.", "orders.csv"),
        Subject::DriftRates => ("Drift rates of the rotational energy.", "drifts.csv"),
        Subject::Convergence(_) => ("Errors against the step in one scene under forces.", "constants.csv"),
        _ => return None,
    };
    Some(Picture { caption, file: subject.file_name(), data })
}

/// The verdicts that are not green by their reasons: known deviations by what is on record, others by their claim.
fn reasons(records: &Records) -> Vec<Reason> {
    let mut groups: BTreeMap<(Outcome, String), Vec<&Verdict>> = BTreeMap::new();
    for verdict in records.verdicts.iter().filter(|verdict| Outcome::of(verdict).needs_attention()) {
        let words = verdict.known_deviation.clone().unwrap_or_else(|| verdict.claim.word().to_owned());
        groups.entry((Outcome::of(verdict), words)).or_default().push(verdict);
    }
    let reason = |((outcome, words), group): ((Outcome, String), Vec<&Verdict>)| Reason {
        outcome: outcome.words(),
        words,
        count: group.len(),
        scenes: survey::distinct(group.iter().map(|verdict| verdict.scene.as_str())).len(),
        schemes: survey::distinct(group.iter().map(|verdict| verdict.scheme.as_str())).len(),
    };
    groups.into_iter().map(reason).collect()
}
