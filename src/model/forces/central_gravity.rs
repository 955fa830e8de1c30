//! Gravity of a fixed centre on every mass point, F_k = −μ M_k d/|d|³ with d = X_k − center.
//!
//! Not polynomial in X̃_k: the reduced form visits the points too.

use nalgebra::Vector3;

use super::{Load, Pose, to_principal};
use crate::model::body::{Body, MassPoint};
use crate::rotation;

/// F_k = −μ M_k d/|d|³, d = X_k − center.
#[derive(Clone, Debug, PartialEq)]
pub struct CentralGravity {
    /// μ [m³/s²].
    pub mu: f64,
    /// Centre [m], world.
    pub center: Vector3<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced {
    law: CentralGravity,
    points: Vec<MassPoint>,
}

impl CentralGravity {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        let to_principal_axes =
            |p: &MassPoint| MassPoint { mass: p.mass, position: to_principal(body, &p.position) };
        Reduced { law: self.clone(), points: body.points.iter().map(to_principal_axes).collect() }
    }

    pub(super) fn force(&self, mass: f64, position: &Vector3<f64>) -> Vector3<f64> {
        let d = position - self.center;
        let distance = rotation::length(&d);
        d * (-self.mu * mass / (distance * distance * distance))
    }

    pub(super) fn potential(&self, mass: f64, position: &Vector3<f64>) -> f64 {
        -self.mu * mass / rotation::length(&(position - self.center))
    }
}

impl Reduced {
    pub(super) fn add(&self, pose: &Pose, load: &mut Load) {
        for point in &self.points {
            let arm = pose.axes * point.position;
            load.push(&arm, &self.law.force(point.mass, &(pose.origin + arm)));
        }
    }
}
