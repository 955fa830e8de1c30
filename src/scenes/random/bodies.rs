//! Bodies by chance: a point, rods, mass points with moments up to 10⁴ apart, inertias; on a pivot or free.

use std::fmt::Write;

use nalgebra::{Matrix3, Vector3};

use super::Units;
use crate::model::body::{Body, MassPoint, Shape};
use crate::model::forces::draw::Draw;
use crate::rotation::{self, Rotation};

/// Most mass points.
const MOST_POINTS: usize = 12;
/// Largest ratio of two moments, by which points are stretched or squeezed.
const CONDITION: f64 = 1e4;
/// Slowest and fastest spin of a unit body, forces having rates of about one.
const SPIN: (f64, f64) = (0.03, 30.0);

/// A unit body as a scene gives it.
pub(super) struct Drawn {
    /// The body, about its origin.
    pub body: Body,
    given: Vec<MassPoint>,
    /// Where no points are given.
    inertia: Option<Matrix3<f64>>,
    pivot: Option<Vector3<f64>>,
}

/// How a unit body starts.
pub(super) struct Start {
    pub orientation: Rotation,
    pub position: Option<Vector3<f64>>,
    pub velocity: Option<Vector3<f64>>,
    pub spin: Vector3<f64>,
    /// |Ω|.
    pub rate: f64,
}

impl Drawn {
    pub fn draw(draw: &mut Draw) -> Drawn {
        loop {
            let (given, inertia) = match draw.unit() {
                x if x < 0.06 => (vec![point(draw, Vector3::zeros())], None),
                x if x < 0.16 => (rod(draw), None),
                x if x < 0.8 => (points(draw), None),
                _ => (Vec::new(), Some(inertia(draw))),
            };
            let pivot = draw.chance(0.25).then(|| draw.vector(0.7));
            let body = match &inertia {
                Some(inertia) => Body::from_inertia(1.0, *inertia, pivot, false),
                None => Body::from_points(&given, pivot).map(|(body, _)| body),
            };
            if let Ok(body) = body
                && within_condition(&body)
            {
                return Drawn { body, given, inertia, pivot };
            }
        }
    }

    /// An extended body whose largest moment is so many times the smallest.
    pub fn squeezed(draw: &mut Draw, ratio: (f64, f64)) -> Drawn {
        loop {
            // A body of length 1 and width s has moments of about s² and 1.
            let squeeze = |draw: &mut Draw| draw.logarithmic(1.0 / ratio.1, 1.0 / ratio.0).sqrt();
            let axes = Vector3::new(1.0, squeeze(draw), squeeze(draw));
            let count = 3 + draw.below(MOST_POINTS - 2);
            let given = points_along(draw, count, axes);
            let pivot = draw.chance(0.25).then(|| draw.vector(0.7));
            let Ok((body, _)) = Body::from_points(&given, pivot) else { continue };
            let apart = body.moments.max() / body.moments.min();
            if body.shape == Shape::Extended && (ratio.0..=ratio.1).contains(&apart) {
                return Drawn { body, given, inertia: None, pivot };
            }
        }
    }

    /// The origin of the body, in the frame of the points.
    pub fn origin(&self) -> Vector3<f64> {
        self.pivot.unwrap_or_else(|| self.center())
    }

    /// The centre of mass, in the frame of the points.
    fn center(&self) -> Vector3<f64> {
        let mass: f64 = self.given.iter().map(|p| p.mass).sum();
        let sum: Vector3<f64> = self.given.iter().map(|p| p.position * p.mass).sum();
        if mass > 0.0 { sum / mass } else { Vector3::zeros() }
    }

    pub fn words(&self) -> String {
        let shape = match self.body.shape {
            Shape::Point => "a point".to_owned(),
            Shape::Rod { .. } => format!("a rod of {} points", self.body.points.len()),
            Shape::Extended if self.inertia.is_some() => "a body given by its inertia".to_owned(),
            Shape::Extended => format!("a body of {} points", self.body.points.len()),
        };
        if self.pivot.is_some() { format!("{shape} on a pivot") } else { shape }
    }

    pub fn start(&self, draw: &mut Draw) -> Start {
        let turned = draw.chance(0.7);
        let orientation = if turned { rotation::turn(&draw.vector(2.0)) } else { Rotation::identity() };
        let rate = draw.logarithmic(SPIN.0, SPIN.1);
        let any = draw.vector(rate);
        let spin = match self.body.shape {
            Shape::Point => Vector3::zeros(),
            Shape::Rod { direction } => (orientation * direction).cross(&any),
            // About a principal axis, or about any.
            Shape::Extended if draw.chance(0.1) => {
                orientation * (self.body.principal * Vector3::ith(draw.below(3), rate))
            }
            Shape::Extended => any,
        };
        let free = self.pivot.is_none();
        Start {
            orientation,
            position: (free && draw.chance(0.7)).then(|| draw.vector(2.0)),
            velocity: (free && draw.chance(0.7)).then(|| draw.vector(1.0)),
            spin,
            rate: rotation::length(&spin),
        }
    }

