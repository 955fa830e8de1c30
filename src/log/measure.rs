//! Errors of a log and the metrics of a run, over all of its rows.
//!
//! A piece of the log is held against the reference as a run is. The samples of the reference stand before the rows of every piece, on both
//! sides: what a metric divides by is then that of the whole motion, and memory does not grow with the log.

use rayon::prelude::*;

use super::row::{Log, Part, Parts, Row};
use super::track::Track;
use super::{Convention, Finding, Value};
use crate::measure::{self, Metric, Sight};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference, larger};
use crate::reference::Reference;
use crate::rotation::{self, Rotation};

/// Rows that one thread takes at a time.
const CHUNK: usize = 1 << 12;
/// Length of a quaternion, less one, that is remarked.
const UNIT: f64 = 1e-3;
/// Metrics that a log cannot show: its bodies are rigid.
const NOT_OF_LOGS: &str = "rigidity";

/// Largest and last of a number over rows.
#[derive(Clone, Copy, Debug)]
struct Extreme {
    max: f64,
    /// Time of the largest [s].
    at: f64,
    /// The last, and its row among all.
    end: f64,
    last: usize,
    rows: usize,
}

impl Extreme {
    const NONE: Extreme = Extreme { max: 0.0, at: 0.0, end: f64::NAN, last: 0, rows: 0 };

    fn push(&mut self, value: f64, time: f64, index: usize) {
        self.join(&Extreme { max: value, at: time, end: value, last: index, rows: 1 });
    }

    fn join(&mut self, other: &Extreme) {
        if other.rows == 0 {
            return;
        }
        let max = larger(self.max, other.max);
        // A NaN is the largest of all, where it stands first.
        if self.rows == 0 || max.is_nan() && !self.max.is_nan() || max > self.max {
            self.at = other.at;
        }
        self.max = max;
        (self.end, self.last) = (other.end, other.last);
        self.rows += other.rows;
    }
}

/// What is read over the rows.
struct Readings {
    errors: PerQuantity<Extreme>,
    metrics: Vec<Extreme>,
    /// How far quaternions are off unit length.
    unit: f64,
}

impl Readings {
    fn none() -> Readings {
        Readings {
            errors: PerQuantity::all(Extreme::NONE),
            metrics: vec![Extreme::NONE; metrics().count()],
            unit: 0.0,
        }
    }

    fn join(&mut self, other: &Readings) {
        for quantity in Quantity::ALL {
            self.errors[quantity].join(&other.errors[quantity]);
        }
        self.metrics.iter_mut().zip(&other.metrics).for_each(|(a, b)| a.join(b));
        self.unit = self.unit.max(other.unit);
    }
}

fn metrics() -> impl Iterator<Item = &'static Metric> {
    measure::ALL.iter().filter(|metric| metric.name != NOT_OF_LOGS)
}

/// Rows as states in world axes.
#[derive(Clone, Copy)]
pub(super) struct Reader<'a> {
    pub system: &'a System,
    pub declared: Convention,
}

/// What is measured on a log, row by row.
pub(super) struct Meter<'a> {
    reader: Reader<'a>,
    track: Result<&'a Track, &'a String>,
    grid: Vec<Snapshot>,
    readings: Readings,
    /// Rows so far.
    rows: usize,
}

