//! A one-sided elastic plane with damping and regularised friction, on every mass point.
//!
//! At depth d = height − X_k·n > 0 the plane pushes with N = max(k d − c U_k·n, 0) along n and rubs with
//! −μ N s/√(s·s + v₀²), s the velocity along the plane. The force has a kink on touching: no scheme keeps its
//! order across it.

use nalgebra::Vector3;

use super::{Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

/// A penalty ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground<T: Real = f64> {
    /// n, world; a unit vector.
    pub normal: Vector3<T>,
    /// Height of the plane along n [m].
    pub height: T,
    /// k [N/m].
    pub stiffness: T,
    /// c [N s/m].
    pub damping: T,
    /// μ.
    pub friction: T,
    /// v₀ [m/s].
    pub slip_velocity: T,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: Ground<T>,
    points: Vec<Vector3<T>>,
}

impl<T: Real> Ground<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Ground) -> Ground<T> {
        Ground {
            normal: law.normal.map(T::of),
            height: T::of(law.height),
            stiffness: T::of(law.stiffness),
            damping: T::of(law.damping),
            friction: T::of(law.friction),
            slip_velocity: T::of(law.slip_velocity),
        }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let points = body.points.iter().map(|p| to_principal(body, &p.position)).collect();
        Reduced { law: self.clone(), points }
    }

    pub(super) fn force(&self, position: &Vector3<T>, velocity: &Vector3<T>) -> Vector3<T> {
        let depth = self.height - position.dot(&self.normal);
        if depth <= 0.0 {
            return Vector3::zeros();
        }
        let approach = velocity.dot(&self.normal);
        let push = (self.stiffness * depth - self.damping * approach).max(T::zero());
        let sliding = velocity - self.normal * approach;
        let speed = (sliding.norm_squared() + self.slip_velocity * self.slip_velocity).sqrt();
        let rub = if speed == 0.0 { speed } else { self.friction * push / speed };
        self.normal * push - sliding * rub
    }

    pub(super) fn potential(&self, position: &Vector3<T>) -> T {
        let depth = (self.height - position.dot(&self.normal)).max(T::zero());
        T::of(0.5) * self.stiffness * depth * depth
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        for point in &self.points {
            let arm = pose.axes * point;
            load.push(&arm, &self.law.force(&(pose.origin + arm), &pose.velocity_at(&arm)));
        }
    }
}
