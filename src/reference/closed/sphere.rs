//! The free sphere, three equal moments I: a steady rotation, Ω = L/I.
//!
//! Source: whittaker1937, chapter VI.

use crate::model::System;
use crate::rotation::{self, Rotation};

/// The turn in world axes over the time `t` [s].
pub(super) fn turn(system: &System, t: f64) -> Rotation {
    rotation::turn(&(system.start.angular_momentum / system.body.moments.x * t))
}