impl<'a> Meter<'a> {
    pub fn new(reader: Reader<'a>, track: Result<&'a Track, &'a String>) -> Meter<'a> {
        let grid = track.map(|track| track.samples()).unwrap_or_default();
        Meter { reader, track, grid, readings: Readings::none(), rows: 0 }
    }

    /// Measures the next rows.
    pub fn take(&mut self, rows: &[Row]) {
        let (from, grid) = (self.rows, &self.grid);
        self.rows += rows.len();
        let Ok(track) = self.track else { return };
        let read = |(piece, rows)| self.reader.readings(track, grid, rows, from + piece * CHUNK);
        let pieces: Vec<Readings> = rows.par_chunks(CHUNK).enumerate().map(read).collect();
        pieces.iter().for_each(|piece| self.readings.join(piece));
    }

    /// Everything that was measured, of the log whose rows these were.
    pub fn findings(&self, log: &Log, notes: &mut Vec<String>) -> Vec<Finding> {
        let (readings, track) = (&self.readings, self.track);
        if readings.unit > UNIT {
            let off = readings.unit;
            notes.push(format!("quaternions are off unit length by up to {off:.2e} and were normalised"));
        }
        let uncertainty = track.map(|track| track.uncertainty).unwrap_or(PerQuantity::all(f64::NAN));
        let finding = |name, unit, needed, extreme: &Extreme, uncertainty| Finding {
            name,
            unit,
            value: match track {
                Err(why) => Err(format!("no reference: {why}")),
                Ok(_) => value(log, needed, extreme, uncertainty),
            },
        };
        let errors = Quantity::ALL
            .into_iter()
            .map(|q| finding(q.name(), q.unit(), parts_of(q), &readings.errors[q], uncertainty[q]));
        // A metric is a ratio or an angle: the relative uncertainties of what it is made of.
        let relative = relative(self.reader.system, &self.grid, &uncertainty);
        let metrics = metrics().zip(&readings.metrics).map(|(metric, extreme)| {
            finding(metric.name, metric.unit, self.reader.parts_of_metric(metric), extreme, relative)
        });
        errors.chain(metrics).collect()
    }
}

fn value(log: &Log, needed: Parts, extreme: &Extreme, uncertainty: f64) -> Result<Value, String> {
    if let Some(part) = log.parts.missing(needed) {
        return Err(format!("it needs {}", super::row::COLUMNS[part.columns()].join(", ")));
    }
    if extreme.rows == 0 {
        return Err(match needed.each().find(|part| log.lacking[*part as usize] > 0) {
            Some(part) => format!("no row has the {} that it needs", part.word()),
            None => "this motion has none".to_owned(),
        });
    }
    Ok(Value {
        end: (extreme.last + 1 == log.count).then_some(extreme.end),
        max: extreme.max,
        time: extreme.at,
        rows: extreme.rows,
        uncertainty,
    })
}

fn relative(system: &System, grid: &[Snapshot], uncertainty: &PerQuantity<f64>) -> f64 {
    let sizes = crate::model::sizes(system, grid);
    let over = |q: Quantity| if sizes[q] > 0.0 { uncertainty[q] / sizes[q] } else { 0.0 };
    2.0 * (over(Quantity::AngularVelocity) + over(Quantity::Orientation) + over(Quantity::Velocity))
        + f64::EPSILON
}

/// What an error of a quantity needs.
pub(super) fn parts_of(quantity: Quantity) -> Parts {
    Parts::of(match quantity {
        Quantity::Position => &[Part::Position],
        Quantity::Velocity => &[Part::Velocity],
        Quantity::Orientation => &[Part::Orientation],
        Quantity::AngularVelocity => &[Part::Spin],
        Quantity::AngularMomentum => &[Part::Orientation, Part::Spin],
        Quantity::BodyPoint => &[Part::Position, Part::Orientation],
    })
}

/// The rows of a piece that have some parts, after the samples of the reference.
struct Whole {
    parts: Parts,
    states: Vec<Snapshot>,
    reference: Reference,
    /// The last of these rows in the piece.
    last: Option<usize>,
}

impl Whole {
    fn of(parts: Parts, states: Vec<Snapshot>, truth: Vec<Snapshot>, last: Option<usize>) -> Whole {
        let reference = Reference { states: truth, ..Reference::default() };
        Whole { parts, states, reference, last }
    }

    /// Those of a whole piece, of whose states the first `samples` are no rows.
    fn picked(parts: Parts, rows: &[Row], piece: &Whole, samples: usize) -> Whole {
        let kept: Vec<usize> = (0..rows.len()).filter(|index| rows[*index].parts.covers(parts)).collect();
        let pick = |of: &[Snapshot]| {
            let (grid, of) = of.split_at(samples);
            grid.iter().copied().chain(kept.iter().map(|index| of[*index])).collect()
        };
        let (states, truth) = (pick(&piece.states), pick(&piece.reference.states));
        Whole::of(parts, states, truth, kept.last().copied())
    }
}

impl Reader<'_> {
    fn parts_of_metric(&self, metric: &Metric) -> Parts {
        let free = !self.system.body.pivoted;
        match metric.name {
            "total-energy" if free && self.system.forces.laws().is_empty() => {
                Parts::of(&[Part::Velocity, Part::Orientation, Part::Spin])
            }
            "total-energy" if free => Parts::of(&Part::ALL),
            _ => Parts::of(&[Part::Orientation, Part::Spin]),
        }
    }

