//! Accelerations of a body, and how they are kept in a history that is made for rates.

use nalgebra::Vector3;

use crate::arithmetic::Real;
use crate::model::{Motion, Rates, Turning};
use crate::rotation::Rotation;

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
        let in_body = attitude.inverse_transform_vector(momentum);
        let inverse = model.rotational().inverse_moments;
        let torque = attitude.inverse_transform_vector(&model.torque_of(rates));
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
        let zero = Vector3::zeros();
        R::of(Motion { spin: self.spin, velocity: zero, acceleration: self.velocity, torque: zero })
    }

    /// What was kept.
    #[inline]
    pub(super) fn remembered<R: Rates<T>>(rates: R) -> Accelerations<T> {
        let motion = rates.motion();
        Accelerations { spin: motion.spin, velocity: motion.acceleration }
    }
}
