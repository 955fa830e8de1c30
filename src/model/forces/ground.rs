//! A one-sided elastic plane with damping and regularised friction, on every mass point.
//!
//! At depth d = height − X_k·n > 0 the plane pushes with N = max(k d − c U_k·n, 0) along n and rubs with
//! −μ N s/√(s·s + v₀²), s the velocity along the plane. The force has a kink on touching: no scheme keeps its
//! order across it.

use nalgebra::Vector3;

use super::{Load, Pose, to_principal};
use crate::model::body::Body;

/// A penalty ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// n, world; a unit vector.
    pub normal: Vector3<f64>,
    /// Height of the plane along n [m].
    pub height: f64,
    /// k [N/m].
    pub stiffness: f64,
    /// c [N s/m].
    pub damping: f64,
    /// μ.
    pub friction: f64,
    /// v₀ [m/s].
    pub slip_velocity: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced {
    law: Ground,
    points: Vec<Vector3<f64>>,
}

impl Ground {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        let points = body.points.iter().map(|p| to_principal(body, &p.position)).collect();
        Reduced { law: self.clone(), points }
    }

    pub(super) fn force(&self, position: &Vector3<f64>, velocity: &Vector3<f64>) -> Vector3<f64> {
        let depth = self.height - position.dot(&self.normal);
        if depth <= 0.0 {
            return Vector3::zeros();
        }
        let approach = velocity.dot(&self.normal);
        let push = (self.stiffness * depth - self.damping * approach).max(0.0);
        let sliding = velocity - self.normal * approach;
        let speed = (sliding.norm_squared() + self.slip_velocity * self.slip_velocity).sqrt();
        let rub = if speed == 0.0 { 0.0 } else { self.friction * push / speed };
        self.normal * push - sliding * rub
    }

    pub(super) fn potential(&self, position: &Vector3<f64>) -> f64 {
        let depth = (self.height - position.dot(&self.normal)).max(0.0);
        0.5 * self.stiffness * depth * depth
    }
}

impl Reduced {
    pub(super) fn add(&self, pose: &Pose, load: &mut Load) {
        for point in &self.points {
            let arm = pose.axes * point;
            load.push(&arm, &self.law.force(&(pose.origin + arm), &pose.velocity_at(&arm)));
        }
    }
}
