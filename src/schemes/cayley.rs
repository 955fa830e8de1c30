//! Cayley's map in place of the exponential, and the spin of a free step that uses it.

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::iteration::until_settled;
use super::small::{gyroscopic_slope, outer, solved};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};
use crate::rotation::{Rotation, length, normalized};

/// cay(v) = (E − [v]×/2)⁻¹ (E + [v]×/2): the rotation of the quaternion (1, v/2) over its length, by 2 atan(|v|/2).
#[inline]
pub(super) fn cayley<T: Real>(v: &Vector3<T>) -> Rotation<T> {
    normalized(Quaternion::from_parts(T::one(), v / T::of(2.0)))
}

/// The spin ω about principal axes that a step of free motion with Cayley's map turns by, from m = Rᵀ L at its start:
/// I ω + h/2 ω × I ω + h²/4 (ω·I ω) ω = m, the left trivialised derivative of cay⁻¹, by Newton's method.
///
/// # Errors
/// [`Broken::NoConvergence`]; [`Broken::Singular`] where a moment is zero.
#[inline]
pub(super) fn spin_of_step<M: Turning>(
    model: &M,
    h: M::Real,
    momentum: &Vector3<M::Real>,
) -> Result<Vector3<M::Real>, Broken> {
    let moments = &model.rotational().moments;
    let mut spin = momentum.component_div(moments);
    until_settled(model, || {
        let own = moments.component_mul(&spin);
        let energy = spin.dot(&own);
        let left = own + spin.cross(&own) * (h / 2.0) + spin * (energy * h * h / 4.0) - momentum;
        let slope = Matrix3::from_diagonal(moments)
            + gyroscopic_slope(&spin, moments) * (h / 2.0)
            + (Matrix3::from_diagonal_element(energy) + outer(&spin, &own) * M::Real::of(2.0))
                * (h * h / 4.0);
        let change = solved(slope, left).ok_or(Broken::Singular)?;
        spin -= change;
        Ok(if change.amax() == 0.0 { M::Real::of(0.0) } else { length(&change) / length(&spin) })
    })?;
    Ok(spin)
}
