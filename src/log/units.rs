//! Units of a file: what the header says, what the user says, and what the numbers show.

use std::f64::consts::PI;

use super::file::Said;
use super::layout::{ANGLES, ROLL, SIGMA};
use super::row::{Log, Part};
use crate::words::words;

words! {
    /// Unit of times.
    TimeUnit {
        #[default]
        /// Seconds.
        Seconds = "s",
        /// Milliseconds.
        Milliseconds = "ms",
        /// Microseconds.
        Microseconds = "us",
        /// Nanoseconds.
        Nanoseconds = "ns",
        /// Minutes.
        Minutes = "min",
    }
}

words! {
    /// Unit of angles.
    AngleUnit {
        #[default]
        /// Radians.
        Radians = "rad",
        /// Degrees.
        Degrees = "deg",
    }
}

/// A first time above which times count from 1970 [s]: March 1973. No scene lasts as long and starts there.
const UNIX: f64 = 1e8;
/// Largest Euler angle in radians: programs print up to a turn.
const LARGEST_ANGLE: f64 = 2.0 * PI * (1.0 + 1e-6);

impl TimeUnit {
    /// Its seconds.
    pub fn seconds(self) -> f64 {
        match self {
            TimeUnit::Seconds => 1.0,
            TimeUnit::Milliseconds => 1e-3,
            TimeUnit::Microseconds => 1e-6,
            TimeUnit::Nanoseconds => 1e-9,
            TimeUnit::Minutes => 60.0,
        }
    }
}

impl AngleUnit {
    /// Its radians.
    pub fn radians(self) -> f64 {
        if self == AngleUnit::Degrees { PI / 180.0 } else { 1.0 }
    }
}

/// Takes a log to SI units, and its orientations to quaternions.
pub(super) fn apply(log: &mut Log, said: &Said) {
    times(log, said);
    let said_angle = said.angle_unit.map(AngleUnit::radians);
    let scales = [
        (Part::Position, log.reading.unit(1)),
        (Part::Velocity, log.reading.unit(8)),
        (Part::Spin, log.reading.unit(11).or(said_angle)),
    ];
    for (part, unit) in scales {
        if let Some(unit) = unit.filter(|unit| *unit != 1.0) {
            let scaled =
                |row: &mut super::row::Row| row.values[part.columns()].iter_mut().for_each(|x| *x *= unit);
            log.rows.iter_mut().for_each(scaled);
        }
    }
    if let Some(sequence) = log.reading.sequence {
        let by_axis = log.reading.has_all(ROLL, 3) && !log.reading.has_all(ANGLES, 3);
        let header = log.reading.unit(if by_axis { ROLL } else { ANGLES });
        let unit = header.or(said_angle).unwrap_or_else(|| seen_unit(log));
        for row in &mut log.rows {
            let angles = [4, 5, 6].map(|k| row.values[k] * unit);
            let ordered = if by_axis && sequence.of_three_axes() {
                let mut ordered = [0.0; 3];
                (0..3).for_each(|axis| ordered[sequence.place_of(axis)] = angles[axis]);
                ordered
            } else {
                angles
            };
            let q = sequence.rotation(ordered);
            row.values[4..8].copy_from_slice(&[q.w, q.i, q.j, q.k]);
        }
        let degrees = if unit == 1.0 { "radians" } else { "degrees" };
        log.notes.push(format!(
            "orientations are made of Euler angles {sequence} in {degrees}; --euler says another sequence"
        ));
    } else if !log.reading.has_all(4, 4) && log.reading.has_all(SIGMA, 3) {
        for row in &mut log.rows {
            let [a, b, c] = [4, 5, 6].map(|k| row.values[k]);
            let squared = a * a + b * b + c * c;
            let (w, v) = ((1.0 - squared) / (1.0 + squared), 2.0 / (1.0 + squared));
            row.values[4..8].copy_from_slice(&[w, v * a, v * b, v * c]);
        }
        log.notes.push("orientations are made of modified Rodrigues parameters".to_owned());
    }
}

/// Degrees where an angle is more than a turn in radians.
fn seen_unit(log: &Log) -> f64 {
    let large = |x: &f64| x.is_finite() && x.abs() > LARGEST_ANGLE;
    if log.rows.iter().any(|row| row.values[4..7].iter().any(large)) { PI / 180.0 } else { 1.0 }
}

/// Times in seconds; those that count from 1970 count from the first row.
fn times(log: &mut Log, said: &Said) {
    let first = log.rows.iter().map(|row| row.time()).filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    if !first.is_finite() {
        return;
    }
    let stated = said.time_unit.map(TimeUnit::seconds).or(log.reading.unit(0));
    // A count of seconds since 1970 has ten digits, of milliseconds thirteen, of microseconds sixteen, of nanoseconds nineteen.
    let seen = [1.0, 1e-3, 1e-6, 1e-9].into_iter().find(|unit| (UNIX..UNIX * 1e3).contains(&(first * unit)));
    let unit = stated.or(seen).unwrap_or(1.0);
    let start = if first * unit >= UNIX { first } else { 0.0 };
    if start > 0.0 {
        log.notes
            .push(format!("times start at {first} ({} s after 1970): the first row is t = 0", first * unit));
    }
    if unit != 1.0 {
        log.notes.push(format!("times are in units of {unit:e} s"));
    }
    if unit != 1.0 || start > 0.0 {
        log.rows.iter_mut().for_each(|row| row.values[0] = (row.values[0] - start) * unit);
    }
}
