//! The same body described in another way: its points in another order, one of them as two, its inertia in place of them, or other body
//! axes. No motion knows the difference, so no scheme may.

use nalgebra::Vector3;

use super::body::{Body, MassPoint, Shape, second_moment_inertia};
use super::forces::{Argument, Attachment, Forces, Law, PerPoint};
use super::{Spin, System};
use crate::rotation::Rotation;

/// 2π (1 − 1/φ) [rad].
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The points in reverse order; `None` for fewer than two.
pub fn permuted(system: &System) -> Option<System> {
    let points: Vec<MassPoint> = system.body.points.iter().rev().copied().collect();
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
    of_points(system, &points, laws)
}

/// The heaviest point as two halves in its place; `None` without points, and over a ground, which bears on points whatever their
/// mass.
pub fn split(system: &System) -> Option<System> {
    let mut points = system.body.points.clone();
    let heaviest = (0..points.len()).max_by(|a, b| points[*a].mass.total_cmp(&points[*b].mass))?;
    if !system.forces.laws().iter().all(Law::splits) {
        return None;
    }
    let count = points.len();
    points[heaviest].mass *= 0.5;
    points.push(points[heaviest]);
    let halved = |values: &PerPoint| {
        let mut values: Vec<f64> = (0..count).map(|index| values.at(index)).collect();
        values[heaviest] *= 0.5;
        values.push(values[heaviest]);
        PerPoint::Each(values)
    };
    let laws = arguments_changed(system, |argument| match argument {
        Argument::PerPoint(values) => Argument::PerPoint(halved(&values)),
        other => other,
    });
    of_points(system, &points, laws)
}

/// Every point moved by a part of the body's extent, each in another direction and in as many ways as asked for; `None` without points.
pub fn moved(system: &System, part: f64, way: usize) -> Option<System> {
    let mut points = system.body.points.clone();
    let size = part * system.body.extent();
    for (index, point) in points.iter_mut().enumerate() {
        // Golden angles never come back to a direction.
        let (turn, height) = (GOLDEN_ANGLE * (index + 1) as f64, GOLDEN_ANGLE * (way + 1) as f64);
        let (sine, cosine) = (turn + height).sin_cos();
        point.position += Vector3::new(cosine, sine, height.sin()) * size;
    }
    of_points(system, &points, system.forces.laws().to_vec())
}

/// Mass and inertia in place of the points; `None` where a law acts on every point.
pub fn by_inertia(system: &System) -> Option<System> {
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
    let about_center = body.inertia - second_moment_inertia(&body.center) * body.mass;
    let pivot = body.pivoted.then_some(-body.center);
    let told = Body::from_inertia(body.mass, about_center, pivot, false).ok()?;
    started(system, told, laws)
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
            true => argument.map(|x| x, turned),
            false => argument,
        })
    };
    new.forces = Forces::new(system.forces.laws().iter().map(in_axes).collect(), &new.body);
    new
}

/// The laws of a system with their arguments changed.
fn arguments_changed(system: &System, change: impl Fn(Argument) -> Argument) -> Vec<Law> {
    system.forces.laws().iter().map(|law| law.map(|_, argument| change(argument))).collect()
}

/// The points stand about the body's origin already: a pivot is there, and a free body's centre of mass to rounding.
fn of_points(system: &System, points: &[MassPoint], laws: Vec<Law>) -> Option<System> {
    let pivot = system.body.pivoted.then(Vector3::zeros);
    let (body, _) = Body::from_points(points, pivot).ok()?;
    started(system, body, laws)
}

fn started(system: &System, mut body: Body, laws: Vec<Law>) -> Option<System> {
    let start = system.start;
    let spin = Spin::Momentum(start.angular_momentum);
    // A body that rounding has given another shape is another body.
    if std::mem::discriminant(&body.shape) != std::mem::discriminant(&system.body.shape) {
        return None;
    }
    // Which principal axes a body has, and in which order, is for who tells it to choose; splittings go by them.
    let axes = system.body.principal.to_rotation_matrix().into_inner();
    let moments = (axes.transpose() * body.inertia * axes).diagonal();
    body.principal = system.body.principal;
    body.moments = moments.zip_map(&system.body.moments, |told, own| if own == 0.0 { 0.0 } else { told });
    System::new(body, laws, start.position, start.orientation, start.velocity, spin).ok()
}
