//! Changes with a parameter that is fitted: a factor, a shift in time, a turn, an offset, another body point.

use nalgebra::Vector3;

use super::repairs::turned;
use super::{Case, Change, Part, Parts, Tried, VECTORS, vector, with_vector};
use crate::model::{Snapshot, System};
use crate::rotation::{self, Rotation};

/// Rows for a parameter: with fewer, a fit says nothing.
const ROWS_EACH: usize = 4;
/// How far a factor must be from one: the errors of schemes that turn too slowly stay below at usable steps.
const A_FACTOR: f64 = 0.02;
/// Times at which a late start is looked for.
const STARTS: usize = 2048;
/// Steps of Gauss and Newton.
const ITERATIONS: usize = 12;

pub(super) fn of_one_number(case: &Case) -> Vec<Tried> {
    let mut tried = Vec::new();
    if case.rows.len() < ROWS_EACH {
        return tried;
    }
    let sets =
        [vec![Part::Position], vec![Part::Velocity], vec![Part::Spin], vec![Part::Position, Part::Velocity]];
    tried.extend(
        sets.iter().filter(|set| case.parts().covers(Parts::of(set))).filter_map(|set| scaled(case, set)),
    );
    let all = case.parts();
    tried.extend(starts(case).into_iter().filter_map(|start| shifted(case, all, start)));
    if all.each().count() > 1 {
        tried.extend(all.each().filter_map(|part| shifted(case, Parts::of(&[part]), 0.0)));
    }
    tried
}

fn scaled(case: &Case, parts: &[Part]) -> Option<Tried> {
    let (mut both, mut own) = (0.0, 0.0);
    for (log, truth) in parts.iter().flat_map(|part| case.vectors(*part)) {
        both += log.dot(&truth);
        own += log.dot(&log);
    }
    let factor = both / own;
    if !factor.is_finite() || (factor - 1.0).abs() < A_FACTOR {
        return None;
    }
    let left = case.after(|state| {
        parts.iter().fold(*state, |state, part| with_vector(*part, &state, vector(*part, &state) * factor))
    });
    let names: Vec<&str> = parts.iter().map(|part| part.word()).collect();
    let words =
        format!("the {} is {:.6} times the reference's throughout", names.join(" and "), 1.0 / factor);
    Some(Tried { change: Change::Scale, words, left })
}

/// Shifts at which the first row or the last is near the reference, besides none.
fn starts(case: &Case) -> Vec<f64> {
    let last = case.track.last();
    let mut starts = vec![0.0];
    for place in [0, case.rows.len() - 1] {
        let apart = |n: usize| {
            let truth = case.track.truth(last * n as f64 / STARTS as f64);
            case.parts().each().map(|part| case.apart(part, &case.states[place], &truth)).fold(0.0, f64::max)
        };
        let distances: Vec<f64> = (0..=STARTS).map(apart).collect();
        let mut dips: Vec<usize> = (0..=STARTS)
            .filter(|n| {
                let here = distances[*n];
                let lower =
                    |other: Option<usize>| other.and_then(|o| distances.get(o)).is_some_and(|d| *d < here);
                !lower(n.checked_sub(1)) && !lower(Some(n + 1))
            })
            .collect();
        dips.sort_by(|a, b| distances[*a].total_cmp(&distances[*b]));
        let time = case.row(place).time();
        starts.extend(dips.into_iter().take(4).map(|n| last * n as f64 / STARTS as f64 - time));
    }
    starts
}

/// Least squares of a shift of some parts, from a first guess [s].
fn shifted(case: &Case, parts: Parts, start: f64) -> Option<Tried> {
    let span = case.track.last();
    let step = span * 1e-6;
    let inside = |t: f64| t >= 2.0 * step && t <= span - 2.0 * step;
    let mut shift = start;
    for _ in 0..ITERATIONS {
        let (mut both, mut own) = (0.0, 0.0);
        for (place, state) in case.states.iter().enumerate() {
            let t = case.row(place).time() + shift;
            if !inside(t) {
                continue;
            }
            let (before, truth, after) =
                (case.track.truth(t - step), case.track.truth(t), case.track.truth(t + step));
            for part in parts.each() {
                let rate = change(part, &before, &after) / (2.0 * step);
                let size = case.sizes[part as usize];
                let weight = if size > 0.0 { 1.0 / (size * size) } else { 0.0 };
                both += weight * change(part, &truth, state).dot(&rate);
                own += weight * rate.norm_squared();
            }
        }
        let by = both / own;
        if !by.is_finite() {
            return None;
        }
        shift += by;
        if by.abs() <= 1e-14 * span {
            break;
        }
    }
    let left = case.at_times(parts, |place| Some(case.row(place).time() + shift));
    let what = if parts == case.parts() {
        "the log".to_owned()
    } else {
        format!("the {}", parts.each().map(Part::word).collect::<Vec<_>>().join(" and "))
    };
    let (sign, by) = (if shift < 0.0 { '-' } else { '+' }, shift.abs());
    let words = format!(
        "{what} shows at t what the reference shows at t {sign} {by:.9} s: a shift in time or a late start"
    );
    Some(Tried { change: Change::Shift, words, left })
}

/// What takes one state to another, in world axes.
fn change(part: Part, from: &Snapshot, to: &Snapshot) -> Vector3<f64> {
    match part {
        Part::Orientation => rotation::vector_of(&(to.orientation * from.orientation.inverse())),
        _ => vector(part, to) - vector(part, from),
    }
}

