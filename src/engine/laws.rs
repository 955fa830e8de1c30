//! Force laws as an engine is told them: the keys of a scene file, every default filled in, places on the body
//! about its centre of mass.

use nalgebra::Vector3;
use serde_json::{Value, json};

use crate::model::forces::{Attachment, Law, PerPoint, TorqueAxes};

/// A vector as a list.
pub(super) fn vector(v: &Vector3<f64>) -> Value {
    json!([v.x, v.y, v.z])
}

fn per_point(values: &PerPoint) -> Value {
    match values {
        PerPoint::Same(value) => json!(value),
        PerPoint::Each(values) => json!(values),
    }
}

/// A law of a body whose centre of mass is at `center` from its origin, body axes.
pub(super) fn describe(law: &Law, center: &Vector3<f64>) -> Value {
    let mut told = parameters(law);
    told["law"] = json!(law.name());
    if let Law::Spring(spring) = law {
        match &spring.attachment {
            Attachment::Point(index) => told["point"] = json!(index),
            Attachment::At(place) => told["at"] = vector(&(place - center)),
        }
    }
    told
}

fn parameters(law: &Law) -> Value {
    match law {
        Law::Gravity(law) => json!({"acceleration": vector(&law.acceleration)}),
        Law::Spring(law) => json!({
            "anchor": vector(&law.anchor), "stiffness": law.stiffness, "damping": law.damping,
            "rest_length": law.rest_length,
        }),
        Law::Drag(law) => json!({"coefficient": per_point(&law.coefficient)}),
        Law::CentralGravity(law) => json!({"mu": law.mu, "center": vector(&law.center)}),
        Law::Lorentz(law) => json!({
            "charge": per_point(&law.charge), "electric": vector(&law.electric),
            "electric_cosine": vector(&law.electric_cosine), "electric_sine": vector(&law.electric_sine),
            "frequency": law.frequency, "magnetic": vector(&law.magnetic),
        }),
        Law::Torque(law) => json!({
            "axes": if law.axes == TorqueAxes::Body { "body" } else { "world" },
            "constant": vector(&law.constant), "cosine": vector(&law.cosine), "sine": vector(&law.sine),
            "frequency": law.frequency,
        }),
        Law::Dipole(law) => json!({"moment": vector(&law.moment), "field": vector(&law.field)}),
        Law::GravityGradient(law) => json!({
            "mu_over_r3": law.mu_over_r3, "direction": vector(&law.direction),
            "normal": vector(&law.normal), "rate": law.rate,
        }),
        Law::Ground(law) => json!({
            "normal": vector(&law.normal), "height": law.height, "stiffness": law.stiffness,
            "damping": law.damping, "friction": law.friction, "slip_velocity": law.slip_velocity,
        }),
    }
}
