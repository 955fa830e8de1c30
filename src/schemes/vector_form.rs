//! The attitude as plain numbers, for schemes that know no rotations: four of a quaternion or nine of a matrix.
//!
//! q may leave the unit sphere within a step; forces and Ω are taken at q/|q|, so that dq/dt is linear in the
//! length of q. A matrix is treated in the same way.

use nalgebra::{Matrix3, Quaternion, Vector3};

use crate::arithmetic::Real;
use crate::model::Turning;
use crate::rotation::Rotation;

/// dq/dt = ½ Ω q, Ω in world axes as the quaternion (0, Ω).
#[inline]
pub(super) fn quaternion_rate<T: Real>(spin: &Vector3<T>, q: &Quaternion<T>) -> Quaternion<T> {
    Quaternion::from_imag(*spin) * q * T::of(0.5)
}

/// Holds `rates` for a time `s` from `from`, but for the attitude, which is given.
#[inline(always)]
pub(super) fn hold<M: Turning>(
    model: &M,
    from: &M::State,
    s: M::Real,
    rates: &M::Rates,
    attitude: Rotation<M::Real>,
    into: &mut M::State,
) {
    model.advance(from, s, rates, into);
    let momentum = model.momentum(into);
    model.place(into, attitude, momentum);
}

/// Gram and Schmidt's process on the columns, from the first on.
#[inline]
pub(super) fn orthonormal<T: Real>(a: &Matrix3<T>) -> Matrix3<T> {
    let x = a.column(0).normalize();
    let y = (a.column(1) - x * x.dot(&a.column(1))).normalize();
    Matrix3::from_columns(&[x, y, x.cross(&y)])
}