pub(super) fn of_three_numbers(case: &Case) -> Vec<Tried> {
    if case.rows.len() < 2 * ROWS_EACH {
        return Vec::new();
    }
    let mut tried = vec![world_turned(case)];
    if case.parts().has(Part::Orientation) {
        tried.extend([body_turned(case), both_turned(case)]);
        if case.parts().has(Part::Position) {
            tried.extend([body_point(case, false), body_point(case, true)]);
        }
    }
    tried.extend(VECTORS.into_iter().filter(|part| case.parts().has(*part)).map(|part| offset(case, part)));
    tried
}

/// The rotation that takes vectors of the reference to those of the log.
struct Wahba {
    from: Vec<Vector3<f64>>,
    to: Vec<Vector3<f64>>,
    weights: Vec<f64>,
}

impl Wahba {
    fn of_vectors(case: &Case) -> Wahba {
        let mut pairs = Wahba { from: Vec::new(), to: Vec::new(), weights: Vec::new() };
        for part in VECTORS.into_iter().filter(|part| case.parts().has(*part)) {
            let size = case.sizes[part as usize];
            let weight = if size > 0.0 { 1.0 / (size * size) } else { 0.0 };
            case.vectors(part).for_each(|(log, truth)| pairs.push(truth, log, weight));
        }
        pairs
    }

    fn push(&mut self, from: Vector3<f64>, to: Vector3<f64>, weight: f64) {
        self.from.push(from);
        self.to.push(to);
        self.weights.push(weight);
    }

    fn push_axes(&mut self, from: &Rotation, to: &Rotation) {
        for k in 0..3 {
            let axis = Vector3::ith(k, 1.0);
            self.push(from * axis, to * axis, 1.0);
        }
    }

    fn rotation(&self) -> Rotation {
        rotation::best_fit(&self.from, &self.to, &self.weights)
    }
}

fn with_world_turned(state: &Snapshot, back: &Rotation) -> Snapshot {
    Snapshot {
        position: back * state.position,
        velocity: back * state.velocity,
        angular_velocity: back * state.angular_velocity,
        orientation: back * state.orientation,
        ..*state
    }
}

fn world_turned(case: &Case) -> Tried {
    let mut pairs = Wahba::of_vectors(case);
    if case.parts().has(Part::Orientation) {
        case.states
            .iter()
            .zip(&case.truth)
            .for_each(|(log, own)| pairs.push_axes(&own.orientation, &log.orientation));
    }
    let turn = pairs.rotation();
    let left = case.after(|state| with_world_turned(state, &turn.inverse()));
    Tried { change: Change::TurnedWorld, words: format!("world axes are turned by {}", turned(&turn)), left }
}

fn body_turned(case: &Case) -> Tried {
    let mut pairs = Wahba { from: Vec::new(), to: Vec::new(), weights: Vec::new() };
    for (log, truth) in case.states.iter().zip(&case.truth) {
        pairs.push_axes(&Rotation::identity(), &(truth.orientation.inverse() * log.orientation));
    }
    let turn = pairs.rotation();
    let left = case.after(|state| Snapshot { orientation: state.orientation * turn.inverse(), ..*state });
    Tried { change: Change::BodyAxes, words: format!("body axes are turned by {}", turned(&turn)), left }
}

fn both_turned(case: &Case) -> Tried {
    let mut pairs = Wahba::of_vectors(case);
    for (log, truth) in case.vectors(Part::Orientation) {
        pairs.push(truth, log, 1.0);
    }
    let turn = pairs.rotation();
    let left = case.after(|state| {
        let world = with_world_turned(state, &turn.inverse());
        Snapshot { orientation: world.orientation * turn, ..world }
    });
    let words = format!("axes of world and body are both turned by {}", turned(&turn));
    Tried { change: Change::TurnedWorld, words, left }
}

/// x = X + R d: d is the mean of Rᵀ (x − X).
fn body_point(case: &Case, velocities: bool) -> Tried {
    let turned = |state: &Snapshot, truth: &Snapshot| {
        truth.orientation.inverse_transform_vector(&(state.position - truth.position))
    };
    let sum: Vector3<f64> =
        case.states.iter().zip(&case.truth).map(|(state, truth)| turned(state, truth)).sum();
    let point = sum / case.rows.len() as f64;
    let states: Vec<Snapshot> = case
        .states
        .iter()
        .zip(&case.truth)
        .map(|(state, truth)| {
            let arm = truth.orientation * point;
            let moving = if velocities { truth.angular_velocity.cross(&arm) } else { Vector3::zeros() };
            Snapshot { position: state.position - arm, velocity: state.velocity - moving, ..*state }
        })
        .collect();
    let what = if velocities { "positions and velocities are" } else { "positions are" };
    let words = format!(
        "{what} those of the body point ({:.6}, {:.6}, {:.6}) m from the centre of mass, body axes",
        point.x, point.y, point.z
    );
    Tried { change: Change::BodyPoint, words, left: case.residual(&states, &case.truth) }
}

fn offset(case: &Case, part: Part) -> Tried {
    let sum: Vector3<f64> = case.vectors(part).map(|(log, truth)| log - truth).sum();
    let by = sum / case.rows.len() as f64;
    let left = case.after(|state| with_vector(part, state, vector(part, state) - by));
    let words =
        format!("a constant ({:.6e}, {:.6e}, {:.6e}) is added to the {}", by.x, by.y, by.z, part.word());
    Tried { change: Change::Offset, words, left }
}

/// Whether forces do not depend on the time.
pub(super) fn autonomous(system: &System) -> bool {
    system.forces.fastest_clock() == 0.0
}
