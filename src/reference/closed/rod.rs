//! The free rod: a steady rotation about L, Ω = L/s with s = ½ tr I, since L is across it.
//!
//! Source: whittaker1937, chapter VI, for the free body; the two equal moments are s, the third is 0.

use nalgebra::Vector3;

use crate::model::System;
use crate::rotation::{self, Rotation};

/// Ω [rad/s].
pub(super) fn spin(system: &System) -> Vector3<f64> {
    system.start.angular_momentum / (0.5 * system.body.inertia.trace())
}

/// The turn in world axes over the time `t` [s].
pub(super) fn turn(system: &System, t: f64) -> Rotation {
    rotation::turn(&(spin(system) * t))
}
