//! Principal moments and axes of an inertia, and what rotation means for them.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use super::{BodyError, LARGEST_CONDITION, MassPoint, Shape};
use crate::rotation::{self, Rotation};

/// A rod where no point is off the line through the origin and the farthest point by more than rounding, or
/// by so little that the moments differ by more than [`LARGEST_CONDITION`].
pub(super) fn shape_of_points(points: &[MassPoint], rounding: f64) -> Shape {
    let farthest = points
        .iter()
        .map(|p| p.position)
        .fold(Vector3::zeros(), |a, b| if b.norm() > a.norm() { b } else { a });
    let size = rotation::length(&farthest);
    let direction = farthest / size;
    let off_line = points.iter().map(|p| rotation::length(&p.position.cross(&direction))).fold(0.0, f64::max);
    if off_line <= rounding.max(size / LARGEST_CONDITION.sqrt()) {
        Shape::Rod { direction }
    } else {
        Shape::Extended
    }
}

pub(super) fn shape_of_moments(inertia: &Matrix3<f64>) -> Result<Shape, BodyError> {
    let (moments, axes) = principal_axes(inertia);
    let (smallest, largest) = (moments.min(), moments.max());
    if largest == 0.0 {
        return Ok(Shape::Point);
    }
    if smallest <= 64.0 * f64::EPSILON * largest {
        return Ok(Shape::Rod { direction: axes * Vector3::ith(moments.iamin(), 1.0) });
    }
    if largest > LARGEST_CONDITION * smallest {
        return Err(BodyError::Condition { smallest, largest });
    }
    Ok(Shape::Extended)
}

pub(super) fn symmetric(inertia: &Matrix3<f64>) -> Result<Matrix3<f64>, BodyError> {
    let scale = inertia.amax();
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let difference = inertia[(row, column)] - inertia[(column, row)];
        if difference.abs() > 1e-12 * scale {
            return Err(BodyError::Asymmetric { row, column, difference });
        }
    }
    Ok((inertia + inertia.transpose()) * 0.5)
}

/// Principal moments and the rotation that takes principal axes to the axes of `inertia`.
///
/// A diagonal inertia keeps its own axes, so that bodies given by principal moments stay exact.
pub(crate) fn principal_axes(inertia: &Matrix3<f64>) -> (Vector3<f64>, Rotation) {
    let scale = inertia.amax();
    let off_diagonal = inertia[(0, 1)].abs().max(inertia[(0, 2)].abs()).max(inertia[(1, 2)].abs());
    if scale == 0.0 || !scale.is_finite() || off_diagonal == 0.0 {
        return (inertia.diagonal(), Rotation::identity());
    }
    let eigen = SymmetricEigen::new(inertia / scale);
    let mut axes = eigen.eigenvectors;
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    (eigen.eigenvalues * scale, rotation::from_matrix(&axes))
}

/// Names the axes anew, in their cyclic order, where the second has by far the smallest moment: `rotation::formulas` computes
/// Ω as L over the second moment and what the other two axes take from that, which is lost in its rounding if L over the
/// second moment is the largest number by far.
pub(super) fn thin_axis_outside(moments: Vector3<f64>, principal: Rotation) -> (Vector3<f64>, Rotation) {
    if moments.y == 0.0 || 4.0 * moments.y > moments.x.min(moments.z) {
        return (moments, principal);
    }
    // A third of a turn about the diagonal, x to y to z to x: exact.
    let third = Rotation::new_unchecked(nalgebra::Quaternion::new(0.5, 0.5, 0.5, 0.5));
    (Vector3::new(moments.y, moments.z, moments.x), principal * third)
}

pub(super) fn check_moments(moments: &Vector3<f64>, unphysical: bool) -> Result<(), BodyError> {
    let mut sorted = [moments[0], moments[1], moments[2]];
    sorted.sort_by(f64::total_cmp);
    let [smallest, middle, largest] = sorted;
    // Rounding of an eigenvalue is a few u of the largest one.
    let rounding = 16.0 * f64::EPSILON * largest.abs();
    if smallest < -rounding {
        return Err(BodyError::NegativeMoment { moment: smallest });
    }
    if !unphysical && largest > smallest + middle + rounding {
        return Err(BodyError::Triangle { smallest, middle, largest });
    }
    Ok(())
}
