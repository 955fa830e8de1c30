//! The same body described in another way: its points in another order, one of them as two, its inertia in place of them, or other body
//! axes. No motion knows the difference, so no scheme may.

use nalgebra::Vector3;

use super::body::{Body, MassPoint, Shape, second_moment_inertia};
use super::forces::{Attachment, Forces, Law, PerPoint, TorqueAxes};
use super::{Spin, System};
use crate::rotation::Rotation;

/// 2π (1 − 1/φ) [rad].
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The points in reverse order; `None` for fewer than two.
pub fn permuted(system: &System) -> Option<System> {
    let points: Vec<MassPoint> = system.body.points.iter().rev().copied().collect();
    let last = points.len().checked_sub(1).filter(|last| *last > 0)?;
    let reversed = |values: &mut PerPoint| {
        if let PerPoint::Each(values) = values {
            values.reverse();
        }
    };
    let laws = system.forces.laws().iter().cloned().map(|mut law| {
        match &mut law {
            Law::Drag(drag) => reversed(&mut drag.coefficient),
            Law::Lorentz(lorentz) => reversed(&mut lorentz.charge),
            Law::Spring(spring) => {
                if let Attachment::Point(index) = &mut spring.attachment {
                    *index = last - *index;
                }
            }
            _ => {}
        }
        law
    });
    of_points(system, &points, laws.collect())
}

/// The heaviest point as two halves in its place; `None` without points, and over a ground, which bears on points whatever their
/// mass.
pub fn split(system: &System) -> Option<System> {
    let mut points = system.body.points.clone();
    let heaviest = (0..points.len()).max_by(|a, b| points[*a].mass.total_cmp(&points[*b].mass))?;
    if system.forces.laws().iter().any(|law| matches!(law, Law::Ground(_))) {
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
    let laws = system.forces.laws().iter().cloned().map(|mut law| {
        match &mut law {
            Law::Drag(drag) => drag.coefficient = halved(&drag.coefficient),
            Law::Lorentz(lorentz) => lorentz.charge = halved(&lorentz.charge),
            _ => {}
        }
        law
    });
    of_points(system, &points, laws.collect())
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
    let acts_on_points = |law: &Law| law.needs_points();
    if body.points.is_empty() || system.forces.laws().iter().any(acts_on_points) {
        return None;
    }
    let laws = system.forces.laws().iter().cloned().map(|mut law| {
        if let Law::Spring(spring) = &mut law
            && let Attachment::Point(index) = spring.attachment
        {
            spring.attachment = Attachment::At(body.points[index].position);
        }
        law
    });
    let about_center = body.inertia - second_moment_inertia(&body.center) * body.mass;
    let pivot = body.pivoted.then_some(-body.center);
    let told = Body::from_inertia(body.mass, about_center, pivot, false).ok()?;
    started(system, told, laws.collect())
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
    let laws = system.forces.laws().iter().cloned().map(|law| law_in_axes(law, turn));
    new.forces = Forces::new(laws.collect(), &new.body);
    new
}

/// A law whose vectors in body axes are turned; those in world axes stay.
fn law_in_axes(mut law: Law, turn: &Rotation) -> Law {
    match &mut law {
        Law::Spring(spring) => {
            if let Attachment::At(place) = &mut spring.attachment {
                *place = turn * *place;
            }
        }
        Law::Torque(torque) if torque.axes == TorqueAxes::Body => {
            for amplitude in [&mut torque.constant, &mut torque.cosine, &mut torque.sine] {
                *amplitude = turn * *amplitude;
            }
        }
        Law::Dipole(dipole) => dipole.moment = turn * dipole.moment,
        _ => {}
    }
    law
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
