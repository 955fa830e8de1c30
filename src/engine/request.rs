//! What an engine is asked, one JSON object a line.
//!
//! A body is given about its centre of mass in body axes, wherever its scene has its origin; all else is in
//! world axes.

use nalgebra::{Matrix3, Vector3};
use serde_json::{Value, json};

use super::laws;
use crate::model::System;
use crate::model::body::{self, Body, MassPoint};
use crate::simulate::Plan;

pub(super) fn hello() -> Value {
    json!({"polhode": 1, "ask": "hello"})
}

pub(super) fn bye() -> Value {
    json!({"polhode": 1, "ask": "bye"})
}

/// A run of `system` by `plan`.
pub(super) fn run(id: u64, system: &System, plan: &Plan) -> Value {
    let (body, start) = (&system.body, &system.start);
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = start.orientation * (body.inverse_inertia() * momentum);
    let q = start.orientation;
    let points: Vec<Value> =
        points(body).iter().map(|p| json!({"mass": p.mass, "position": p.position.as_slice()})).collect();
    json!({
        "polhode": 1,
        "ask": "run",
        "id": id,
        "body": {"mass": body.mass, "inertia": rows(&inertia(body)), "points": points},
        "pivot": body.pivoted.then(|| json!((-body.center).as_slice())),
        "initial": {
            "position": start.position.as_slice(),
            "orientation": [q.w, q.i, q.j, q.k],
            "velocity": start.velocity.as_slice(),
            "angular_velocity": spin.as_slice(),
        },
        "forces": system.forces.laws().iter().map(|law| laws::describe(law, &body.center)).collect::<Vec<_>>(),
        "step": plan.step,
        "steps": plan.steps,
        "every": plan.every.max(1),
    })
}

/// The mass points about the centre of mass.
fn points(body: &Body) -> Vec<MassPoint> {
    body.points.iter().map(|p| MassPoint { mass: p.mass, position: p.position - body.center }).collect()
}

/// The inertia about the centre of mass [kg m²]: from the points where a pivot has moved it, so that the
/// parallel-axis term does not cancel.
fn inertia(body: &Body) -> Matrix3<f64> {
    let moved = body.center != Vector3::zeros();
    match moved {
        false => body.inertia,
        true if body.points.is_empty() => {
            body.inertia - body::second_moment_inertia(&body.center) * body.mass
        }
        true => body::inertia_of(&points(body)),
    }
}

fn rows(matrix: &Matrix3<f64>) -> Value {
    let row = |i: usize| [matrix[(i, 0)], matrix[(i, 1)], matrix[(i, 2)]];
    json!([row(0), row(1), row(2)])
}
