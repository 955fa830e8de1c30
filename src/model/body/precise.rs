//! A body in another arithmetic.
//!
//! The f64 numbers of a body are taken as exact: of one given by mass points their masses and places, of which mass, centre and inertia are
//! summed anew; of one given by its inertia that, for which the fewest points are made anew. The principal axes are those of the f64 body,
//! moved by as much as f64 rounds them: schemes that go by the axes go by the same ones in every arithmetic.

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::fewest::fewest_points;
use super::{Body, MassPoint, Shape, inertia_of, second_moment_inertia};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Sweeps of Jacobi's method: from axes good to f64 each squares what is left.
const SWEEPS: usize = 4;

impl<T: Real> Body<T> {
    /// The same body in this arithmetic.
    pub(crate) fn of(body: &Body) -> Body<T> {
        let given: Vec<MassPoint<T>> = body
            .points
            .iter()
            .map(|p| MassPoint { mass: T::of(p.mass), position: p.position.map(T::of) })
            .collect();
        let by_points = !body.points.is_empty() && inertia_of(&body.points) == body.inertia;
        let mass = if by_points { given.iter().map(|p| p.mass).sum() } else { T::of(body.mass) };
        let center = if body.pivoted && by_points {
            given.iter().map(|p| p.position * p.mass).sum::<Vector3<T>>() / mass
        } else {
            body.center.map(T::of)
        };
        let inertia = if by_points { inertia_of(&given) } else { body.inertia.map(T::of) };
        let points =
            if by_points || given.is_empty() { given } else { made_for(mass, &inertia, &center, body) };
        let (moments, principal) = diagonalized(&inertia, &body.principal);
        let shape = match body.shape {
            Shape::Point => Shape::Point,
            Shape::Extended => Shape::Extended,
            Shape::Rod { direction } => Shape::Rod { direction: along(&points, &direction) },
        };
        let moments =
            moments.zip_map(&body.moments, |own, f64_moment| if f64_moment == 0.0 { T::zero() } else { own });
        Body { mass, points, center, inertia, moments, principal, shape, pivoted: body.pivoted }
    }
}

/// The fewest points with this mass and inertia.
fn made_for<T: Real>(mass: T, inertia: &Matrix3<T>, center: &Vector3<T>, body: &Body) -> Vec<MassPoint<T>> {
    let about_center = inertia - second_moment_inertia(center) * mass;
    let f64_inertia = about_center.map(T::to_f64);
    let (_, axes) = super::moments::principal_axes(&((f64_inertia + f64_inertia.transpose()) * 0.5));
    let (moments, axes) = diagonalized(&about_center, &axes);
    let points = fewest_points(mass, &moments, &axes, &-center);
    if points.len() == body.points.len() { points } else { Vec::new() }
}

/// The direction of a rod: of the point that is farthest from the origin.
fn along<T: Real>(points: &[MassPoint<T>], direction: &Vector3<f64>) -> Vector3<T> {
    let farther = |a: Vector3<T>, b: Vector3<T>| if b.amax() > a.amax() { b } else { a };
    let far = points.iter().map(|p| p.position).fold(Vector3::zeros(), farther);
    let far = if far.amax() == 0.0 { direction.map(T::of) } else { far };
    let far = far / rotation::length(&far);
    if far.map(T::to_f64).dot(direction) < 0.0 { -far } else { far }
}

/// A rotation with the numbers of an f64 one, brought to length one.
pub(crate) fn rotation_of<T: Real>(rotation: &Rotation) -> Rotation<T> {
    let q = rotation.as_ref();
    Rotation::new_normalize(Quaternion::new(T::of(q.w), T::of(q.i), T::of(q.j), T::of(q.k)))
}

/// Moments and principal axes by Jacobi's method, from axes that are nearly principal. A diagonal inertia keeps its axes.
fn diagonalized<T: Real>(inertia: &Matrix3<T>, near: &Rotation) -> (Vector3<T>, Rotation<T>) {
    let mut axes: Rotation<T> = rotation_of(near);
    let scale = inertia.amax();
    let seen = |axes: &Rotation<T>| {
        let matrix = rotation::axes(axes);
        matrix.transpose() * inertia * matrix
    };
    if scale == 0.0 {
        return (Vector3::zeros(), axes);
    }
    for _ in 0..SWEEPS {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            let matrix = seen(&axes);
            let (off, difference) = (matrix[(i, j)] * 2.0, matrix[(i, i)] - matrix[(j, j)]);
            if off.abs() <= scale * (T::UNIT / 64.0) {
                continue;
            }
            let angle =
                if difference < 0.0 { (-off).atan2(-difference) } else { off.atan2(difference) } / 2.0;
            axes = rotation::renormalized(axes * rotation::turn(&Vector3::ith(k, angle)));
        }
    }
    (seen(&axes).diagonal(), axes)
}
