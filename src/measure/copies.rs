//! Rounding: how far copies of a run end from it.
//!
//! A copy starts a few units in the last place off, its mass points too: after the first step every rounding of it is another
//! one (stochastic arithmetic; Vignes' CESTAC is the published ancestor). What a copy differs by is rounding, however it grows. Every gate that
//! needs a rounding asks here.

use crate::arithmetic::Real;
use crate::model::copies::{CLEAR, COPIES, OFF, displaced, started_off};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Starts of the copies of a run. `motion` says how large everything gets, `unit` is one in the last place of the arithmetic; where the body
/// is `retold`, its mass points are moved too.
pub fn starts(system: &System, motion: &[Snapshot], unit: f64, retold: bool) -> [System; COPIES] {
    let off = extents(system, motion).map(|extent| OFF * unit * extent);
    std::array::from_fn(|way| displaced(system, &off, way, retold))
}

/// Starts of the copies of a run in an arithmetic; `motion` is that of the system in f64.
pub fn starts_in<T: Real>(
    system: &System<T>,
    (given, motion): (&System, &[Snapshot]),
) -> [System<T>; COPIES] {
    let off = extents(given, motion).map(|extent| OFF * T::UNIT * extent);
    std::array::from_fn(|way| started_off(system, &off, way))
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

/// The rounding of a run in an arithmetic of this unit: the spread of its copies, and a rounding of the size of each quantity for each of `count` steps or
/// evaluations.
pub fn rounding(
    spread: &PerQuantity<f64>,
    sizes: &PerQuantity<f64>,
    (unit, count): (f64, u64),
) -> PerQuantity<f64> {
    let of_each = unit * count as f64 / CLEAR;
    PerQuantity::of(|quantity| spread[quantity] + of_each * sizes[quantity])
}

/// How large everything that rounding touches gets, each quantity in its unit.
fn extents(system: &System, motion: &[Snapshot]) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    // Forces that read the velocities of points round off as those do, though the centre of mass stands still.
    let of_points = system.forces.read_velocity();
    let spin = largest(|s| rotation::length(&s.angular_velocity));
    let fastest = if of_points { spin * system.body.extent() } else { 0.0 };
    let reach = largest(|s| s.position.amax()).max(system.body.extent());
    // A copy that keeps its distance by whole units in the last place of its position has the roundings of the run.
    let drift = motion.last().map_or(0.0, |end| if end.time > 0.0 { reach / end.time } else { 0.0 });
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => reach,
        Quantity::Velocity => largest(|s| s.velocity.amax()).max(fastest).max(drift),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => largest(|s| s.angular_momentum.amax()),
    })
}
