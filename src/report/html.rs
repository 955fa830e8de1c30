//! The report as one page of HTML that needs nothing but itself.

use minijinja::AutoEscape;

use super::page::Page;
use super::template;

const TEMPLATE: &str = include_str!("template/index.html");
const ENGINES: &str = include_str!("template/engines.html");

/// The page as HTML.
pub(super) fn render(page: &Page) -> Result<String, minijinja::Error> {
    let mut environment = template::environment(AutoEscape::Html)?;
    environment.add_template("engines.html", ENGINES)?;
    template::fill(&environment, TEMPLATE, page)
}
