//! Units in which the state of a scene is near one, so that one tolerance serves every component.
//!
//! A scale for each kind of component, from the start of the motion:
//!
//! ```text
//! spin    max(|ω₀|, √(|τ₀|/I), 1/T)
//! length  max(extent, distance to what the forces hang on)
//! speed   max(|U₀|, √(|F₀/M| length), length/T)
//! time    1 / max(spin, speed/length), where forces hang on something; 1 / spin elsewhere
//! ```
//!
//! Where no force depends on the place nothing happens in the time length/speed, and a fast body has nothing that fast.
//!
//! All are powers of two: scaling by them does not round.

use nalgebra::Vector3;

use crate::model::forces::{Argument, Law, Load, Nature};
use crate::model::{Placed, System};
use crate::rotation;

/// Part of |X| that counts as a length where forces depend on it: 1e-14 of it is then about the rounding of X.
const POSITION_SHARE: f64 = 1.0 / 64.0;

/// One of each, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Length of a displacement [m].
    pub length: f64,
    /// Velocity [m/s].
    pub speed: f64,
    /// Angular velocity [rad/s].
    pub spin: f64,
    /// Inertia [kg m²].
    pub inertia: f64,
    /// Time [s].
    pub time: f64,
}

impl Units {
    /// The units of `system` for a run of `duration` [s].
    pub fn of(system: &System, duration: f64) -> Units {
        let (body, start) = (&system.body, &system.start);
        let load = load_at_start(system);
        let inertia = power_of_two(body.moments.amax());
        let body_momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        let start_spin = rotation::length(&(body.inverse_inertia() * body_momentum));
        let torque = rotation::length(&load.torque) / inertia;
        let spin = largest(&[start_spin, torque.sqrt(), 1.0 / duration]);
        let start_speed = if body.pivoted { 0.0 } else { rotation::length(&start.velocity) };
        let acceleration = if body.pivoted { 0.0 } else { rotation::length(&load.force) / body.mass };
        let size = largest(&[body.extent(), reach(system)]);
        let length = if size > 0.0 {
            size
        } else {
            largest(&[start_speed * duration, acceleration * duration * duration])
        };
        let length = power_of_two(length);
        let speed = largest(&[start_speed, (acceleration * length).sqrt(), length / duration]);
        let (spin, speed) = (power_of_two(spin), power_of_two(speed));
        let passing = if hangs(system) { speed / length } else { 0.0 };
        let time = power_of_two(1.0 / spin.max(passing));
        Units { length, speed, spin, inertia, time }
    }
}

fn load_at_start(system: &System) -> Load {
    if system.forces.laws().is_empty() {
        return Load::default();
    }
    let start = &system.start;
    let mut placed = Placed::new(system);
    placed.turn(system, &start.orientation);
    let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = start.orientation * (system.body.inverse_inertia() * momentum);
    let velocity = if system.body.pivoted { Vector3::zeros() } else { start.velocity };
    system.forces.load_on_points(0.0, &placed.cloud(system.origin(), velocity, spin))
}

/// Whether a force depends on the place.
fn hangs(system: &System) -> bool {
    let mut parameters = system.forces.laws().iter().flat_map(Law::arguments).map(|(parameter, _)| parameter);
    parameters.any(|parameter| matches!(parameter.nature, Nature::Place | Nature::Height))
}

/// How far away the things are that forces hang on [m].
fn reach(system: &System) -> f64 {
    let from = |place: &Vector3<f64>| rotation::length(&(system.origin() - place));
    let rounding = POSITION_SHARE * rotation::length(&system.origin());
    system
        .forces
        .laws()
        .iter()
        .flat_map(Law::arguments)
        .map(|(parameter, argument)| match (parameter.nature, argument) {
            (Nature::Place, Argument::Vector(place)) => from(&place).max(rounding),
            (Nature::Height, _) => rounding,
            _ => 0.0,
        })
        .fold(0.0, f64::max)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max)
}

/// The power of two below a positive number; 1 where there is none.
fn power_of_two(x: f64) -> f64 {
    if x.is_normal() && x > 0.0 { f64::from_bits(x.to_bits() & f64::INFINITY.to_bits()) } else { 1.0 }
}
