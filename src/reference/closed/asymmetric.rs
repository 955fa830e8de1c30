//! The free asymmetric body with its attitude: Jacobi's functions, and a mean rate and a phase for the angle about L.
//!
//! The same exact rotor that the splitting schemes turn by, over the whole time at once; see
//! [`crate::rotation::free_rotor`], which holds the formulas. Near the separatrix k′ enters by itself and is not lost.
//!
//! Source: vanzon2007, celledoni2008; whittaker1937, chapter VI.

use super::{after, principal_momentum};
use crate::model::System;
use crate::rotation::Rotation;
use crate::rotation::free_rotor;

/// The orientation at `t` [s].
pub(super) fn turned(system: &System, t: f64) -> Rotation {
    after(system, &free_rotor::turn_in(&system.body.moments, &principal_momentum(system), t))
}
