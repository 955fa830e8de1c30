//! The scheme itself in 50-digit arithmetic (references/golden_steps.json): 1 and 16 steps of either scheme.

use nalgebra::Vector3;
use polhode::model::{Snapshot, System};
use polhode::simulate::{Form, Plan};
use serde_json::Value;

use crate::common::{contestant, scene};

/// The golden steps are met to this, relative to the larger of 1 and the number.
const BOUND: f64 = 1e-13;

fn number(value: &Value) -> f64 {
    value.as_str().expect("a string of digits").parse().expect("a number")
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

fn largest_difference(system: &System, state: &Snapshot, golden: &Value) -> f64 {
    let apart = |a: Vector3<f64>, b: Vector3<f64>| (a - b).amax() / b.amax().max(1.0);
    let mut largest = apart(state.angular_momentum, vector(&golden["L"]))
        .max(apart(state.angular_velocity, vector(&golden["W"])));
    if !system.body.pivoted {
        largest = largest
            .max(apart(state.position, vector(&golden["X_cm"])))
            .max(apart(state.velocity, vector(&golden["U_cm"])));
    }
    let points = golden["Xt"].as_array().expect("points");
    assert_eq!(points.len(), system.body.points.len());
    for (point, golden) in system.body.points.iter().zip(points) {
        largest = largest.max(apart(state.orientation * point.position, vector(golden)));
    }
    largest
}

#[test]
fn both_forms_of_both_schemes_meet_the_golden_steps() {
    let golden: Value =
        serde_json::from_str(include_str!("../../references/golden_steps.json")).expect("JSON");
    let scenes = golden["scenes"].as_object().expect("scenes");
    let mut compared = 0;
    for (name, entry) in scenes {
        let scene = scene(name);
        let step = entry["h"].as_f64().expect("a step");
        for run in entry["runs"].as_array().expect("runs") {
            let scheme = if run["scheme"] == "peskin" { "peskin-rk2" } else { "euler" };
            let contestant = contestant(scheme);
            let steps = run["steps"].as_u64().expect("steps");
            for form in [Form::Points, Form::Least] {
                let plan = Plan { step, steps, every: steps };
                let end = *contestant.run(&scene.system, form, &plan).states.last().expect("a state");
                let difference = largest_difference(&scene.system, &end, run);
                assert!(difference < BOUND, "{name}, {scheme}, {steps} steps, {form:?}: {difference:e}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 6 * 4 * 2);
}
