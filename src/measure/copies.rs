//! Rounding: how far copies of a run end from it.
//!
//! A copy starts a few units in the last place off, its mass points too: after the first step every rounding of it is another
//! one (stochastic arithmetic; Vignes' CESTAC is the published ancestor). What a copy differs by is rounding, however it grows. Every gate that
//! needs a rounding asks here.

use nalgebra::Vector3;

use super::order::CLEAR;
use crate::model::{PerQuantity, Quantity, Snapshot, Start, System, difference, retold};
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Copies of every run.
pub const COPIES: usize = 3;
/// Units in the last place that a copy is off by.
const OFF: f64 = 4.0;

/// Starts of the copies of a run. `motion` says how large everything gets, `unit` is one in the last place of the arithmetic; where the body
/// is `retold`, its mass points are moved too.
pub fn starts(system: &System, motion: &[Snapshot], unit: f64, retold: bool) -> [System; COPIES] {
    std::array::from_fn(|way| {
        let body = if retold { retold::moved(system, OFF * unit, way) } else { None };
        displaced(body.as_ref().unwrap_or(system), motion, way, OFF * unit)
    })
}

/// The largest distance of any copy from a run, at the end and on the way; NaN where a copy breaks.
pub fn spread(
    contestant: &Contestant,
    (system, form): (&System, Form),
    plan: &Plan,
    own: &[Snapshot],
) -> PerQuantity<f64> {
    let starts = starts(system, own, f64::EPSILON, true);
    starts.iter().fold(PerQuantity::all(0.0), |largest, start| {
        let copy = contestant.run(start, form, plan).states;
        let pairs = copy.iter().zip(own).map(|(a, b)| difference(&system.body, a, b));
        let furthest = pairs.fold(largest, PerQuantity::max);
        if copy.len() == own.len() { furthest } else { PerQuantity::all(f64::NAN) }
    })
}

/// The rounding of a run of so many steps: the spread of its copies, and a rounding of the size of each quantity for each step at least.
pub fn rounding(spread: &PerQuantity<f64>, sizes: &PerQuantity<f64>, steps: u64) -> PerQuantity<f64> {
    let of_steps = f64::EPSILON * steps as f64 / CLEAR;
    PerQuantity::of(|quantity| super::larger(spread[quantity], of_steps * sizes[quantity]))
}

/// Size of each quantity over a motion.
pub fn sizes(system: &System, motion: &[Snapshot]) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    let (position, spin) =
        (largest(|s| rotation::length(&s.position)), largest(|s| rotation::length(&s.angular_velocity)));
    let extent = system.body.extent();
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => position + extent,
        Quantity::Velocity => {
            largest(|s| rotation::length(&s.velocity)) + spin * rotation::length(&system.body.center)
        }
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => largest(|s| rotation::length(&s.angular_momentum)),
    })
}

/// How far the body gets [m].
fn reach(system: &System, motion: &[Snapshot]) -> f64 {
    motion.iter().map(|s| s.position.amax()).fold(system.body.extent(), f64::max)
}

/// The system started a little off in everything that rounding touches, in one of a few fixed directions.
fn displaced(system: &System, motion: &[Snapshot], way: usize, displacement: f64) -> System {
    const DIRECTIONS: [Vector3<f64>; COPIES] =
        [Vector3::new(0.36, 0.48, 0.8), Vector3::new(0.8, -0.6, 0.0), Vector3::new(-0.48, -0.64, 0.6)];
    let along = |scale: f64, shift: usize| DIRECTIONS[(way + shift) % COPIES] * (scale * displacement);
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    // Forces that read the velocities of points round off as those do, though the centre of mass stands still.
    let of_points = system.forces.read_velocity();
    let fastest = largest(|s| rotation::length(&s.angular_velocity)) * system.body.extent();
    let velocity = largest(|s| s.velocity.amax()).max(if of_points { fastest } else { 0.0 });
    let change = Start {
        position: along(reach(system, motion), 1),
        velocity: along(velocity, 2),
        angular_momentum: along(largest(|s| s.angular_momentum.amax()), 1),
        orientation: system.start.orientation,
    };
    system.displaced(&along(1.0, 0), &change)
}
