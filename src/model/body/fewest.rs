//! The fewest mass points that stand for a body given by its inertia.

use nalgebra::Vector3;

use super::MassPoint;
use crate::rotation::Rotation;

/// The fewest mass points with this mass and these principal moments, relative to `origin`; none where the
/// moments are unphysical.
///
/// With a_i² = (I_j + I_k − I_i)/(2M) the second moments of the mass are M a_i². A solid takes the vertices
/// (±a₁, ±a₂, ±a₃) of a tetrahedron, a plate an equilateral triangle stretched to √2 a, a rod ±a.
pub(super) fn fewest_points(
    mass: f64,
    moments: &Vector3<f64>,
    axes: &Rotation,
    origin: &Vector3<f64>,
) -> Vec<MassPoint> {
    let second = Vector3::repeat(moments.sum() / 2.0) - moments;
    let rounding = 64.0 * f64::EPSILON * moments.amax();
    if second.min() < -rounding {
        return Vec::new();
    }
    let a = second.map(|p| if p <= rounding { 0.0 } else { (p / mass).sqrt() });
    let kept: Vec<usize> = (0..3).filter(|i| a[*i] > 0.0).collect();
    let vertices: Vec<Vector3<f64>> = match kept[..] {
        [] => vec![Vector3::zeros()],
        [i] => [1.0, -1.0].map(|s| Vector3::ith(i, s * a[i])).to_vec(),
        [i, j] => {
            let (cosine, sine) = (0.5f64.sqrt(), 1.5f64.sqrt());
            [(2f64.sqrt(), 0.0), (-cosine, sine), (-cosine, -sine)]
                .map(|(x, y)| Vector3::ith(i, x * a[i]) + Vector3::ith(j, y * a[j]))
                .to_vec()
        }
        _ => [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]]
            .map(|signs| Vector3::from(signs).component_mul(&a))
            .to_vec(),
    };
    let share = mass / vertices.len() as f64;
    vertices.iter().map(|v| MassPoint { mass: share, position: axes * v - origin }).collect()
}
