//! What fixed change explains a log?
//!
//! Each hypothesis is one change, fitted where it has a parameter, and taken back from the log (or put into the reference). It is named
//! only where it leaves nearly nothing of all quantities at once: a unit of w needs the orientation to agree. Hypotheses with fewer
//! parameters go first; those of one rank that explain the log alike are named together.

mod fits;
mod motions;
mod repairs;
mod signals;

use nalgebra::Vector3;
use serde::Serialize;

use super::frames::Convention;
use super::measure::Reader;
use super::row::{Log, Part, Parts, Row};
use super::track::Track;
use crate::model::{Quantity, Snapshot, System, sizes};
use crate::rotation::{self, Rotation};

/// Part of the error that an explanation may leave: what a smooth error of a scheme never loses to a turn, a shift or a scale (a line
/// fitted by a constant keeps half of it), with room for noise and digits.
const LEFT: f64 = 0.02;
/// Error over the size of a quantity that needs no explanation: the digits of a log.
const SMALL: f64 = 1e-8;
/// What the reference may be wrong by, times this, needs none either.
const CLEAR: f64 = 100.0;
/// Rows that are looked at.
const ROWS: usize = 400;
/// How much more than the best an explanation of the same rank may leave to be named beside it.
const ALIKE: f64 = 3.0;

/// Changes of axes, which a start may explain as well.
const OF_AXES: [Change; 4] =
    [Change::BodyAxes, Change::PermutedBoth, Change::PermutedWorld, Change::TurnedWorld];

/// What may have been done to a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Change {
    /// Another unit of a quantity, or of times.
    Unit,
    /// Signs of a quantity or of a component.
    Sign,
    /// Quaternions with the scalar last.
    ScalarLast,
    /// Another convention of orientation or angular velocity.
    Convention,
    /// Euler angles of another sequence.
    Sequence,
    /// Velocities in body axes.
    BodyVelocity,
    /// World axes permuted or mirrored.
    PermutedWorld,
    /// World axes turned.
    TurnedWorld,
    /// World and body axes permuted or mirrored.
    PermutedBoth,
    /// Body axes turned or permuted.
    BodyAxes,
    /// A shift by a row.
    Row,
    /// A shift in time.
    Shift,
    /// A factor of one quantity.
    Scale,
    /// A constant added to one quantity.
    Offset,
    /// Position of another body point.
    BodyPoint,
    /// Values clipped.
    Clipped,
    /// Values wrapped at ±π.
    Wrapped,
    /// Another start.
    Start,
    /// Another inertia.
    Inertia,
    /// Other equations of motion.
    Equations,
    /// Noise.
    Noise,
    /// A known scheme at the log's own step.
    Scheme,
}

/// An explanation of a log.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// What was done.
    pub change: Change,
    /// In words, with what to do.
    pub words: String,
    /// What it leaves, over the sizes of the quantities.
    pub left: f64,
    /// What there was before.
    pub before: f64,
}

impl Explanation {
    /// Whether it is a property of a right log: noise, or the scheme that wrote it.
    pub fn is_remark(&self) -> bool {
        matches!(self.change, Change::Noise | Change::Scheme)
    }
}

/// A hypothesis that was tried: what it leaves.
struct Tried {
    change: Change,
    words: String,
    left: f64,
}

/// The rows that are looked at, as they were read, and the reference at their times.
pub(super) struct Case<'a> {
    log: &'a Log,
    reader: Reader<'a>,
    /// Indices of the rows in the log.
    rows: Vec<usize>,
    states: Vec<Snapshot>,
    truth: Vec<Snapshot>,
    track: &'a Track,
    /// Sizes of the parts.
    sizes: [f64; 4],
}