    fn readings(&self, track: &Track, grid: &[Snapshot], rows: &[Row], from: usize) -> Readings {
        let mut readings = Readings::none();
        let samples = grid.len();
        let (mut truth, mut states) = (grid.to_vec(), grid.to_vec());
        truth.extend(rows.iter().enumerate().map(|(index, row)| track.at(from + index, row.time())));
        states.extend(rows.iter().zip(&truth[samples..]).map(|(row, truth)| self.snapshot(row, Some(truth))));
        let pairs = states[samples..].iter().zip(&truth[samples..]);
        for (index, (row, (state, truth))) in rows.iter().zip(pairs).enumerate() {
            for (quantity, apart) in difference(&self.system.body, state, truth) {
                if row.parts.covers(parts_of(quantity)) {
                    readings.errors[quantity].push(apart, row.time(), from + index);
                }
            }
            if row.parts.has(Part::Orientation) {
                let squared: f64 = row.numbers::<4>(Part::Orientation).iter().map(|x| x * x).sum();
                readings.unit = readings.unit.max((squared.sqrt() - 1.0).abs());
            }
        }
        // Parts that all rows have: what needs no more is read without a copy.
        let common = rows.iter().fold(Parts::of(&Part::ALL), |common, row| common.common(row.parts));
        let piece = Whole::of(common, states, truth, rows.len().checked_sub(1));
        let mut picked = None;
        for (metric, extreme) in metrics().zip(&mut readings.metrics) {
            let needed = self.parts_of_metric(metric);
            let whole = if common.covers(needed) {
                &piece
            } else {
                let made = picked.take().filter(|whole: &Whole| whole.parts == needed);
                picked.insert(made.unwrap_or_else(|| Whole::picked(needed, rows, &piece, samples)))
            };
            let sight = Sight { system: self.system, reference: &whole.reference, states: &whole.states };
            if let (Some(last), Some(reading)) = (whole.last, metric.measure(&sight)) {
                // A metric does not say where its largest is.
                let (max, end, rows) = (reading.max, reading.end, whole.states.len() - samples);
                extreme.join(&Extreme { max, at: f64::NAN, end, last: from + last, rows });
            }
        }
        readings
    }

    /// A row as a start. An angular velocity that the log does not have is the scene's own, turned along with the body.
    pub fn start(&self, row: &Row, own: &Snapshot) -> Snapshot {
        let mut state = self.snapshot(row, Some(own));
        if !row.parts.has(Part::Spin) {
            let turn = state.orientation * own.orientation.inverse();
            state.angular_velocity = turn * own.angular_velocity;
            state.angular_momentum = turn * own.angular_momentum;
        }
        state
    }

    /// A row as a state in world axes; what it does not have is the reference's.
    pub fn snapshot(&self, row: &Row, truth: Option<&Snapshot>) -> Snapshot {
        self.snapshot_under(self.declared, row, truth)
    }

    /// The same under another convention.
    pub fn snapshot_under(&self, convention: Convention, row: &Row, truth: Option<&Snapshot>) -> Snapshot {
        let start = &self.system.start;
        let vector = |part, other: Option<nalgebra::Vector3<f64>>| {
            if row.parts.has(part) { row.vector(part) } else { other.unwrap_or_default() }
        };
        let orientation = match truth {
            _ if row.parts.has(Part::Orientation) => convention.orientation(row),
            Some(truth) => truth.orientation,
            None => Rotation::identity(),
        };
        let written = vector(Part::Spin, truth.map(|truth| truth.angular_velocity));
        let in_body_axes = convention.spin_in_body_axes && row.parts.has(Part::Spin);
        let spin = if in_body_axes { orientation * written } else { written };
        let inertia = self.system.body.inertia;
        Snapshot {
            time: row.time(),
            position: vector(Part::Position, Some(truth.map_or(start.position, |truth| truth.position))),
            velocity: vector(Part::Velocity, Some(truth.map_or(start.velocity, |truth| truth.velocity))),
            orientation,
            angular_velocity: spin,
            angular_momentum: orientation * (inertia * orientation.inverse_transform_vector(&spin)),
            stretch: 0.0,
        }
    }
}

/// Largest |Ω| of a motion [rad/s].
pub(super) fn fastest(states: &[Snapshot]) -> f64 {
    states.iter().map(|state| rotation::length(&state.angular_velocity)).fold(0.0, f64::max)
}
