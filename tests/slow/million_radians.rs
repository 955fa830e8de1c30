//! Closed forms after a million radians, against powers of what a period does.

use nalgebra::Matrix3;
use polhode::internals::reference::closed;
use polhode::internals::rotation::{self, Rotation};
use polhode::model::body::Shape;
use polhode::model::{Quantity, System};

use super::known::{CHANGE, UNITS, moved};
use super::recurrence::{Recurrence, motion, steady};
use crate::common::scene;

/// Radians that these motions turn through, at least.
const FAR: f64 = 1e6;

/// Also within 1e-6 of the separatrix, where a period takes minutes, and for a body of 26 : 1.
#[test]
fn closed_forms_hold_for_a_million_radians() {
    for (name, longest) in [
        ("free-asymmetric", 100.0),
        ("euler-top-unit", 20.0),
        ("free-oblate", 20.0),
        ("dzhanibekov", 60.0),
        ("mujoco-middle-axis", 20.0),
        ("thin-body", 0.2),
        ("near-separatrix", 150.0),
    ] {
        let system = scene(name).system;
        let recurrence = Recurrence::within(&system, longest);
        let time = (FAR / recurrence.spin()).ceil();
        let exact = recurrence.at(time);
        let apart = |other: System| apart(&system, &recurrence.moved(&other).at(time), &exact);
        let amplified = moved(&system).into_iter().map(apart).fold(0.0, f64::max) / CHANGE;
        let stated = holds(name, &system, time, &exact, amplified);
        assert!(stated < 1e3, "{name}: {stated}");
    }
}

#[test]
fn steady_rotations_hold_for_a_million_radians() {
    for name in ["free-rod", "fast-sphere", "slow-sphere"] {
        let system = scene(name).system;
        let start = motion(&system, &[0.0]).moments[0].clone();
        let time = (FAR / rotation::length(&start.snapshot().angular_velocity)).ceil();
        let exact = steady(&system, time as u64, &start);
        let stated = holds(name, &system, time, &exact, 0.0);
        assert!(stated < 1e3, "{name}: {stated}");
    }
}

/// On the separatrix a body is on its middle axis to 1e-15 after 64 s, and turns steadily from then on.
#[test]
fn the_separatrix_holds_for_a_million_radians() {
    let system = scene("exact-separatrix").system;
    let settled = motion(&system, &[64.0]).moments[0].clone();
    // The same L on a sphere of the middle moment: the same turn in the world.
    let mut sphere = system.clone();
    sphere.body.inertia = Matrix3::from_diagonal_element(2.5);
    sphere.body.points.clear();
    let count = (FAR / rotation::length(&settled.snapshot().angular_velocity)).ceil();
    let exact = steady(&sphere, count as u64, &settled);
    let stated = holds("exact-separatrix", &system, 64.0 + count, &exact, 0.0);
    // A body a rounding off turns over again and again: of a system known to f64 nothing can be said.
    assert!(stated > 1e6, "{stated}");
}

/// The angle between two orientations, or between two directions of a rod [rad].
fn apart(system: &System, a: &Rotation, b: &Rotation) -> f64 {
    match system.body.shape {
        Shape::Rod { direction } => rotation::angle_between_directions(&(a * direction), &(b * direction)),
        _ => rotation::angle_between(a, b),
    }
}

/// Asserts the error; returns the uncertainty that is stated over it, or over half a unit a radian.
fn holds(name: &str, system: &System, time: f64, exact: &Rotation, amplified: f64) -> f64 {
    let found = closed::solve(system, &[time]).expect("a closed form");
    let error = apart(system, &found.states[0].orientation, exact);
    let bound = UNITS * f64::EPSILON * (1.0 + FAR).max(amplified);
    println!("{name}: {:.2} units, amplified {:.2} a radian", UNITS * error / bound, amplified / FAR);
    let stated = found.uncertainty[0][Quantity::Orientation];
    assert!(error <= stated + 4.0 * f64::EPSILON, "{name}: {error:e} > {stated:e}");
    assert!(error <= bound, "{name}: {error:e} > {bound:e}");
    stated / error.max(0.5 * f64::EPSILON * FAR)
}
