//! Gravity of a fixed centre on every mass point, F_k = −μ M_k d/|d|³ with d = X_k − center.
//!
//! Not polynomial in X̃_k: the reduced form visits the points too.

use nalgebra::Vector3;

use super::{Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::{Body, MassPoint};
use crate::rotation;

/// F_k = −μ M_k d/|d|³, d = X_k − center.
#[derive(Clone, Debug, PartialEq)]
pub struct CentralGravity<T: Real = f64> {
    /// μ [m³/s²].
    pub mu: T,
    /// Centre [m], world.
    pub center: Vector3<T>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: CentralGravity<T>,
    points: Vec<MassPoint<T>>,
}

impl<T: Real> CentralGravity<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &CentralGravity) -> CentralGravity<T> {
        CentralGravity { mu: T::of(law.mu), center: law.center.map(T::of) }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let to_principal_axes =
            |p: &MassPoint<T>| MassPoint { mass: p.mass, position: to_principal(body, &p.position) };
        Reduced { law: self.clone(), points: body.points.iter().map(to_principal_axes).collect() }
    }

    pub(super) fn force(&self, mass: T, position: &Vector3<T>) -> Vector3<T> {
        let d = position - self.center;
        let distance = rotation::length(&d);
        d * (-self.mu * mass / (distance * distance * distance))
    }

    pub(super) fn potential(&self, mass: T, position: &Vector3<T>) -> T {
        -self.mu * mass / rotation::length(&(position - self.center))
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        for point in &self.points {
            let arm = pose.axes * point.position;
            load.push(&arm, &self.law.force(point.mass, &(pose.origin + arm)));
        }
    }
}
