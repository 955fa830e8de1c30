//! Copies of a run, which show its rounding: their starts are a few units in the last place off.

use nalgebra::Vector3;

use super::{PerQuantity, Quantity, Snapshot, Start, System, retold};
use crate::arithmetic::Real;
use crate::rotation;

/// Copies of every run.
pub const COPIES: usize = 3;
/// Units in the last place that a copy is off by.
pub const OFF: f64 = 4.0;
/// A difference counts where it is more than so many times the distance of the copies. Three copies show the size of a rounding to a factor of
/// three or so, and the rest is a margin of ten.
pub const CLEAR: f64 = 30.0;

/// Size of each quantity over a motion, in its unit.
pub fn sizes(system: &System, motion: &[Snapshot]) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    let (position, spin) =
        (largest(|s| rotation::length(&s.position)), largest(|s| rotation::length(&s.angular_velocity)));
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => position + system.body.extent(),
        Quantity::Velocity => {
            largest(|s| rotation::length(&s.velocity)) + spin * rotation::length(&system.body.center)
        }
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => spin,
        Quantity::AngularMomentum => largest(|s| rotation::length(&s.angular_momentum)),
    })
}

/// The system started off by `off` in every quantity, in one of a few fixed directions; where the body is `retold`, its mass points are
/// moved too, by as much of its extent as it is turned [rad].
pub fn displaced(system: &System, off: &PerQuantity<f64>, way: usize, retold: bool) -> System {
    let body = if retold { retold::moved(system, off[Quantity::Orientation], way) } else { None };
    started_off(body.as_ref().unwrap_or(system), off, way)
}

/// The system started off by `off` in every quantity, in one of a few fixed directions, in any arithmetic.
pub fn started_off<T: Real>(system: &System<T>, off: &PerQuantity<f64>, way: usize) -> System<T> {
    const DIRECTIONS: [Vector3<f64>; COPIES] =
        [Vector3::new(0.36, 0.48, 0.8), Vector3::new(0.8, -0.6, 0.0), Vector3::new(-0.48, -0.64, 0.6)];
    let along = |quantity, shift: usize| (DIRECTIONS[(way + shift) % COPIES] * off[quantity]).map(T::of);
    let change = Start {
        position: along(Quantity::Position, 1),
        velocity: along(Quantity::Velocity, 2),
        angular_momentum: along(Quantity::AngularMomentum, 1),
        orientation: system.start.orientation,
    };
    system.displaced(&along(Quantity::Orientation, 0), &change)
}
