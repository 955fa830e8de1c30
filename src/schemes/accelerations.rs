//! Accelerations of a body, how they are kept in a history that is made for rates, and the weights of the generalised-α methods.

use nalgebra::Vector3;

use crate::arithmetic::Real;
use crate::model::{Motion, Rates, Turning};
use crate::rotation::{Rotation, turned_back, zero};

/// Accelerations of the rotation, body axes [rad/s²], and of the centre of mass [m/s²].
#[derive(Clone, Copy)]
pub(super) struct Accelerations<T: Real> {
    pub(super) spin: Vector3<T>,
    pub(super) velocity: Vector3<T>,
}

impl<T: Real> Accelerations<T> {
    /// v̇ and F/M of rates at an attitude and L.
    #[inline]
    pub(super) fn of<M: Turning<Real = T>>(
        model: &M,
        rates: &M::Rates,
        attitude: &Rotation<T>,
        momentum: &Vector3<T>,
    ) -> Self {
        let in_body = turned_back(attitude, momentum);
        let inverse = model.rotational().inverse_moments;
        let torque = turned_back(attitude, &model.torque_of(rates));
        let spin = (torque - inverse.component_mul(&in_body).cross(&in_body)).component_mul(&inverse);
        Accelerations { spin, velocity: rates.motion().acceleration }
    }

    /// A weighted sum.
    #[inline]
    pub(super) fn mixed(&self, part: T, other: &Accelerations<T>, rest: T) -> Accelerations<T> {
        Accelerations {
            spin: self.spin * part + other.spin * rest,
            velocity: self.velocity * part + other.velocity * rest,
        }
    }

    /// As rates, to be kept in the history.
    #[inline]
    pub(super) fn kept<R: Rates<T>>(&self) -> R {
        let zero = zero();
        R::of(Motion { spin: self.spin, velocity: zero, acceleration: self.velocity, torque: zero })
    }

    /// What was kept.
    #[inline]
    pub(super) fn remembered<R: Rates<T>>(rates: R) -> Accelerations<T> {
        let motion = rates.motion();
        Accelerations { spin: motion.spin, velocity: motion.acceleration }
    }
}

/// The weights of a generalised-α method.
pub(super) struct Alphas<T: Real> {
    pub(super) alpha_m: T,
    pub(super) alpha_f: T,
    pub(super) gamma: T,
    pub(super) beta: T,
}

impl<T: Real> Alphas<T> {
    /// For the spectral radius ρ at infinite frequency: α_m = (2ρ − 1)/(ρ + 1), α_f = ρ/(ρ + 1), γ = ½ + α_f − α_m, β = ¼ (γ + ½)².
    pub(super) fn of(radius: T) -> Alphas<T> {
        let (alpha_m, alpha_f) = ((radius * 2.0 - 1.0) / (radius + 1.0), radius / (radius + 1.0));
        let gamma = alpha_f + 0.5 - alpha_m;
        let beta = (gamma + 0.5) * 0.25 * (gamma + 0.5);
        Alphas { alpha_m, alpha_f, gamma, beta }
    }

    /// (½ − β) a₀ + β a₁.
    #[inline]
    pub(super) fn mean(&self, a0: &Accelerations<T>, a1: &Accelerations<T>) -> Accelerations<T> {
        a0.mixed(-self.beta + 0.5, a1, self.beta)
    }

    /// (1 − γ) a₀ + γ a₁.
    #[inline]
    pub(super) fn change(&self, a0: &Accelerations<T>, a1: &Accelerations<T>) -> Accelerations<T> {
        a0.mixed(T::one() - self.gamma, a1, self.gamma)
    }

    /// a₁ of (1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀.
    #[inline]
    pub(super) fn algorithmic(
        &self,
        a0: &Accelerations<T>,
        real0: &Accelerations<T>,
        real1: &Accelerations<T>,
    ) -> Accelerations<T> {
        let right = real1.mixed(T::one() - self.alpha_f, real0, self.alpha_f);
        let rest = T::one() - self.alpha_m;
        right.mixed(T::one() / rest, a0, -self.alpha_m / rest)
    }

    /// v̇₁ of the same equation.
    #[inline]
    pub(super) fn real(
        &self,
        a0: &Accelerations<T>,
        real0: &Accelerations<T>,
        a1: &Accelerations<T>,
    ) -> Accelerations<T> {
        let left = a1.mixed(T::one() - self.alpha_m, a0, self.alpha_m);
        let rest = T::one() - self.alpha_f;
        left.mixed(T::one() / rest, real0, -self.alpha_f / rest)
    }
}
