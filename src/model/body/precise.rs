//! A body in another arithmetic.
//!
//! The f64 numbers of a body are taken as exact. A body given by mass points has them, moved by as much as f64 rounds their places: to the
//! centre of mass, and those of a rod to a line. Mass, centre and inertia are summed anew. For a body given by its inertia the points that stand
//! for it are made anew. The principal axes are those of the f64 body, moved by as much as f64 rounds them: schemes that go by the axes go by the
//! same ones in every arithmetic.

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::stand_in::stand_in_points;
use super::{Body, MassPoint, Shape, inertia_of, second_moment_inertia};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Sweeps of Jacobi's method: from axes good to f64 each squares what is left.
const SWEEPS: usize = 4;

/// Units in the last place that the inertia of a few points is off by.
const SUMS: f64 = 64.0;

impl<T: Real> Body<T> {
    /// A body of these points, about the same origin, which differs from this one by rounding: kind and principal axes are those of this
    /// one. Which axes a body has, and in which order, is a choice, and splittings go by them.
    pub(crate) fn made_of(&self, points: Vec<MassPoint<T>>) -> Body<T> {
        let mass: T = points.iter().map(|p| p.mass).sum();
        let center = if self.pivoted { center_of(&points, mass) } else { self.center };
        let inertia = inertia_of(&points);
        let axes = rotation::axes(&self.principal);
        let moments = (axes.transpose() * inertia * axes).diagonal();
        let moments = moments.zip_map(&self.moments, |new, own| if own == 0.0 { T::zero() } else { new });
        Body { mass, points, center, inertia, moments, ..*self }
    }

    /// Whether the body was given by its points: the inertia is their sum to the last bit.
    pub(crate) fn is_given_by_points(&self) -> bool {
        !self.points.is_empty() && inertia_of(&self.points) == self.inertia
    }

    /// Whether the inertia is that of the points to rounding. An inertia may be one of so few points in f64 only.
    pub(crate) fn is_of_its_points(&self) -> bool {
        !self.points.is_empty()
            && (inertia_of(&self.points) - self.inertia).amax() <= self.inertia.amax() * (SUMS * T::UNIT)
    }

    /// The body of the points that stand for this mass, centre and inertia.
    pub(crate) fn made_of_stand_in(&self) -> Body<T> {
        let about_center = self.inertia - second_moment_inertia(&self.center) * self.mass;
        let points = stand_in(self.mass, &about_center, &self.center);
        let inertia = about_center + second_moment_inertia(&self.center) * self.mass;
        Body { points, inertia, ..*self }
    }

    /// The same body in this arithmetic.
    pub(crate) fn of(body: &Body) -> Body<T> {
        let mut given: Vec<MassPoint<T>> = body
            .points
            .iter()
            .map(|p| MassPoint { mass: T::of(p.mass), position: p.position.map(T::of) })
            .collect();
        let by_points = body.is_given_by_points();
        let mass = if by_points { given.iter().map(|p| p.mass).sum() } else { T::of(body.mass) };
        let center = if body.pivoted && by_points { center_of(&given, mass) } else { body.center.map(T::of) };
        if by_points && !body.pivoted {
            // The places are about the centre of mass, to f64's rounding of them.
            let off = center_of(&given, mass);
            given.iter_mut().for_each(|point| point.position -= off);
        }
        if let (true, Shape::Rod { direction }) = (by_points, body.shape) {
            // They lie on a line through the origin, to that rounding.
            let line = along(&given, &direction);
            given.iter_mut().for_each(|point| point.position = line * line.dot(&point.position));
        }
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

/// Σ M X / M [m].
fn center_of<T: Real>(points: &[MassPoint<T>], mass: T) -> Vector3<T> {
    points.iter().map(|p| p.position * p.mass).sum::<Vector3<T>>() / mass
}

/// As many points of this mass and inertia as the f64 body has; none where rounding asks for another number.
fn made_for<T: Real>(mass: T, inertia: &Matrix3<T>, center: &Vector3<T>, body: &Body) -> Vec<MassPoint<T>> {
    let about_center = inertia - second_moment_inertia(center) * mass;
    let points = stand_in(mass, &about_center, center);
    if points.len() == body.points.len() { points } else { Vec::new() }
}

/// The points that stand for this mass, centre and inertia about the centre, about the origin.
fn stand_in<T: Real>(mass: T, about_center: &Matrix3<T>, center: &Vector3<T>) -> Vec<MassPoint<T>> {
    let f64_inertia = about_center.map(T::to_f64);
    let (_, axes) = super::moments::principal_axes(&((f64_inertia + f64_inertia.transpose()) * 0.5));
    let (moments, axes) = diagonalized(about_center, &axes);
    stand_in_points(mass, &moments, &axes, &-center)
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
