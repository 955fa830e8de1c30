//! Filling a template with the page.

use std::collections::BTreeMap;

use minijinja::syntax::SyntaxConfig;
use minijinja::{AutoEscape, Environment, Error, ErrorKind, Value};
use serde::Serialize;

/// An environment whose block tags leave no empty lines behind.
pub(super) fn environment(escape: AutoEscape) -> Result<Environment<'static>, Error> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(move |_| escape.clone());
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    Ok(environment)
}

/// Fills a template with the page.
pub(super) fn fill(
    environment: &Environment,
    template: &str,
    page: &impl Serialize,
) -> Result<String, Error> {
    let json = serde_json::to_value(page).map_err(|error| {
        Error::new(ErrorKind::InvalidOperation, "the page is not plain").with_source(error)
    })?;
    environment.template_from_str(template)?.render(value(json))
}

/// The template engine's form of a JSON value.
fn value(json: serde_json::Value) -> Value {
    match json {
        serde_json::Value::Null => Value::from(()),
        serde_json::Value::Bool(truth) => Value::from(truth),
        serde_json::Value::Number(number) => match number.as_i64() {
            Some(whole) => Value::from(whole),
            None => Value::from(number.as_f64().unwrap_or(f64::NAN)),
        },
        serde_json::Value::String(text) => Value::from(text),
        serde_json::Value::Array(items) => items.into_iter().map(value).collect(),
        serde_json::Value::Object(fields) => Value::from(
            fields.into_iter().map(|(key, field)| (key, value(field))).collect::<BTreeMap<_, _>>(),
        ),
    }
}
