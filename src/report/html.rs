//! The report as one page of HTML that needs nothing but itself.

use std::io::Write;

use minijinja::AutoEscape;

use super::page::Page;
use super::template;

const TEMPLATE: &str = include_str!("template/index.html");
const ENGINES: &str = include_str!("template/engines.html");
const PUBLISHED: &str = include_str!("template/published.html");

/// Writes the page as HTML.
pub(super) fn render(page: &Page, writer: impl Write) -> Result<(), minijinja::Error> {
    let mut environment = template::environment(AutoEscape::Html)?;
    environment.add_template("engines.html", ENGINES)?;
    environment.add_template("published.html", PUBLISHED)?;
    template::fill(&environment, TEMPLATE, page, writer)
}
