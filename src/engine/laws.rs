//! Force laws in the protocol of engines: the keys of a scene file, every default filled in, places on the body
//! about its centre of mass.

use nalgebra::Vector3;
use serde_json::{Map, Value, json};

use crate::model::forces::{Argument, Attachment, Law, PerPoint};

/// A vector as a list.
pub(super) fn vector(v: &Vector3<f64>) -> Value {
    json!([v.x, v.y, v.z])
}

/// A law of a body whose centre of mass is at `center` from its origin, body axes.
pub(super) fn describe(law: &Law, center: &Vector3<f64>) -> Value {
    let mut object = Map::new();
    object.insert("law".to_owned(), json!(law.name()));
    for (parameter, argument) in law.arguments() {
        let value = match &argument {
            Argument::Number(value) | Argument::PerPoint(PerPoint::Same(value)) => json!(value),
            Argument::PerPoint(PerPoint::Each(values)) => json!(values),
            Argument::Vector(v) => vector(v),
            Argument::Attachment(Attachment::Point(index)) => json!(index),
            Argument::Attachment(Attachment::At(place)) => vector(&(place - center)),
            Argument::Axes(axes) => json!(axes.word()),
        };
        object.insert(parameter.key_of(&argument).to_owned(), value);
    }
    Value::Object(object)
}
