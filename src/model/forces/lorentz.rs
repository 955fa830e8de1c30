//! The Lorentz force on charged points, F_k = q_k (E(t) + U_k × B).
//!
//! Reduced: with q = Σ q_k, s = Σ q_k x_k and Q = Σ q_k x_k x_kᵀ,
//!     F = q E + (q U + Ω × s) × B,   τ = s × (E + U × B) + Ω × Q B,
//! the last term from x × ((Ω × x) × B) = (Ω × x)(x·B).

use nalgebra::{Matrix3, Vector3};

use super::{Load, PerPoint, Pose, tensor_to_principal, to_principal};
use crate::model::body::Body;

/// F_k = q_k (E(t) + U_k × B), E(t) = electric + electric_cosine cos(ωt) + electric_sine sin(ωt).
#[derive(Clone, Debug, PartialEq)]
pub struct Lorentz {
    /// q_k [C].
    pub charge: PerPoint,
    /// Constant part of E [V/m], world.
    pub electric: Vector3<f64>,
    /// Amplitude of the cosine [V/m], world.
    pub electric_cosine: Vector3<f64>,
    /// Amplitude of the sine [V/m], world.
    pub electric_sine: Vector3<f64>,
    /// ω [rad/s].
    pub frequency: f64,
    /// B [T], world.
    pub magnetic: Vector3<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced {
    law: Lorentz,
    total: f64,
    first: Vector3<f64>,
    second: Matrix3<f64>,
}

impl Lorentz {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        let (mut total, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for (k, point) in body.points.iter().enumerate() {
            let q = self.charge.of(k);
            total += q;
            first += point.position * q;
            second += point.position * point.position.transpose() * q;
        }
        let first = to_principal(body, &first);
        let second = tensor_to_principal(body, &second);
        Reduced { law: self.clone(), total, first, second }
    }

    fn electric_at(&self, t: f64) -> Vector3<f64> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        self.electric + self.electric_cosine * cosine + self.electric_sine * sine
    }

    pub(super) fn force(&self, t: f64, k: usize, velocity: &Vector3<f64>) -> Vector3<f64> {
        (self.electric_at(t) + velocity.cross(&self.magnetic)) * self.charge.of(k)
    }

    /// Whether the electric field does not depend on time.
    pub fn is_static(&self) -> bool {
        self.frequency == 0.0 || (self.electric_cosine.amax() == 0.0 && self.electric_sine.amax() == 0.0)
    }

    pub(super) fn potential(&self, k: usize, position: &Vector3<f64>) -> f64 {
        -self.charge.of(k) * self.electric_at(0.0).dot(position)
    }
}

impl Reduced {
    pub(super) fn add(&self, t: f64, pose: &Pose, load: &mut Load) {
        let electric = self.law.electric_at(t);
        let magnetic = self.law.magnetic;
        let first = pose.axes * self.first;
        load.force +=
            electric * self.total + (pose.velocity * self.total + pose.spin.cross(&first)).cross(&magnetic);
        let second = pose.axes * (self.second * pose.axes.tr_mul(&magnetic));
        load.torque += first.cross(&(electric + pose.velocity.cross(&magnetic))) + pose.spin.cross(&second);
    }
}
