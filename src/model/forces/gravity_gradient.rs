//! The torque of a distant attracting body on an inertia, τ = 3 μ/r³ (r̂ × I r̂): the first term of the
//! expansion of central gravity in the size of the body over the distance.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

/// τ = 3 μ/r³ (r̂ × I r̂), with the unit vector r̂ turning at `rate` about `normal`.
#[derive(Clone, Debug, PartialEq)]
pub struct GravityGradient<T: Real = f64> {
    /// μ/r³ [1/s²].
    pub mu_over_r3: T,
    /// r̂ at t = 0, world; a unit vector.
    pub direction: Vector3<T>,
    /// Axis that r̂ turns about, world; a unit vector.
    pub normal: Vector3<T>,
    /// Rate of turning [rad/s].
    pub rate: T,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: GravityGradient<T>,
    moments: Vector3<T>,
}

impl<T: Real> GravityGradient<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &GravityGradient) -> GravityGradient<T> {
        GravityGradient {
            mu_over_r3: T::of(law.mu_over_r3),
            direction: law.direction.map(T::of),
            normal: law.normal.map(T::of),
            rate: T::of(law.rate),
        }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced { law: self.clone(), moments: body.moments }
    }

    fn direction_at(&self, t: T) -> Vector3<T> {
        rotation::turn(&(self.normal * (self.rate * t))) * self.direction
    }

    pub(super) fn torque(&self, t: T, inertia: &Matrix3<T>) -> Vector3<T> {
        let r = self.direction_at(t);
        r.cross(&(inertia * r)) * (self.mu_over_r3 * 3.0)
    }

    /// Energy of the orientation, μ/(2 r³) (3 r̂·I r̂ − tr I), up to a constant: 3 μ/(2 r³) r̂·I r̂.
    pub(super) fn potential(&self, inertia: &Matrix3<T>) -> T {
        T::of(1.5) * self.mu_over_r3 * self.direction.dot(&(inertia * self.direction))
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let r = self.law.direction_at(t);
        let along = pose.axes.tr_mul(&r).component_mul(&self.moments);
        load.torque += r.cross(&(pose.axes * along)) * (self.law.mu_over_r3 * 3.0);
    }
}
