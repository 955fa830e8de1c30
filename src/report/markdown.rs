//! The report in Markdown: what was found, and tables with a row a scene or a scheme. What a table of them would repeat stands on the pages and in the
//! records.

use std::io::Write;

use minijinja::{AutoEscape, Environment};
use serde::Serialize;

use crate::record::Records;

use super::page::{Figure, Page};
use super::paper::{self, Language};
use super::plot::{Subject, key_subjects};
use super::template;

const TEMPLATE: &str = include_str!("template/report.md");
const ENGINES: &str = include_str!("template/engines.md");
const PUBLISHED: &str = include_str!("template/published.md");

/// What the template reads.
#[derive(Serialize)]
pub(super) struct Text<'a> {
    page: &'a Page,
    /// Whether the pages of the report and its costs stand beside it.
    whole: bool,
    /// Files with the data.
    data: Vec<&'static str>,
    main_schemes: usize,
    schemes: Option<String>,
    rankings: Vec<String>,
    orders: Option<String>,
    drifts: Option<String>,
    pictures: Vec<Picture>,
}

#[derive(Serialize)]
struct Picture {
    caption: &'static str,
    file: String,
    data: &'static str,
}

impl<'a> Text<'a> {
    /// The page of a repository: without pages, costs and engines. `main` is the records without the schemes that stand apart.
    pub(super) fn new(records: &Records, main: &Records, page: &'a Page, figures: &[Figure]) -> Text<'a> {
        let written = |table: Option<paper::Table>| Some(table?.written(Language::Markdown));
        let rankings = paper::rankings(records).into_iter().filter_map(|table| written(Some(table)));
        let is_drawn = |subject: &Subject| figures.iter().any(|figure| figure.subject == *subject);
        Text {
            page,
            whole: false,
            data: Vec::new(),
            main_schemes: main.schemes.len(),
            schemes: written(paper::schemes(main)),
            rankings: rankings.collect(),
            orders: written(paper::orders(main)),
            drifts: written(paper::drifts(main)),
            pictures: key_subjects(records).iter().filter(|one| is_drawn(one)).filter_map(picture).collect(),
        }
    }

    /// With links to these files.
    pub(super) fn with_data(self, files: impl IntoIterator<Item = &'static str>) -> Text<'a> {
        Text { data: files.into_iter().collect(), ..self }
    }

    /// The page beside all others of a report.
    pub(super) fn whole(self) -> Text<'a> {
        Text { whole: true, ..self }
    }

    /// Writes it.
    pub(super) fn render(&self, writer: impl Write) -> Result<(), minijinja::Error> {
        template::fill(&environment()?, TEMPLATE, self, writer)
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

/// Of every page in Markdown: the filter for cells, and the sections on engines and on published figures.
pub(super) fn environment() -> Result<Environment<'static>, minijinja::Error> {
    let mut environment = template::environment(AutoEscape::None)?;
    environment.add_filter("cell", |text: String| cell(&text));
    environment.add_template("engines.md", ENGINES)?;
    environment.add_template("published.md", PUBLISHED)?;
    Ok(environment)
}

/// A text that cannot leave its cell of a table nor start a tag.
pub(super) fn cell(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    lines.join(" ").replace('\\', "\\\\").replace('|', "\\|").replace('<', "&lt;")
}
