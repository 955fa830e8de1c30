//! A system a rounding off: what its motion makes of that is what f64 can tell of it.

#[cfg(feature = "solvers")]
use nalgebra::Matrix3;
use nalgebra::Vector3;

use crate::model::System;

/// Relative change that stands for the roundings of an evaluation: moments from an eigenvalue problem, L turned into
/// principal axes, and the formulas themselves.
pub(super) const NUDGE: f64 = 16.0 * f64::EPSILON;

/// Signs of the changes along the principal axes, of L and, reversed, of the moments.
pub(super) const DIRECTIONS: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0], [-1.0, 1.0, 1.0]];

/// The system with L, moments and velocity off by [`NUDGE`] of themselves; the matrix of the inertia keeps its form
/// and is scaled.
pub(super) fn nudged(system: &System, signs: &[f64; 3]) -> System {
    let mut system = system.clone();
    let change = |sign: f64| 1.0 + sign * NUDGE;
    let principal = system.start.orientation * system.body.principal;
    let momentum = principal.inverse_transform_vector(&system.start.angular_momentum);
    let [x, y, z] = signs.map(change);
    system.start.angular_momentum = principal * momentum.component_mul(&Vector3::new(x, y, z));
    let [x, y, z] = signs.map(|sign| change(-sign));
    system.body.moments = system.body.moments.component_mul(&Vector3::new(x, y, z));
    system.body.inertia *= change(-signs[1]);
    system.start.velocity *= change(signs[1]);
    system
}

/// The same, with the matrix of the inertia made from the moments.
#[cfg(feature = "solvers")]
pub(super) fn nudged_matrix(system: &System, signs: &[f64; 3]) -> System {
    let mut system = nudged(system, signs);
    let axes = system.body.principal.to_rotation_matrix().into_inner();
    system.body.inertia = axes * Matrix3::from_diagonal(&system.body.moments) * axes.transpose();
    system
}