/// What explains a log; nothing where nothing needs an explanation.
pub(super) fn explain(log: &Log, reader: Reader, track: &Track) -> Vec<Explanation> {
    let Some(case) = Case::of(log, reader, track) else { return Vec::new() };
    let before = case.residual(&case.states, &case.truth);
    let known = (0..4).map(|part| case.known(part)).fold(SMALL, f64::max);
    if before <= known {
        return Vec::new();
    }
    let explained = |tried: Vec<Tried>| -> Vec<Explanation> {
        let allowed = LEFT * before;
        let fits: Vec<Tried> = tried.into_iter().filter(|tried| tried.left <= allowed).collect();
        let best = fits.iter().map(|tried| tried.left).fold(f64::INFINITY, f64::min);
        let alike = fits.into_iter().filter(|tried| tried.left <= ALIKE * best.max(known));
        alike
            .map(|tried| Explanation { change: tried.change, words: tried.words, left: tried.left, before })
            .collect()
    };
    let ranks: [fn(&Case) -> Vec<Tried>; 5] =
        [repairs::tried, signals::tried, fits::of_one_number, fits::of_three_numbers, motions::tried];
    for rank in ranks {
        let mut found = explained(rank(&case));
        if !found.is_empty() {
            if found.iter().any(|explanation| OF_AXES.contains(&explanation.change)) {
                found.extend(explained(motions::start(&case)));
            }
            found.sort_by(|a, b| a.change.cmp(&b.change).then(a.left.total_cmp(&b.left)));
            found.dedup_by_key(|explanation| explanation.change);
            return found;
        }
    }
    let remark = signals::noise(&case, before).or_else(|| motions::scheme(&case));
    remark
        .map(|tried| Explanation { change: tried.change, words: tried.words, left: tried.left, before })
        .into_iter()
        .collect()
}

