//! Rotations without quaternions, and quaternions as four numbers.

use super::body::{M, V};
use nalgebra::Vector4;

/// exp of the cross product's matrix by its series, for angles below 2.
pub fn exponential(v: &V) -> M {
    let hat = v.cross_matrix();
    (1..=30).rev().fold(M::identity(), |sum, k| M::identity() + hat * sum / f64::from(k))
}

/// (E − v̂/2)⁻¹ (E + v̂/2).
pub fn cayley(v: &V) -> M {
    let half = v.cross_matrix() / 2.0;
    (M::identity() - half).try_inverse().expect("always") * (M::identity() + half)
}

/// The vector of a matrix's skew part.
pub fn vector_of(a: &M) -> V {
    V::new(a[(2, 1)] - a[(1, 2)], a[(0, 2)] - a[(2, 0)], a[(1, 0)] - a[(0, 1)]) / 2.0
}

/// The vector of [A, B] of two skew matrices, by the matrices.
pub fn commutator(a: &V, b: &V) -> V {
    let (a, b) = (a.cross_matrix(), b.cross_matrix());
    vector_of(&(a * b - b * a))
}

/// Rotation that a quaternion (w, x, y, z) of any length stands for.
pub fn matrix_of(q: &Vector4<f64>) -> M {
    let (w, v) = (q[0], V::new(q[1], q[2], q[3]));
    let hat = v.cross_matrix();
    (M::identity() * (w * w - v.dot(&v)) + v * v.transpose() * 2.0 + hat * (2.0 * w)) / q.norm_squared()
}

/// The quaternion of a rotation by less than half a turn.
pub fn quaternion_of(r: &M) -> Vector4<f64> {
    let w = (1.0 + r.trace()).sqrt() / 2.0;
    let v = vector_of(r) / (2.0 * w);
    Vector4::new(w, v.x, v.y, v.z)
}

/// ½ Ω q as a matrix on four numbers, Ω in world axes.
pub fn slope(spin: &V, q: &Vector4<f64>) -> Vector4<f64> {
    let v = V::new(q[1], q[2], q[3]);
    let across = spin * q[0] + spin.cross(&v);
    Vector4::new(-spin.dot(&v), across.x, across.y, across.z) / 2.0
}
