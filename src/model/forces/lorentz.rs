//! The Lorentz force on charged points, F_k = q_k (E(t) + U_k × B).
//!
//! Reduced: with q = Σ q_k, s = Σ q_k x_k and Q = Σ q_k x_k x_kᵀ,
//!     F = q E + (q U + Ω × s) × B,   τ = s × (E + U × B) + Ω × Q B,
//! the last term from x × ((Ω × x) × B) = (Ω × x)(x·B).

use nalgebra::{Matrix3, Vector3};

use super::{Load, PerPoint, Pose, tensor_to_principal, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

/// F_k = q_k (E(t) + U_k × B), E(t) = electric + electric_cosine cos(ωt) + electric_sine sin(ωt).
#[derive(Clone, Debug, PartialEq)]
pub struct Lorentz<T: Real = f64> {
    /// q_k [C].
    pub charge: PerPoint<T>,
    /// Constant part of E [V/m], world.
    pub electric: Vector3<T>,
    /// Amplitude of the cosine [V/m], world.
    pub electric_cosine: Vector3<T>,
    /// Amplitude of the sine [V/m], world.
    pub electric_sine: Vector3<T>,
    /// ω [rad/s].
    pub frequency: T,
    /// B [T], world.
    pub magnetic: Vector3<T>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: Lorentz<T>,
    total: T,
    first: Vector3<T>,
    second: Matrix3<T>,
}

impl<T: Real> Lorentz<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Lorentz) -> Lorentz<T> {
        Lorentz {
            charge: PerPoint::of(&law.charge),
            electric: law.electric.map(T::of),
            electric_cosine: law.electric_cosine.map(T::of),
            electric_sine: law.electric_sine.map(T::of),
            frequency: T::of(law.frequency),
            magnetic: law.magnetic.map(T::of),
        }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let (mut total, mut first, mut second) = (T::zero(), Vector3::zeros(), Matrix3::zeros());
        for (k, point) in body.points.iter().enumerate() {
            let q = self.charge.at(k);
            total += q;
            first += point.position * q;
            second += point.position * point.position.transpose() * q;
        }
        let first = to_principal(body, &first);
        let second = tensor_to_principal(body, &second);
        Reduced { law: self.clone(), total, first, second }
    }

    fn electric_at(&self, t: T) -> Vector3<T> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        self.electric + self.electric_cosine * cosine + self.electric_sine * sine
    }

    pub(super) fn force(&self, t: T, k: usize, velocity: &Vector3<T>) -> Vector3<T> {
        (self.electric_at(t) + velocity.cross(&self.magnetic)) * self.charge.at(k)
    }

    /// Whether the electric field does not depend on time.
    pub fn is_static(&self) -> bool {
        self.frequency == 0.0 || (self.electric_cosine.amax() == 0.0 && self.electric_sine.amax() == 0.0)
    }

    pub(super) fn potential(&self, k: usize, position: &Vector3<T>) -> T {
        -self.charge.at(k) * self.electric_at(T::zero()).dot(position)
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let electric = self.law.electric_at(t);
        let magnetic = self.law.magnetic;
        let first = pose.axes * self.first;
        load.force +=
            electric * self.total + (pose.velocity * self.total + pose.spin.cross(&first)).cross(&magnetic);
        let second = pose.axes * (self.second * pose.axes.tr_mul(&magnetic));
        load.torque += first.cross(&(electric + pose.velocity.cross(&magnetic))) + pose.spin.cross(&second);
    }
}
