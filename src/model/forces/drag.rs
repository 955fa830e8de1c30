//! Linear drag on every mass point, F_k = −c_k U_k.
//!
//! Reduced: with c = Σ c_k, s = Σ c_k x_k and D = Σ c_k (|x_k|² E − x_k x_kᵀ),
//!     F = −(c U + Ω × s),   τ = −(s × U + D Ω).

use nalgebra::{Matrix3, Vector3};

use super::{Load, PerPoint, Pose, tensor_to_principal, to_principal};
use crate::arithmetic::Real;
use crate::model::body::{Body, second_moment_inertia};

/// F_k = −c_k U_k.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag<T: Real = f64> {
    /// c_k [N s/m].
    pub coefficient: PerPoint<T>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    total: T,
    first: Vector3<T>,
    second: Matrix3<T>,
}

impl<T: Real> Drag<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Drag) -> Drag<T> {
        Drag { coefficient: PerPoint::of(&law.coefficient) }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let mut reduced = Reduced { total: T::zero(), first: Vector3::zeros(), second: Matrix3::zeros() };
        for (k, point) in body.points.iter().enumerate() {
            let c = self.coefficient.at(k);
            reduced.total += c;
            reduced.first += point.position * c;
            reduced.second += second_moment_inertia(&point.position) * c;
        }
        reduced.first = to_principal(body, &reduced.first);
        reduced.second = tensor_to_principal(body, &reduced.second);
        reduced
    }

    pub(super) fn force(&self, k: usize, velocity: &Vector3<T>) -> Vector3<T> {
        velocity * -self.coefficient.at(k)
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        let first = pose.axes * self.first;
        let spin = pose.axes.tr_mul(&pose.spin);
        load.force -= pose.velocity * self.total + pose.spin.cross(&first);
        load.torque -= first.cross(&pose.velocity) + pose.axes * (self.second * spin);
    }
}
