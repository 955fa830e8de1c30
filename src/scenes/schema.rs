//! The format of a scene file as a JSON Schema, draft 7, for editors that complete and check TOML.
//!
//! The tables of the laws come from their parameters; a test holds `references/scene.schema.json` to what is made here.

use serde_json::{Map, Value, json};

use crate::model::forces::{Argument, Attachment, Described, Kind, Law, Parameter, PerPoint, TorqueAxes};

/// The title by which a schema of this program is known.
pub(crate) const SCHEMA_TITLE: &str = "A scene of Polhode";

/// The schema of a scene file.
pub fn schema() -> Value {
    let reason = json!({"type": "string", "pattern": "\\S"});
    let laws: Vec<Value> =
        Law::ALL.iter().map(|law| json!({"$ref": format!("#/definitions/{}", law.name)})).collect();
    let mut definitions: Map<String, Value> =
        Law::ALL.iter().map(|law| (law.name.to_owned(), of_law(law))).collect();
    definitions.insert("vector".to_owned(), numbers(3));
    json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": SCHEMA_TITLE,
        "type": "object",
        "additionalProperties": false,
        "required": ["name", "duration", "body"],
        "properties": {
            "name": {"type": "string", "pattern": "^[a-z0-9]+(-[a-z0-9]+)*$", "maxLength": 100},
            "title": {"type": "string", "description": "one line for the report"},
            "why": {"type": "string", "description": "what the scene shows that others do not"},
            "duration": {"type": "number", "exclusiveMinimum": 0, "description": "s"},
            "not_for_order": reason,
            "only_for_stability": reason,
            "body": body(),
            "initial": initial(),
            "forces": {"type": "array", "items": {"oneOf": laws}},
        },
        "definitions": definitions,
    })
}

fn numbers(count: usize) -> Value {
    json!({"type": "array", "items": {"type": "number"}, "minItems": count, "maxItems": count})
}

fn described(mut value: Value, description: &str) -> Value {
    value["description"] = json!(description);
    value
}

/// A vector; a reference may have no neighbours, hence the list of one.
fn vector(description: &str) -> Value {
    json!({"allOf": [{"$ref": "#/definitions/vector"}], "description": description})
}

/// Three numbers on the diagonal, or three rows.
fn matrix(description: &str) -> Value {
    let rows =
        json!({"type": "array", "items": {"$ref": "#/definitions/vector"}, "minItems": 3, "maxItems": 3});
    json!({"oneOf": [{"$ref": "#/definitions/vector"}, rows], "description": description})
}

fn body() -> Value {
    let mass = json!({"type": "number", "exclusiveMinimum": 0, "description": "kg"});
    let point = json!({
        "type": "object",
        "additionalProperties": false,
        "required": ["mass", "position"],
        "properties": {"mass": mass, "position": vector("m; body axes, in any frame")},
    });
    json!({
        "type": "object",
        "additionalProperties": false,
        "oneOf": [
            {"required": ["points"], "not": {"anyOf": [{"required": ["mass"]}, {"required": ["unphysical_inertia"]}]}},
            {"required": ["mass", "inertia"], "not": {"required": ["massless"]}},
        ],
        "properties": {
            "points": {"type": "array", "items": point, "minItems": 1},
            "massless": {"type": "array", "items": {"$ref": "#/definitions/vector"}, "minItems": 1,
                "description": "m; points that carry forces alone, in the frame of the points, counted on after them"},
            "mass": mass,
            "inertia": matrix("kg m²; principal moments or three rows, about the centre of mass, body axes"),
            "unphysical_inertia": {
                "type": "boolean",
                "description": "admits moments that no positive masses have",
            },
            "pivot": vector("m; a point fixed in the world, in the frame of the points"),
        },
    })
}

