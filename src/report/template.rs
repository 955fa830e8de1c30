//! Filling a template with the page.

use std::io::Write;

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, Error, Value};
use serde::Serialize;

/// An environment whose block tags leave no empty lines behind.
pub(super) fn environment(escape: AutoEscape) -> Result<Environment<'static>, Error> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(move |_| escape.clone());
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    Ok(environment)
}

/// Fills a template with the page and writes it piece by piece.
pub(super) fn fill(
    environment: &Environment,
    template: &str,
    page: &impl Serialize,
    writer: impl Write,
) -> Result<(), Error> {
    let page = Value::from(Serde(page));
    environment.template_from_str(template)?.render_captured_to(page, writer)?;
    Ok(())
}
