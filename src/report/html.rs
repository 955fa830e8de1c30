//! The report as one page of HTML that needs nothing but itself.

use minijinja::AutoEscape;

use super::page::Page;
use super::template;

const TEMPLATE: &str = include_str!("template/index.html");

/// The page as HTML.
pub(super) fn render(page: &Page) -> Result<String, minijinja::Error> {
    template::fill(&template::environment(AutoEscape::Html)?, TEMPLATE, page)
}
