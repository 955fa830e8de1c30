//! The fewest mass points that stand for a body given by its inertia.

use nalgebra::Vector3;

use super::MassPoint;
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// The fewest mass points with this mass and these principal moments, relative to `origin`; none where the
/// moments are unphysical.
///
/// With a_i² = (I_j + I_k − I_i)/(2M) the second moments of the mass are M a_i². A solid takes the vertices
/// (±a₁, ±a₂, ±a₃) of a tetrahedron, a plate an equilateral triangle stretched to √2 a, a rod ±a.
pub(super) fn fewest_points<T: Real>(
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
    let a = second.map(|p| if p <= rounding { T::zero() } else { (p / mass).sqrt() });
    let kept: Vec<usize> = (0..3).filter(|i| a[*i] > 0.0).collect();
    let vertices: Vec<Vector3<T>> = match kept[..] {
        [] => vec![Vector3::zeros()],
        [i] => [a[i], -a[i]].map(|x| Vector3::ith(i, x)).to_vec(),
        [i, j] => {
            let (cosine, sine) = (T::of(0.5).sqrt(), T::of(1.5).sqrt());
            [(T::of(2.0).sqrt(), T::zero()), (-cosine, sine), (-cosine, -sine)]
                .map(|(x, y)| Vector3::ith(i, x * a[i]) + Vector3::ith(j, y * a[j]))
                .to_vec()
        }
        _ => [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
            .map(|signs| Vector3::from(signs.map(T::of)).component_mul(&a))
            .to_vec(),
    };
    let share = mass / vertices.len() as f64;
    vertices.iter().map(|v| MassPoint { mass: share, position: axes * v - origin }).collect()
}