impl<'a> Case<'a> {
    fn of(log: &'a Log, reader: Reader<'a>, track: &'a Track) -> Option<Case<'a>> {
        let whole = |index: &usize| log.rows[*index].parts == log.parts;
        let all: Vec<usize> = (0..log.rows.len()).filter(whole).collect();
        let stride = all.len().div_ceil(ROWS).max(1);
        let rows: Vec<usize> = all.into_iter().step_by(stride).collect();
        let truth: Vec<Snapshot> =
            rows.iter().map(|row| track.truth(log.rows[*row].time().min(track.last()))).collect();
        let states: Vec<Snapshot> = rows
            .iter()
            .zip(&truth)
            .map(|(row, truth)| reader.snapshot(&log.rows[*row], Some(truth)))
            .collect();
        let own = sizes(reader.system, &track.samples());
        let sizes = [own[Quantity::Position], 1.0, own[Quantity::Velocity], own[Quantity::AngularVelocity]];
        (!rows.is_empty()).then_some(Case { log, reader, rows, states, truth, track, sizes })
    }

    fn log(&self) -> &Log {
        self.log
    }

    fn system(&self) -> &System {
        self.reader.system
    }

    fn parts(&self) -> Parts {
        self.log().parts
    }

    fn row(&self, place: usize) -> &Row {
        &self.log().rows[self.rows[place]]
    }

    /// What the reference may be wrong by in a part, over its size.
    fn known(&self, part: usize) -> f64 {
        let quantity =
            [Quantity::Position, Quantity::Orientation, Quantity::Velocity, Quantity::AngularVelocity][part];
        let size = self.sizes[part];
        if size > 0.0 { CLEAR * self.track.uncertainty[quantity] / size } else { 0.0 }
    }

    /// What separates a state from the reference in a part, over the size of the part.
    fn apart(&self, part: Part, state: &Snapshot, truth: &Snapshot) -> f64 {
        let apart = match part {
            Part::Position => rotation::length(&(state.position - truth.position)),
            Part::Orientation => {
                return crate::model::difference(&self.system().body, state, truth)[Quantity::Orientation];
            }
            Part::Velocity => rotation::length(&(state.velocity - truth.velocity)),
            Part::Spin => rotation::length(&(state.angular_velocity - truth.angular_velocity)),
        };
        let size = self.sizes[part as usize];
        match (size > 0.0, apart > 0.0) {
            (true, _) => apart / size,
            (false, true) => 1.0,
            (false, false) => 0.0,
        }
    }

    /// Root mean square of what separates states from the reference, of the part where it is largest.
    fn residual(&self, states: &[Snapshot], truth: &[Snapshot]) -> f64 {
        let of = |part| {
            let sum: f64 = states.iter().zip(truth).map(|(a, b)| self.apart(part, a, b).powi(2)).sum();
            let mean = (sum / states.len().max(1) as f64).sqrt();
            if mean.is_nan() || states.is_empty() { f64::INFINITY } else { mean }
        };
        self.parts().each().map(of).fold(0.0, f64::max)
    }

    /// What is left where the states are changed.
    fn after(&self, change: impl Fn(&Snapshot) -> Snapshot) -> f64 {
        let changed: Vec<Snapshot> = self.states.iter().map(change).collect();
        self.residual(&changed, &self.truth)
    }

    /// A state that was read with another orientation: an angular velocity in body axes turns along.
    fn with_orientation(&self, state: &Snapshot, orientation: Rotation) -> Snapshot {
        let mut other = Snapshot { orientation, ..*state };
        if self.reader.declared.spin_in_body_axes && self.parts().has(Part::Spin) {
            other.angular_velocity =
                orientation * state.orientation.inverse_transform_vector(&state.angular_velocity);
        }
        other
    }

    /// What is left where rows are read under another convention, perhaps with the scalar last.
    fn read_anew(&self, convention: Convention, scalar_last: bool) -> f64 {
        let state = |place: usize| {
            let mut row = *self.row(place);
            if scalar_last {
                row.values[4..8].rotate_right(1);
            }
            self.reader.snapshot_under(convention, &row, Some(&self.truth[place]))
        };
        let states: Vec<Snapshot> = (0..self.rows.len()).map(state).collect();
        self.residual(&states, &self.truth)
    }

    /// The states of the log against the reference at other times: some parts of it, where the track has them.
    fn at_times(&self, parts: Parts, time: impl Fn(usize) -> Option<f64>) -> f64 {
        let (mut states, mut truth) = (Vec::new(), Vec::new());
        for place in 0..self.rows.len() {
            let Some(t) = time(place).filter(|t| *t >= 0.0 && *t <= self.track.last()) else { continue };
            let (other, own) = (self.track.truth(t), &self.truth[place]);
            let mut moved = *own;
            for part in parts.each() {
                copy(part, &other, &mut moved);
            }
            states.push(self.states[place]);
            truth.push(moved);
        }
        // At least half of the rows must have a partner.
        if 2 * states.len() < self.rows.len() { f64::INFINITY } else { self.residual(&states, &truth) }
    }

    /// The vectors of a part, of the log and of the reference.
    fn vectors(&self, part: Part) -> impl Iterator<Item = (Vector3<f64>, Vector3<f64>)> + '_ {
        self.states.iter().zip(&self.truth).map(move |(a, b)| (vector(part, a), vector(part, b)))
    }
}

/// The parts that are vectors.
const VECTORS: [Part; 3] = [Part::Position, Part::Velocity, Part::Spin];

fn vector(part: Part, state: &Snapshot) -> Vector3<f64> {
    match part {
        Part::Position => state.position,
        Part::Velocity => state.velocity,
        Part::Spin => state.angular_velocity,
        Part::Orientation => rotation::vector_of(&state.orientation),
    }
}

fn with_vector(part: Part, state: &Snapshot, value: Vector3<f64>) -> Snapshot {
    let mut state = *state;
    match part {
        Part::Position => state.position = value,
        Part::Velocity => state.velocity = value,
        Part::Spin => state.angular_velocity = value,
        Part::Orientation => state.orientation = rotation::turn(&value),
    }
    state
}

fn copy(part: Part, from: &Snapshot, to: &mut Snapshot) {
    match part {
        Part::Position => to.position = from.position,
        Part::Velocity => to.velocity = from.velocity,
        Part::Spin => to.angular_velocity = from.angular_velocity,
        Part::Orientation => to.orientation = from.orientation,
    }
}

fn column(part: Part, k: usize) -> &'static str {
    super::row::COLUMNS[part.columns().start + k]
}