fn initial() -> Value {
    let euler = json!({
        "type": "object",
        "additionalProperties": false,
        "required": ["euler", "sequence", "unit"],
        "properties": {
            "euler": vector("three angles, one after the other"),
            "sequence": {"type": "string", "pattern": "^[xyz]{3}$", "description": "the axis of each"},
            "axes": {"enum": TorqueAxes::ALL.map(TorqueAxes::word), "default": "body",
                "description": "axes of the body turn along, axes of the world stay"},
            "unit": {"enum": ["deg", "rad"]},
        },
    });
    let quaternion = described(numbers(4), "w, x, y, z; a unit quaternion");
    let pairs = |[a, b]: [&str; 2]| json!({"required": [a, b]});
    let spins = [
        ["angular_velocity", "angular_momentum"],
        ["angular_velocity", "angular_velocity_body"],
        ["angular_velocity_body", "angular_momentum"],
    ];
    json!({
        "type": "object",
        "additionalProperties": false,
        "not": {"anyOf": spins.map(pairs)},
        "properties": {
            "position": vector("m; the centre of mass, world"),
            "orientation": {"oneOf": [quaternion, euler], "description": "takes body axes to world axes"},
            "velocity": vector("m/s; of the centre of mass, world"),
            "angular_velocity": vector("rad/s; world"),
            "angular_velocity_body": vector("rad/s; body axes"),
            "angular_momentum": vector("kg m²/s; world, about the centre of mass or the pivot"),
        },
    })
}

fn of_law(law: &Described) -> Value {
    let mut properties = Map::new();
    properties.insert("law".to_owned(), json!({"const": law.name}));
    let mut required = vec!["law"];
    let mut rest = Map::new();
    for parameter in law.parameters {
        if let [first, second] = parameter.keys() {
            rest.insert("oneOf".to_owned(), json!([{"required": [first]}, {"required": [second]}]));
        } else if parameter.default.is_none() {
            required.push(parameter.key);
        }
        for key in parameter.keys() {
            properties.insert((*key).to_owned(), of_parameter(parameter, key));
        }
    }
    let mut object = json!({
        "type": "object",
        "description": law.formula,
        "additionalProperties": false,
        "required": required,
        "properties": properties,
    });
    if let Some(object) = object.as_object_mut() {
        object.append(&mut rest);
    }
    object
}

fn of_parameter(parameter: &Parameter, key: &str) -> Value {
    let description = format!("{} [{}]", parameter.what, parameter.unit);
    let mut value = match parameter.kind {
        Kind::Number => described(json!({"type": "number"}), &description),
        Kind::Vector => vector(&description),
        Kind::Matrix => matrix(&description),
        Kind::PerPoint => {
            let list = json!({"type": "array", "items": {"type": "number"}, "minItems": 1});
            described(json!({"oneOf": [{"type": "number"}, list]}), &description)
        }
        Kind::Attachment if key == Parameter::PLACES[0] => {
            described(json!({"type": "integer", "minimum": 0}), "a mass point, counted from 0")
        }
        Kind::Attachment => vector("m; any place, in the frame of the points"),
        Kind::Axes => json!({"enum": TorqueAxes::ALL.map(TorqueAxes::word), "description": parameter.what}),
    };
    if let Some(default) = &parameter.default {
        value["default"] = to_json(default);
    }
    if parameter.key_of(&parameter.example) == key {
        value["examples"] = json!([to_json(&parameter.example)]);
    }
    value
}

/// An argument as JSON.
pub(crate) fn to_json(argument: &Argument) -> Value {
    match argument {
        Argument::Number(value) | Argument::PerPoint(PerPoint::Same(value)) => json!(value),
        Argument::PerPoint(PerPoint::Each(values)) => json!(values),
        Argument::Matrix(m) => {
            json!([0, 1, 2].map(|i| [m[(i, 0)], m[(i, 1)], m[(i, 2)]]))
        }
        Argument::Vector(v) | Argument::Attachment(Attachment::At(v)) => json!([v.x, v.y, v.z]),
        Argument::Attachment(Attachment::Point(index)) => json!(index),
        Argument::Axes(axes) => json!(axes.word()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{KEYS, body, start};

    #[test]
    fn every_key_of_the_format_is_in_the_schema_and_no_other() {
        let schema = schema();
        let tables = [("", KEYS), ("/properties/body", body::KEYS), ("/properties/initial", start::KEYS)];
        for (place, keys) in tables {
            let found = &schema.pointer(place).expect("a table")["properties"];
            let found: Vec<&str> =
                found.as_object().expect("properties").keys().map(String::as_str).collect();
            let mut expected = keys.to_vec();
            expected.sort_unstable();
            assert_eq!(found, expected, "{place}");
        }
    }
}
