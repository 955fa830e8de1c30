//! Mass points that stand for a body given by its inertia.

use nalgebra::Vector3;

use super::MassPoint;
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// Mass points with this mass and these principal moments, relative to `origin`; none where the moments are unphysical.
///
/// With a_i² = (I_j + I_k − I_i)/(2M) the second moments of the mass are M a_i². On each of the n principal axes where a_i is not
/// zero stand two equal points at ±√n a_i. Third moments are zero: a force that differs from place to place sees the symmetric body
/// that an inertia alone describes.
pub(super) fn stand_in_points<T: Real>(
    mass: T,
    moments: &Vector3<T>,
    axes: &Rotation<T>,
    origin: &Vector3<T>,
) -> Vec<MassPoint<T>> {
    let second = Vector3::repeat(moments.sum() / 2.0) - moments;
    // The inertia is a number of f64: whether it is that of a plate is decided there.
    let rounding = moments.amax() * (64.0 * T::UNIT.max(f64::EPSILON));
    if second.min() < -rounding {
        return Vec::new();
    }
    let kept: Vec<usize> = (0..3).filter(|i| second[*i] > rounding).collect();
    let count = kept.len() as f64;
    let pair = |i: usize| {
        let arm = (second[i] * count / mass).sqrt();
        [arm, -arm].map(|x| Vector3::ith(i, x))
    };
    let places: Vec<Vector3<T>> =
        if kept.is_empty() { vec![Vector3::zeros()] } else { kept.into_iter().flat_map(pair).collect() };
    let share = mass / places.len() as f64;
    places.iter().map(|place| MassPoint { mass: share, position: axes * place - origin }).collect()
}
