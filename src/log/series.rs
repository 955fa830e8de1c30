//! Errors of a log against time, and deviations of several logs from one another.

use std::fmt::Write;

use super::measure::{Reader, parts_of};
use super::row::{Log, Parts};
use super::track::Track;
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference, larger};

/// How far two times may be apart to be one, over the later: the digits of a log.
const SAME_TIME: f64 = 1e-9;
/// Fewest common times that a line is fitted to.
const FEWEST: usize = 3;

/// Errors at each row, NaN where the row lacks what an error needs.
#[derive(Clone, Debug, Default)]
pub struct Series {
    /// Time [s] and errors.
    pub errors: Vec<(f64, PerQuantity<f64>)>,
    states: Vec<(Snapshot, Parts)>,
}

/// Deviation of two logs in a quantity: d(t) = a + b t and what is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The largest.
    pub largest: f64,
    /// b t over the common times: what grows.
    pub secular: f64,
    /// The largest of what a line leaves.
    pub bounded: f64,
    /// Common times.
    pub times: usize,
}

pub(super) fn series(log: &Log, reader: &Reader, track: &Track) -> Series {
    let mut series = Series::default();
    for (index, row) in log.rows.iter().enumerate() {
        let truth = track.at(index, row.time());
        let state = reader.snapshot(row, Some(&truth));
        let apart = difference(&reader.system.body, &state, &truth);
        let error = PerQuantity::of(|q| if row.parts.covers(parts_of(q)) { apart[q] } else { f64::NAN });
        series.errors.push((row.time(), error));
        series.states.push((state, row.parts));
    }
    series
}

impl Series {
    /// The first line of the table.
    pub fn header() -> String {
        let unit = |q: Quantity| q.unit().replace('/', "_").replace('²', "2").replace(' ', "_");
        let name = |q: Quantity| format!("{}_{}", q.name().replace('-', "_"), unit(q));
        format!("time_s,{}\n", Quantity::ALL.map(name).join(","))
    }

    /// The errors as CSV, an empty cell where there is none.
    pub fn csv(&self) -> String {
        let mut text = Series::header();
        for (time, errors) in &self.errors {
            text += &time.to_string();
            for quantity in Quantity::ALL {
                text.push(',');
                if errors[quantity].is_finite() {
                    // Writing to a string does not fail.
                    let _ = write!(text, "{:e}", errors[quantity]);
                }
            }
            text.push('\n');
        }
        text
    }

    /// The largest error of a quantity in each of so many parts of the run: time [s] and size.
    pub fn largest(&self, quantity: Quantity, parts: usize) -> Vec<(f64, f64)> {
        let piece = self.errors.len().div_ceil(parts).max(1);
        let largest = |rows: &[(f64, PerQuantity<f64>)]| {
            let of = |row: &(f64, PerQuantity<f64>)| (row.0, row.1[quantity]);
            let finite = rows.iter().map(of).filter(|(_, error)| error.is_finite());
            finite.max_by(|a, b| a.1.total_cmp(&b.1))
        };
        self.errors.chunks(piece).filter_map(largest).collect()
    }

    /// What separates two logs at their common times; `None` where they have too few.
    pub fn deviation(&self, other: &Series, system: &System, quantity: Quantity) -> Option<Deviation> {
        let has = |state: &&(Snapshot, Parts)| state.1.covers(parts_of(quantity));
        let mut others = other.states.iter().filter(has).peekable();
        let mut points = Vec::new();
        for (state, _) in self.states.iter().filter(has) {
            let within = SAME_TIME * state.time.abs();
            while others.peek().is_some_and(|(other, _)| other.time < state.time - within) {
                others.next();
            }
            if let Some((other, _)) = others.peek()
                && (other.time - state.time).abs() <= within
            {
                points.push((state.time, difference(&system.body, state, other)[quantity]));
            }
        }
        if points.len() < FEWEST {
            return None;
        }
        let count = points.len() as f64;
        let slope = crate::measure::slope(&points);
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
        let (time, size) = (mean(|point| point.0), mean(|point| point.1));
        let off = |point: &(f64, f64)| (point.1 - size - slope * (point.0 - time)).abs();
        Some(Deviation {
            largest: points.iter().map(|point| point.1).fold(0.0, larger),
            secular: slope * (points[points.len() - 1].0 - points[0].0),
            bounded: points.iter().map(off).fold(0.0, larger),
            times: points.len(),
        })
    }
}
