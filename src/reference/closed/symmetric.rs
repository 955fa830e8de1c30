//! The free body with moments (A, A, C): regular precession, two steady rotations.
//!
//! Ω = L/A + (1/C − 1/A) L₃ e₃ with L constant in the world and L₃ in the body, so that
//!
//! (1)  R(t) = Rot(L t/A) R(0) Rot(e₃ (1/C − 1/A) L₃ t)
//!
//! Source: whittaker1937, chapter VI.

use nalgebra::Vector3;

use super::principal_momentum;
use crate::model::System;
use crate::rotation::{self, Rotation};

/// The orientation at `t` [s], of a body two of whose moments are equal.
pub(super) fn turned(system: &System, t: f64) -> Rotation {
    let moments = system.body.moments;
    let axis = (0..3).find(|i| moments[(i + 1) % 3] == moments[(i + 2) % 3]).unwrap_or(2);
    let (a, c) = (moments[(axis + 1) % 3], moments[axis]);
    let own = principal_momentum(system)[axis] * ((a - c) / a / c);
    let principal = system.body.principal;
    let about_momentum = rotation::turn(&(system.start.angular_momentum / a * t));
    let about_axis = rotation::turn(&(Vector3::ith(axis, own) * t));
    let turned = about_momentum * system.start.orientation * principal * about_axis; // (1)
    rotation::renormalized(turned * principal.inverse())
}
