//! The torque of a distant attracting body on an inertia, τ = 3 μ/r³ (r̂ × I r̂): the first term of the
//! expansion of central gravity in the size of the body over the distance.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose};
use crate::model::body::Body;
use crate::rotation;

/// τ = 3 μ/r³ (r̂ × I r̂), with the unit vector r̂ turning at `rate` about `normal`.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityGradient {
    /// μ/r³ [1/s²].
    pub mu_over_r3: f64,
    /// r̂ at t = 0, world; a unit vector.
    pub direction: Vector3<f64>,
    /// Axis that r̂ turns about, world; a unit vector.
    pub normal: Vector3<f64>,
    /// Rate of turning [rad/s].
    pub rate: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced {
    law: GravityGradient,
    moments: Vector3<f64>,
}

impl GravityGradient {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        Reduced { law: self.clone(), moments: body.moments }
    }

    fn direction_at(&self, t: f64) -> Vector3<f64> {
        rotation::turn(&(self.normal * (self.rate * t))) * self.direction
    }

    pub(super) fn torque(&self, t: f64, inertia: &Matrix3<f64>) -> Vector3<f64> {
        let r = self.direction_at(t);
        r.cross(&(inertia * r)) * (3.0 * self.mu_over_r3)
    }

    /// Energy of the orientation, μ/(2 r³) (3 r̂·I r̂ − tr I), up to a constant: 3 μ/(2 r³) r̂·I r̂.
    pub(super) fn potential(&self, inertia: &Matrix3<f64>) -> f64 {
        1.5 * self.mu_over_r3 * self.direction.dot(&(inertia * self.direction))
    }
}

impl Reduced {
    pub(super) fn add(&self, t: f64, pose: &Pose, load: &mut Load) {
        let r = self.law.direction_at(t);
        let along = pose.axes.tr_mul(&r).component_mul(&self.moments);
        load.torque += r.cross(&(pose.axes * along)) * (3.0 * self.law.mu_over_r3);
    }
}
