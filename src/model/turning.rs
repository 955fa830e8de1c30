//! What schemes in body axes ask of a model: an attitude, moments of inertia, and kicks apart from drifts.

use nalgebra::{Quaternion, Vector3};

use super::falling::Falling;
use super::forced::Forced;
use super::free::{Free, FreeRates, FreeState};
use super::rotor::Rotor;
use super::system::Rotational;
use super::{Broken, Turning};
use crate::arithmetic::Real;
use crate::rotation::{Rotation, formulas, length, zero};

impl<T: Real> Turning for Free<T> {
    #[inline]
    fn rotational(&self) -> &Rotational<T> {
        &self.rotational
    }

    #[inline(always)]
    fn attitude(&self, state: &FreeState<T>) -> Rotation<T> {
        state.attitude
    }

    #[inline(always)]
    fn momentum(&self, _state: &FreeState<T>) -> Vector3<T> {
        self.start.angular_momentum
    }

    #[inline(always)]
    fn place(&self, state: &mut FreeState<T>, attitude: Rotation<T>, _momentum: Vector3<T>) {
        *state = FreeState::at(attitude);
    }

    /// Ω is all that a free body asks of a stage.
    #[inline(always)]
    fn rates_at_stage(
        &self,
        _t: T,
        _held: (&FreeState<T>, T, &FreeRates<T>),
        (q, time): (&Quaternion<T>, T),
        _stage: &mut FreeState<T>,
    ) -> Result<(FreeRates<T>, Quaternion<T>), Broken> {
        let (inverse, momentum) = (self.rotational.inverse_moments, self.start.angular_momentum);
        let (spin, [w, x, y, z]) =
            formulas::spin_at([q.w, q.i, q.j, q.k], time * 0.5, inverse.into(), momentum.into());
        Ok((FreeRates { spin: spin.into() }, Quaternion::new(w, x, y, z)))
    }

    #[inline(always)]
    fn spin_of(&self, rates: &FreeRates<T>) -> Vector3<T> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, _rates: &FreeRates<T>) -> Vector3<T> {
        zero()
    }

    #[inline]
    fn kick(&self, _state: &mut FreeState<T>, _s: T, _rates: &FreeRates<T>) {}

    #[inline]
    fn drift(&self, _state: &mut FreeState<T>, _s: T) {}

    #[inline]
    fn apart(&self, a: &FreeState<T>, b: &FreeState<T>) -> T {
        attitude_apart(&a.attitude, &b.attitude)
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        false
    }
}

impl<T: Real> Turning for Falling<T> {
    #[inline]
    fn rotational(&self) -> &Rotational<T> {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation<T> {
        state.attitude
    }

    #[inline]
    fn momentum(&self, _state: &Self::State) -> Vector3<T> {
        self.start.angular_momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation<T>, _momentum: Vector3<T>) {
        state.attitude = attitude;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<T> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, _rates: &Self::Rates) -> Vector3<T> {
        zero()
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: T, rates: &Self::Rates) {
        state.velocity += rates.acceleration * s;
    }

    #[inline]
    fn drift(&self, state: &mut Self::State, s: T) {
        state.position += state.velocity * s;
    }

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> T {
        attitude_apart(&a.attitude, &b.attitude)
            .max(relative(&a.position, &b.position, &self.start.position))
            .max(relative(&a.velocity, &b.velocity, &self.start.velocity))
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        false
    }
}

impl<T: Real> Turning for Rotor<T> {
    #[inline]
    fn rotational(&self) -> &Rotational<T> {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation<T> {
        state.attitude
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Vector3<T> {
        state.momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation<T>, momentum: Vector3<T>) {
        state.attitude = attitude;
        state.momentum = momentum;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<T> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, rates: &Self::Rates) -> Vector3<T> {
        rates.torque
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: T, rates: &Self::Rates) {
        state.momentum += rates.torque * s;
    }

    #[inline]
    fn drift(&self, _state: &mut Self::State, _s: T) {}

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> T {
        attitude_apart(&a.attitude, &b.attitude).max(relative(
            &a.momentum,
            &b.momentum,
            &self.start.angular_momentum,
        ))
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        self.forces.read_velocity()
    }
}

impl<T: Real> Turning for Forced<T> {
    #[inline]
    fn rotational(&self) -> &Rotational<T> {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation<T> {
        state.attitude
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Vector3<T> {
        state.momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation<T>, momentum: Vector3<T>) {
        state.attitude = attitude;
        state.momentum = momentum;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<T> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, rates: &Self::Rates) -> Vector3<T> {
        rates.torque
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: T, rates: &Self::Rates) {
        state.velocity += rates.acceleration * s;
        state.momentum += rates.torque * s;
    }

    #[inline]
    fn drift(&self, state: &mut Self::State, s: T) {
        state.position += state.velocity * s;
    }

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> T {
        attitude_apart(&a.attitude, &b.attitude)
            .max(relative(&a.position, &b.position, &self.start.position))
            .max(relative(&a.velocity, &b.velocity, &self.start.velocity))
            .max(relative(&a.momentum, &b.momentum, &self.start.angular_momentum))
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        self.forces.read_velocity()
    }
}

/// |q_a − q_b|: half the angle between two attitudes near each other.
#[inline]
fn attitude_apart<T: Real>(a: &Rotation<T>, b: &Rotation<T>) -> T {
    (a.as_ref() - b.as_ref()).norm()
}

/// Part of what it was at the start below which a vector counts as come to rest.
const NEAR_REST: f64 = 1e-4;

/// |a − b| over the larger length, or over that of what has come to rest where this is more: forces that cancel leave a rounding of
/// what they were, which of a body at rest is no small part. 0 where all are zero.
#[inline]
fn relative<T: Real>(a: &Vector3<T>, b: &Vector3<T>, start: &Vector3<T>) -> T {
    let size = length(a).max(length(b)).max(length(start) * NEAR_REST);
    if size == 0.0 { size } else { length(&(a - b)) / size }
}
