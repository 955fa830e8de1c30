//! What schemes in body axes ask of a model: an attitude, moments of inertia, and kicks apart from drifts.

use nalgebra::{Quaternion, Vector3};

use super::falling::Falling;
use super::forced::Forced;
use super::free::Free;
use super::rotor::Rotor;
use super::system::Rotational;
use super::{Broken, Turning};
use crate::rotation::{Rotation, formulas, length};

impl Turning for Free {
    #[inline]
    fn rotational(&self) -> &Rotational {
        &self.rotational
    }

    #[inline(always)]
    fn attitude(&self, state: &Rotation) -> Rotation {
        *state
    }

    #[inline(always)]
    fn momentum(&self, _state: &Rotation) -> Vector3<f64> {
        self.start.angular_momentum
    }

    #[inline(always)]
    fn place(&self, state: &mut Rotation, attitude: Rotation, _momentum: Vector3<f64>) {
        *state = attitude;
    }

    /// Ω is all that a free body asks of a stage.
    #[inline(always)]
    fn rates_at_stage(
        &self,
        _t: f64,
        _held: (&Rotation, f64, &Vector3<f64>),
        (q, time): (&Quaternion<f64>, f64),
        _stage: &mut Rotation,
    ) -> Result<(Vector3<f64>, Quaternion<f64>), Broken> {
        let (inverse, momentum) = (self.rotational.inverse_moments, self.start.angular_momentum);
        let (spin, [w, x, y, z]) =
            formulas::spin_at([q.w, q.i, q.j, q.k], 0.5 * time, inverse.into(), momentum.into());
        Ok((spin.into(), Quaternion::new(w, x, y, z)))
    }

    #[inline(always)]
    fn spin_of(&self, rates: &Vector3<f64>) -> Vector3<f64> {
        *rates
    }

    #[inline]
    fn torque_of(&self, _rates: &Vector3<f64>) -> Vector3<f64> {
        Vector3::zeros()
    }

    #[inline]
    fn kick(&self, _state: &mut Rotation, _s: f64, _rates: &Vector3<f64>) {}

    #[inline]
    fn drift(&self, _state: &mut Rotation, _s: f64) {}

    #[inline]
    fn apart(&self, a: &Rotation, b: &Rotation) -> f64 {
        attitude_apart(a, b)
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        false
    }
}

impl Turning for Falling {
    #[inline]
    fn rotational(&self) -> &Rotational {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation {
        state.attitude
    }

    #[inline]
    fn momentum(&self, _state: &Self::State) -> Vector3<f64> {
        self.start.angular_momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation, _momentum: Vector3<f64>) {
        state.attitude = attitude;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<f64> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, _rates: &Self::Rates) -> Vector3<f64> {
        Vector3::zeros()
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: f64, rates: &Self::Rates) {
        state.velocity += rates.acceleration * s;
    }

    #[inline]
    fn drift(&self, state: &mut Self::State, s: f64) {
        state.position += state.velocity * s;
    }

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> f64 {
        attitude_apart(&a.attitude, &b.attitude)
            .max(relative(&a.position, &b.position, &self.start.position))
            .max(relative(&a.velocity, &b.velocity, &self.start.velocity))
    }

    #[inline]
    fn reads_velocity(&self) -> bool {
        false
    }
}

impl Turning for Rotor {
    #[inline]
    fn rotational(&self) -> &Rotational {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation {
        state.attitude
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Vector3<f64> {
        state.momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation, momentum: Vector3<f64>) {
        state.attitude = attitude;
        state.momentum = momentum;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<f64> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, rates: &Self::Rates) -> Vector3<f64> {
        rates.torque
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: f64, rates: &Self::Rates) {
        state.momentum += rates.torque * s;
    }

    #[inline]
    fn drift(&self, _state: &mut Self::State, _s: f64) {}

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> f64 {
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

impl Turning for Forced {
    #[inline]
    fn rotational(&self) -> &Rotational {
        &self.rotational
    }

    #[inline]
    fn attitude(&self, state: &Self::State) -> Rotation {
        state.attitude
    }

    #[inline]
    fn momentum(&self, state: &Self::State) -> Vector3<f64> {
        state.momentum
    }

    #[inline]
    fn place(&self, state: &mut Self::State, attitude: Rotation, momentum: Vector3<f64>) {
        state.attitude = attitude;
        state.momentum = momentum;
    }

    #[inline]
    fn spin_of(&self, rates: &Self::Rates) -> Vector3<f64> {
        rates.spin
    }

    #[inline]
    fn torque_of(&self, rates: &Self::Rates) -> Vector3<f64> {
        rates.torque
    }

    #[inline]
    fn kick(&self, state: &mut Self::State, s: f64, rates: &Self::Rates) {
        state.velocity += rates.acceleration * s;
        state.momentum += rates.torque * s;
    }

    #[inline]
    fn drift(&self, state: &mut Self::State, s: f64) {
        state.position += state.velocity * s;
    }

    #[inline]
    fn apart(&self, a: &Self::State, b: &Self::State) -> f64 {
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
fn attitude_apart(a: &Rotation, b: &Rotation) -> f64 {
    (a.as_ref() - b.as_ref()).norm()
}

/// Part of what it was at the start below which a vector counts as come to rest.
const NEAR_REST: f64 = 1e-4;

/// |a − b| over the larger length, or over that of what has come to rest where this is more: forces that cancel leave a rounding of
/// what they were, which of a body at rest is no small part. 0 where all are zero.
#[inline]
fn relative(a: &Vector3<f64>, b: &Vector3<f64>, start: &Vector3<f64>) -> f64 {
    let size = length(a).max(length(b)).max(NEAR_REST * length(start));
    if size == 0.0 { 0.0 } else { length(&(a - b)) / size }
}
