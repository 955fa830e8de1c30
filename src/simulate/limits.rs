//! What a scheme takes, and the reasons for which it refuses a scene.

use crate::model::System;
use crate::model::body::Shape;

/// What a scheme takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    pub(super) points: bool,
    pub(super) reduced: bool,
    pub(super) velocity_forces: bool,
    pub(super) rods: bool,
    pub(super) plates: bool,
    /// A model without L in its state will do where L is constant.
    pub(super) keeps_momentum: bool,
}

impl Limits {
    /// Everything.
    pub(super) const NONE: Limits = Limits {
        points: true,
        reduced: true,
        velocity_forces: true,
        rods: true,
        plates: true,
        keeps_momentum: true,
    };

    /// Why a scheme with these limits cannot take a scene, if it cannot.
    pub(super) fn refusal(&self, system: &System) -> Option<&'static str> {
        if !self.velocity_forces && system.forces.read_velocity() {
            return Some(
                "a force depends on a velocity, which a splitting into kicks and drifts cannot take",
            );
        }
        if !self.rods && system.body.shape != Shape::Extended {
            return Some(
                "a moment of inertia is zero (a rod or a single point), and the scheme divides by it",
            );
        }
        if !self.plates && system.body.flat() {
            return Some(
                "the body is flat: a second moment of its mass is zero, and the scheme divides by it",
            );
        }
        if !self.reduced && system.body.points.is_empty() {
            return Some("the scheme runs on mass points, and no positive masses have this body's inertia");
        }
        None
    }
}
