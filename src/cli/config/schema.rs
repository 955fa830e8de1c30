//! `polhode.toml` as a JSON Schema, draft 7, from the tables of its keys.

use serde_json::{Map, Value, json};

use super::keys::{Form, Key, Kind, SECTIONS, Section};
use crate::model::Quantity;

/// The schema of the file.
pub(in crate::cli) fn schema() -> Value {
    let mut properties = Map::new();
    for section in SECTIONS {
        match section.form {
            Form::Top => properties.extend(keys(section)),
            Form::One | Form::Named => {
                properties.insert(section.name.to_owned(), table(section));
            }
            Form::Many => {
                let list = json!({"type": "array", "items": table(section)});
                properties.insert(section.name.to_owned(), list);
            }
        }
    }
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Settings of Polhode",
        "type": "object",
        "additionalProperties": false,
        "properties": properties,
    })
}

fn table(section: &Section) -> Value {
    if section.form == Form::Named {
        let each = section.keys.first().map_or(Value::Bool(true), of_key);
        return json!({"type": "object", "description": section.what, "additionalProperties": each});
    }
    json!({
        "type": "object",
        "description": section.what,
        "additionalProperties": false,
        "properties": keys(section),
    })
}

fn keys(section: &Section) -> Map<String, Value> {
    section.keys.iter().map(|key| (key.name.to_owned(), of_key(key))).collect()
}

fn of_key(key: &Key) -> Value {
    let mut value = match key.kind {
        Kind::Texts => json!({"type": "array", "items": {"type": "string", "minLength": 1}, "minItems": 1}),
        Kind::Text => json!({"type": "string", "minLength": 1}),
        Kind::Quantity => json!({"enum": Quantity::ALL.map(Quantity::name)}),
        Kind::Positive => json!({"type": "number", "exclusiveMinimum": 0}),
        Kind::Order => json!({"type": "integer", "minimum": 1, "maximum": 12}),
        Kind::Steps => {
            json!({"enum": super::read::STEPS.collect::<Vec<u32>>().iter().map(|power| 1u64 << power).collect::<Vec<u64>>()})
        }
    };
    value["description"] = json!(key.what);
    value
}