    pub fn text(&self, units: &Units) -> String {
        let mut text = String::new();
        match &self.inertia {
            Some(inertia) => {
                let rows: Vec<String> =
                    (0..3).map(|i| vector(&(inertia.row(i).transpose() * units.inertia()))).collect();
                text += &format!("mass = {:?}\ninertia = [{}]\n", units.mass, rows.join(", "));
            }
            None => {
                text += "points = [\n";
                for point in &self.given {
                    let (mass, position) = (point.mass * units.mass, point.position * units.length);
                    // Writing to a string cannot fail.
                    let _ = writeln!(text, "  {{ mass = {mass:?}, position = {} }},", vector(&position));
                }
                text += "]\n";
            }
        }
        if let Some(pivot) = self.pivot {
            text += &format!("pivot = {}\n", vector(&(pivot * units.length)));
        }
        text
    }
}

impl Start {
    pub fn text(&self, units: &Units) -> String {
        let q = self.orientation;
        let mut text = format!("orientation = [{:?}, {:?}, {:?}, {:?}]\n", q.w, q.i, q.j, q.k);
        if let Some(position) = self.position {
            text += &format!("position = {}\n", vector(&(position * units.length)));
        }
        if let Some(velocity) = self.velocity {
            text += &format!("velocity = {}\n", vector(&(velocity * units.velocity())));
        }
        if self.rate > 0.0 {
            text += &format!("angular_velocity = {}\n", vector(&(self.spin / units.time)));
        }
        text
    }
}

/// A vector as a scene file has it.
pub(super) fn vector(v: &Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

fn within_condition(body: &Body) -> bool {
    match body.shape {
        Shape::Extended => body.moments.max() <= CONDITION * body.moments.min(),
        _ => true,
    }
}

fn point(draw: &mut Draw, position: Vector3<f64>) -> MassPoint {
    MassPoint { mass: draw.logarithmic(0.1, 1.0), position }
}

/// Two to six points on a line, exactly where numbers are dyadic.
fn rod(draw: &mut Draw) -> Vec<MassPoint> {
    let sixteenths = |v: Vector3<f64>| v.map(|x| (x * 16.0).round() / 16.0);
    let (from, along) = (sixteenths(draw.vector(0.5)), sixteenths(draw.vector(1.0)));
    let count = 2 + draw.below(5);
    (0..count)
        .map(|k| {
            let place = (k as f64 + draw.between(-0.25, 0.25)) / count as f64;
            let place = if draw.dyadic { (place * 64.0).round() / 64.0 } else { place };
            point(draw, from + along * place)
        })
        .collect()
}

/// Three to twelve points, stretched along two axes by up to the root of the largest condition.
fn points(draw: &mut Draw) -> Vec<MassPoint> {
    let count = 3 + draw.below(MOST_POINTS - 2);
    let squeezed = |draw: &mut Draw| if draw.chance(0.5) { 1.0 } else { draw.logarithmic(0.01, 1.0) };
    let axes = Vector3::new(1.0, squeezed(draw), squeezed(draw));
    points_along(draw, count, axes)
}

/// So many points, stretched along these axes.
fn points_along(draw: &mut Draw, count: usize, axes: Vector3<f64>) -> Vec<MassPoint> {
    let turn = if draw.chance(0.5) { rotation::turn(&draw.vector(1.5)) } else { Rotation::identity() };
    let off = draw.vector(0.5);
    (0..count)
        .map(|_| {
            let place = off + turn * draw.vector(0.8).component_mul(&axes);
            let place = place.map(|x| draw.number(x));
            point(draw, place)
        })
        .collect()
}

/// An inertia that a body can have, about axes of its own or of the scene.
fn inertia(draw: &mut Draw) -> Matrix3<f64> {
    let squeezed =
        |draw: &mut Draw| if draw.chance(0.5) { draw.between(0.1, 1.0) } else { draw.logarithmic(1e-4, 1.0) };
    let second = Vector3::new(1.0, squeezed(draw), squeezed(draw));
    let symmetric = draw.chance(0.15);
    let second = if symmetric { Vector3::new(second.x, second.y, second.y) } else { second };
    let diagonal = Matrix3::from_diagonal(&(Vector3::repeat(second.sum()) - second));
    if draw.chance(0.5) {
        return diagonal;
    }
    let axes = rotation::turn(&draw.vector(1.5)).to_rotation_matrix().into_inner();
    let turned = axes * diagonal * axes.transpose();
    (turned + turned.transpose()) * 0.5
}
