//! The report as Markdown, with the pictures beside it.

use std::io::Write;

use minijinja::{AutoEscape, Environment};

use super::page::Page;
use super::template;

const TEMPLATE: &str = include_str!("template/report.md");
const ENGINES: &str = include_str!("template/engines.md");
const PUBLISHED: &str = include_str!("template/published.md");

/// Writes the page as Markdown.
pub(super) fn render(page: &Page, writer: impl Write) -> Result<(), minijinja::Error> {
    template::fill(&environment()?, TEMPLATE, page, writer)
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
