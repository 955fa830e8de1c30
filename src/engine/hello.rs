//! What an engine says of itself.

use serde::Deserialize;

use super::error::Fault;
use super::reply;
use crate::model::System;
use crate::model::forces::Law;
use crate::simulate::Program;

/// Longest hello [bytes].
pub(super) const MOST_BYTES: usize = 1 << 20;
/// Highest order that is believed to be meant.
const HIGHEST_ORDER: u32 = 64;

/// The reply to hello.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(super) struct Hello {
    /// Version of the protocol.
    polhode: u32,
    /// Name of the program.
    pub name: String,
    #[serde(default)]
    version: serde_json::Value,
    #[serde(default)]
    scheme: Option<String>,
    /// Claimed order; none where it claims none.
    #[serde(default)]
    pub order: Option<u32>,
    /// Laws that it takes; where it has no list, it is asked and may refuse.
    #[serde(default)]
    pub forces: Option<Vec<String>>,
    /// `single` or `double`; what it says is believed, what it does not say is seen.
    #[serde(default)]
    precision: Option<String>,
}

impl Hello {
    /// Name, version and scheme in one line.
    pub fn title(&self) -> String {
        let Program { name, version, integrator, .. } = self.program();
        let after = |mark: &str, text: String| if text.is_empty() { text } else { format!("{mark}{text}") };
        format!("{name}{}{}", after(" ", version), after(", ", integrator))
    }

    /// Who it is.
    pub fn program(&self) -> Program {
        let version = match &self.version {
            serde_json::Value::Null => String::new(),
            serde_json::Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        let integrator = self.scheme.clone().unwrap_or_default();
        Program {
            name: self.name.clone(),
            version,
            integrator,
            single_precision: self.single_precision(),
            ..Program::default()
        }
    }

    /// Whether it says that it computes in single precision.
    pub fn single_precision(&self) -> bool {
        self.precision.as_deref() == Some("single")
    }
}

pub(super) fn read(line: &[u8]) -> Result<Hello, Fault> {
    let hello: Hello = reply::object(line)?;
    let against = |why: String| Err(Fault::Protocol(format!("hello: {why}")));
    if hello.polhode != 1 {
        return against(format!("\"polhode\" is {}, and this version speaks 1", hello.polhode));
    }
    if hello.name.trim().is_empty() {
        return against("\"name\" is empty: write the program's name".to_owned());
    }
    if hello.order.is_some_and(|order| order == 0 || order > HIGHEST_ORDER) {
        let order = hello.order.unwrap_or_default();
        return against(format!("\"order\" is {order}: write a whole number from 1 on, or leave it out"));
    }
    match hello.precision.as_deref() {
        None | Some("single" | "double") => Ok(hello),
        Some(other) => {
            against(format!("\"precision\" is '{other}': write single or double, or leave it out"))
        }
    }
}

/// Why an engine with this list of laws cannot take a scene.
pub(super) fn refusal(takes: Option<&[String]>, system: &System) -> Option<String> {
    let takes = takes?;
    let missing = |law: &&Law| !takes.iter().any(|name| name == law.name());
    let law = system.forces.laws().iter().find(missing)?;
    Some(format!("the engine does not list the law '{}'", law.name()))
}
