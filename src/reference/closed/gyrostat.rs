//! The free body with moments (A, A, C) and wheels of momentum h on its axis: two steady rotations.
//!
//! The whole angular momentum M = L + R h e₃ is constant in the world and M₃ in the body, and Ω = M/A + (Ω₃ − M₃/A) e₃, so that
//!
//! (1)  R(t) = Rot(M t/A) R(0) Rot(e₃ (Ω₃ − M₃/A) t)
//!
//! Source: hughes1986, chapter 6.

use nalgebra::Vector3;

use crate::model::System;
use crate::model::body::Shape;
use crate::model::forces::Law;
use crate::rotation::{self, Rotation};

/// A body with its wheels on an axis of symmetry.
pub(super) struct Gyrostat {
    axis: usize,
    /// h [kg m²/s].
    momentum: f64,
}

impl Gyrostat {
    /// The sum of the wheels of a body that is symmetric about it; `None` without wheels, or where they lie otherwise.
    pub fn of(system: &System) -> Option<Gyrostat> {
        let body = &system.body;
        let given = |law: &Law| if let Law::Wheels(wheels) = law { Some(wheels.momentum) } else { None };
        let momentum: Vector3<f64> = system.forces.laws().iter().filter_map(given).sum();
        let momentum = body.principal.inverse_transform_vector(&momentum);
        let across = |axis: usize| [(axis + 1) % 3, (axis + 2) % 3];
        let fits = |axis: &usize| {
            let [j, k] = across(*axis);
            body.moments[j] == body.moments[k] && momentum[j] == 0.0 && momentum[k] == 0.0
        };
        if body.shape != Shape::Extended || body.pivoted || momentum == Vector3::zeros() {
            return None;
        }
        (0..3).find(fits).map(|axis| Gyrostat { axis, momentum: momentum[axis] })
    }

    /// Orientation and Ω [rad/s] at `t` [s].
    pub fn at(&self, system: &System, t: f64) -> (Rotation, Vector3<f64>) {
        let (axis, moments, principal) = (self.axis, system.body.moments, system.body.principal);
        let (across, along) = (moments[(axis + 1) % 3], moments[axis]);
        let start = system.start.orientation * principal;
        let wheels = Vector3::ith(axis, self.momentum);
        let whole = system.start.angular_momentum + start * wheels;
        let own = start.inverse_transform_vector(&system.start.angular_momentum)[axis] / along
            - start.inverse_transform_vector(&whole)[axis] / across;
        let about_axis = Vector3::ith(axis, own);
        let turned = rotation::turn(&(whole / across * t)) * start * rotation::turn(&(about_axis * t)); // (1)
        let spin = whole / across + turned * about_axis;
        (rotation::renormalized(turned * principal.inverse()), spin)
    }
}
