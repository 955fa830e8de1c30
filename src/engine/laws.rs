//! Force laws in the protocol of engines: the keys of a scene file, every default filled in, places on the body
//! about its centre of mass.

use nalgebra::Vector3;
use serde_json::{Map, Value, json};

use crate::model::forces::{Argument, Attachment, Law};
use crate::scenes;

/// A law of a body whose centre of mass is at `center` from its origin, body axes.
pub(super) fn describe(law: &Law, center: &Vector3<f64>) -> Value {
    let mut object = Map::new();
    object.insert("law".to_owned(), json!(law.name()));
    for (parameter, argument) in law.arguments() {
        let argument = match argument {
            Argument::Attachment(Attachment::At(place)) => {
                Argument::Attachment(Attachment::At(place - center))
            }
            other => other,
        };
        object.insert(parameter.key_of(&argument).to_owned(), scenes::to_json(&argument));
    }
    Value::Object(object)
}
