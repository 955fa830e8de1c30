//! The report as Markdown, with the pictures beside it.

use minijinja::AutoEscape;

use super::page::Page;
use super::template;

const TEMPLATE: &str = include_str!("template/report.md");

/// The page as Markdown.
pub(super) fn render(page: &Page) -> Result<String, minijinja::Error> {
    let mut environment = template::environment(AutoEscape::None)?;
    environment.add_filter("cell", |text: String| cell(&text));
    template::fill(&environment, TEMPLATE, page)
}

/// A text that cannot leave its cell of a table nor start a tag.
fn cell(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    lines.join(" ").replace('\\', "\\\\").replace('|', "\\|").replace('<', "&lt;")
}
