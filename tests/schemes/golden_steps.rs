//! The scheme itself in 50-digit arithmetic (references/golden_steps.json): 1 and 16 steps of either scheme.

use nalgebra::Vector3;
use polhode::internals::arithmetic::{DoubleDouble, Real, Single};
use polhode::model::{Snapshot, System};
use polhode::simulate::{Arithmetic, Form, Plan};
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

/// A number of fifty digits, in the arithmetic.
fn digits<T: Real>(value: &Value) -> T {
    let text = value.as_str().expect("a string of digits");
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (negative, mantissa) = mantissa.strip_prefix('-').map_or((false, mantissa), |rest| (true, rest));
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len() as i32);
    let digits = mantissa.chars().filter_map(|c| c.to_digit(10)).take(40);
    let taken = mantissa.chars().filter(char::is_ascii_digit).count().saturating_sub(40) as i32;
    let whole = digits.fold(T::of(0.0), |sum, digit| sum * 10.0 + f64::from(digit));
    let power = exponent.parse::<i32>().expect("an exponent") - places + taken;
    let scale = nalgebra::ComplexField::powi(T::of(10.0), power.abs());
    let size = if power < 0 { whole / scale } else { whole * scale };
    if negative { -size } else { size }
}

/// Largest difference from the golden numbers in an arithmetic, relative to the larger of 1 and the number.
fn difference_in<T: Arithmetic>(system: &System<T>, state: &Snapshot<T>, golden: &Value) -> f64 {
    let apart = |a: Vector3<T>, golden: &Value| {
        let b = Vector3::from([0, 1, 2].map(|i| digits::<T>(&golden[i])));
        ((a - b).amax() / b.amax().max(T::of(1.0))).to_f64()
    };
    let mut largest =
        apart(state.angular_momentum, &golden["L"]).max(apart(state.angular_velocity, &golden["W"]));
    if !system.body.pivoted {
        largest =
            largest.max(apart(state.position, &golden["X_cm"])).max(apart(state.velocity, &golden["U_cm"]));
    }
    for (point, golden) in system.body.points.iter().zip(golden["Xt"].as_array().expect("points")) {
        largest = largest.max(apart(state.orientation * point.position, golden));
    }
    largest
}

/// Both forms of both schemes in every golden scene, in one arithmetic: the largest difference, and how many runs were compared.
fn worst_in<T: Arithmetic>() -> (f64, u32) {
    let golden: Value =
        serde_json::from_str(include_str!("../../references/golden_steps.json")).expect("JSON");
    let (mut worst, mut compared) = (0.0f64, 0);
    for (name, entry) in golden["scenes"].as_object().expect("scenes") {
        let system = System::<T>::of(&scene(name).system).expect("a system");
        let step = entry["h"].as_f64().expect("a step");
        for run in entry["runs"].as_array().expect("runs") {
            let contestant = contestant(if run["scheme"] == "peskin" { "peskin-rk2" } else { "euler" });
            let steps = run["steps"].as_u64().expect("steps");
            for form in [Form::Points, Form::Least] {
                let mut end = None;
                let plan = Plan { step, steps, every: steps };
                let outcome = contestant.stream_in(&system, form, &plan, &mut |state| end = Some(*state));
                assert_eq!(outcome.broken, None);
                let difference = difference_in(&system, &end.expect("a state"), run);
                println!(
                    "{}: {name}, {}, {steps} steps, {form:?}: {difference:e}",
                    T::NAME,
                    contestant.card.name
                );
                worst = worst.max(difference);
                compared += 1;
            }
        }
    }
    (worst, compared)
}

#[test]
fn double_double_meets_the_golden_steps_to_28_digits() {
    let (worst, compared) = worst_in::<DoubleDouble>();
    assert!(worst < 1e-28 && worst > 0.0, "{worst:e}");
    assert_eq!(compared, 6 * 4 * 2);
}

#[test]
fn single_precision_meets_the_golden_steps_to_a_few_of_its_units() {
    let (worst, compared) = worst_in::<Single>();
    // Two units a step, of sixteen.
    assert!(worst < 32.0 * Single::UNIT && worst > 0.01 * Single::UNIT, "{worst:e}");
    assert_eq!(compared, 6 * 4 * 2);
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
