//! The same body described in another way: its points in another order, one of them as two, its inertia in place of them, or other body
//! axes. No motion knows the difference, so no scheme may.

use nalgebra::Vector3;

use super::System;
use super::body::{MassPoint, Shape};
use super::forces::{Argument, Attachment, Forces, Law, PerPoint};
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// 2π (1 − 1/φ) [rad].
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The points in reverse order; `None` for fewer than two.
pub fn permuted<T: Real>(system: &System<T>) -> Option<System<T>> {
    let points: Vec<MassPoint<T>> = system.body.points.iter().rev().copied().collect();
    let last = points.len().checked_sub(1).filter(|last| *last > 0)?;
    let laws = arguments_changed(system, |argument| match argument {
        Argument::PerPoint(PerPoint::Each(mut values)) => {
            values.reverse();
            Argument::PerPoint(PerPoint::Each(values))
        }
        Argument::Attachment(Attachment::Point(index)) => {
            Argument::Attachment(Attachment::Point(last - index))
        }
        other => other,
    });
    Some(system.with_body(system.body.made_of(points), laws))
}

/// The heaviest point as two halves in its place; `None` without points, and over a ground, which bears on points whatever their
/// mass.
pub fn split<T: Real>(system: &System<T>) -> Option<System<T>> {
    let mut points = system.body.points.clone();
    let heaviest = (0..points.len()).reduce(|a, b| if points[b].mass > points[a].mass { b } else { a })?;
    if !system.forces.laws().iter().all(Law::splits) {
        return None;
    }
    let count = points.len();
    points[heaviest].mass = points[heaviest].mass / 2.0;
    points.push(points[heaviest]);
    let halved = |values: &PerPoint<T>| {
        let mut values: Vec<T> = (0..count).map(|index| values.at(index)).collect();
        values[heaviest] = values[heaviest] / 2.0;
        values.push(values[heaviest]);
        PerPoint::Each(values)
    };
    let laws = arguments_changed(system, |argument| match argument {
        Argument::PerPoint(values) => Argument::PerPoint(halved(&values)),
        other => other,
    });
    Some(system.with_body(system.body.made_of(points), laws))
}

/// Every point moved by a part of the body's extent, each in another direction and in as many ways as asked for; `None` without points.
/// The centre of mass of a free body stays where it is.
pub fn moved(system: &System, part: f64, way: usize) -> Option<System> {
    let mut points = system.body.points.clone();
    let size = part * system.body.extent();
    for (index, point) in points.iter_mut().enumerate() {
        // Golden angles never come back to a direction.
        let (turn, height) = (GOLDEN_ANGLE * (index + 1) as f64, GOLDEN_ANGLE * (way + 1) as f64);
        let (sine, cosine) = (turn + height).sin_cos();
        point.position += Vector3::new(cosine, sine, height.sin()) * size;
    }
    if !system.body.pivoted {
        let mass: f64 = points.iter().map(|p| p.mass).sum();
        let center = points.iter().map(|p| p.position * (p.mass / mass)).sum::<Vector3<f64>>();
        points.iter_mut().for_each(|point| point.position -= center);
    }
    let laws = system.forces.laws().to_vec();
    (!points.is_empty()).then(|| system.with_body(system.body.made_of(points), laws))
}

/// Mass and inertia in place of the points; `None` where a law acts on every point.
pub fn by_inertia<T: Real>(system: &System<T>) -> Option<System<T>> {
    let body = &system.body;
    if body.points.is_empty() || system.forces.laws().iter().any(Law::needs_points) {
        return None;
    }
    let laws = arguments_changed(system, |argument| match argument {
        Argument::Attachment(Attachment::Point(index)) => {
            Argument::Attachment(Attachment::At(body.points[index].position))
        }
        other => other,
    });
    Some(system.with_body(body.made_of_stand_in(), laws))
}

/// The same body in other body axes, turned by Q = `turn`: x' = Q x, I' = Q I Qᵀ, R' = R Qᵀ. Everything in world axes
/// stays as it is.
pub fn in_axes(system: &System, turn: &Rotation) -> System {
    let mut new = system.clone();
    let body = &mut new.body;
    body.points.iter_mut().for_each(|point| point.position = turn * point.position);
    body.center = turn * body.center;
    let matrix = turn.to_rotation_matrix().into_inner();
    let inertia = matrix * body.inertia * matrix.transpose();
    body.inertia = (inertia + inertia.transpose()) * 0.5;
    body.principal = turn * body.principal;
    if let Shape::Rod { direction } = &mut body.shape {
        *direction = turn * *direction;
    }
    new.start.orientation *= turn.inverse();
    let in_axes = |law: &Law| {
        let turned = |v: Vector3<f64>| turn * v;
        law.map(|parameter, argument| match law.in_body_axes(parameter) {
            true => match argument {
                Argument::Matrix(given) => Argument::Matrix(matrix * given * matrix.transpose()),
                other => other.map(|x| x, turned),
            },
            false => argument,
        })
    };
    new.forces = Forces::new(system.forces.laws().iter().map(in_axes).collect(), &new.body);
    new
}

/// The laws of a system with their arguments changed.
fn arguments_changed<T: Real>(
    system: &System<T>,
    change: impl Fn(Argument<T>) -> Argument<T>,
) -> Vec<Law<T>> {
    system.forces.laws().iter().map(|law| law.map(|_, argument| change(argument))).collect()
}
