//! The section on figures that others published: each beside what Polhode gives for it.

use std::io::Write;

use serde::Serialize;

use crate::record::{Agreement, PublishedRow, Sureness};

use super::{markdown, number, survey, template};

const PAGE: &str = include_str!("template/published_page.md");

/// The section.
#[derive(Serialize)]
pub(super) struct Section {
    figures: usize,
    numbers: usize,
    tally: Vec<Tally>,
    off: Vec<Off>,
    truncated: Vec<Off>,
    problems: Vec<ProblemView>,
}

/// How many figures have a verdict.
#[derive(Serialize)]
struct Tally {
    words: &'static str,
    count: usize,
}

/// A published figure that is off.
#[derive(Serialize)]
struct Off {
    problem: String,
    quantity: String,
    by: String,
    part: String,
    note: String,
}

/// A problem and its figures.
#[derive(Serialize)]
struct ProblemView {
    title: String,
    scene: String,
    sources: Vec<String>,
    rows: Vec<RowView>,
}

/// A figure.
#[derive(Serialize)]
struct RowView {
    quantity: String,
    published: String,
    ours: String,
    by: String,
    difference: String,
    limit: String,
    class: &'static str,
    verdict: &'static str,
    sureness: &'static str,
    note: String,
}

impl Section {
    /// `None` where the records hold no published figure.
    pub(super) fn new(rows: &[PublishedRow]) -> Option<Section> {
        let problems = survey::distinct(rows.iter().map(|row| row.problem.as_str()));
        let count = |agreement| rows.iter().filter(|row| row.agreement == agreement).count();
        let off = |truncated: bool| {
            let is_off = move |row: &&PublishedRow| row.agreement == Agreement::PublishedIsOff;
            rows.iter().filter(is_off).filter(move |row| row.truncated == truncated).map(Off::new).collect()
        };
        (!rows.is_empty()).then(|| Section {
            figures: rows.len(),
            numbers: rows.iter().map(|row| row.published.len()).sum(),
            tally: TALLY.into_iter().map(|(words, a)| Tally { words, count: count(a) }).collect(),
            off: off(false),
            truncated: off(true),
            problems: problems.into_iter().map(|problem| ProblemView::new(rows, problem)).collect(),
        })
    }
}

/// The remark where a published number is the run of a scheme.
const TRUNCATED: &str = "truncation error of that scheme at that step";

/// The verdicts in the order of the tally, in the plural.
const TALLY: [(&str, Agreement); 4] = [
    ("agree", Agreement::Agrees),
    ("were read off a figure and agree", Agreement::ReadOffAFigure),
    ("are off", Agreement::PublishedIsOff),
    ("come from another algorithm", Agreement::OtherAlgorithm),
];

fn words(agreement: Agreement) -> &'static str {
    match agreement {
        Agreement::Agrees => "agrees",
        Agreement::PublishedIsOff => "published is off",
        Agreement::OtherAlgorithm => "other algorithm",
        Agreement::ReadOffAFigure => "read off a figure, agrees",
    }
}

impl Off {
    fn new(row: &PublishedRow) -> Off {
        let sizes = row.ours.iter().map(|text| text.parse::<f64>().unwrap_or(f64::NAN).abs());
        let worst = row.difference.iter().zip(sizes).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        let (difference, size) = worst.map_or((f64::NAN, f64::NAN), |(difference, size)| (*difference, size));
        let part = difference.abs() / size;
        Off {
            problem: row.problem.clone(),
            quantity: row.quantity.clone(),
            by: number::joined(&number::significant(difference, 2), &row.unit),
            part: number::significant(part, 2),
            note: row.note.clone(),
        }
    }
}

impl ProblemView {
    fn new(rows: &[PublishedRow], problem: &str) -> ProblemView {
        let own: Vec<&PublishedRow> = rows.iter().filter(|row| row.problem == problem).collect();
        let sources = survey::distinct(own.iter().map(|row| row.source.as_str()));
        ProblemView {
            title: problem.into(),
            scene: own.first().map(|row| row.scene.clone()).unwrap_or_default(),
            rows: own.into_iter().map(RowView::new).collect(),
            sources: sources.into_iter().map(str::to_owned).collect(),
        }
    }
}

impl RowView {
    fn new(row: &PublishedRow) -> RowView {
        let list = |numbers: &[f64]| {
            let printed: Vec<String> = numbers.iter().map(|x| number::significant(*x, 2)).collect();
            printed.join(", ")
        };
        let mut limits = row.held_to.clone();
        limits.dedup();
        RowView {
            quantity: format!("{} [{}]", row.quantity, row.unit).replace(" [1]", ""),
            published: row.published.join(", "),
            ours: row.ours.join(", "),
            by: row.by.clone(),
            difference: list(&row.difference),
            limit: format!("{}: {}", list(&limits), row.limit),
            class: match row.agreement {
                Agreement::Agrees | Agreement::ReadOffAFigure => "pass",
                Agreement::PublishedIsOff => "known",
                Agreement::OtherAlgorithm => "inconclusive",
            },
            verdict: words(row.agreement),
            sureness: match row.sureness {
                Sureness::A => "A",
                Sureness::B => "B",
                Sureness::C => "C",
            },
            note: if row.truncated { TRUNCATED.to_owned() } else { row.note.clone() },
        }
    }
}

#[derive(Serialize)]
struct Page {
    published: Option<Section>,
}

/// Writes the section as a separate page, in Markdown: `references/PUBLISHED.md`.
///
/// # Errors
/// The page cannot be composed or written.
pub fn write_published(rows: &[PublishedRow], writer: impl Write) -> Result<(), minijinja::Error> {
    template::fill(&markdown::environment()?, PAGE, &Page { published: Section::new(rows) }, writer)
}
