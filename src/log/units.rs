//! Units of a file: what the header says, what the user says, and what the numbers show.

use std::f64::consts::PI;

use super::columns::Kind;
use super::euler::Sequence;
use super::layout::{ANGLES, ROLL, SIGMA};
use super::row::{Log, Part};
use super::said::Said;
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
    match log.reading.sequence {
        Some(sequence) => of_angles(log, sequence, said_angle),
        None if !log.reading.has_all(4, 4) && log.reading.has_all(SIGMA, 3) => of_rodrigues(log),
        None => {}
    }
}

/// Makes quaternions of Euler angles.
fn of_angles(log: &mut Log, sequence: Sequence, said: Option<f64>) {
    let by_axis = log.reading.has_all(ROLL, 3) && !log.reading.has_all(ANGLES, 3);
    let header = log.reading.unit(if by_axis { ROLL } else { ANGLES });
    let unit = header.or(said).unwrap_or_else(|| seen_unit(log));
    for row in &mut log.rows {
        let angles = [4, 5, 6].map(|k| row.values[k] * unit);
        let mut ordered = angles;
        if by_axis && sequence.of_three_axes() {
            (0..3).for_each(|axis| ordered[sequence.place_of(axis)] = angles[axis]);
        }
        let q = sequence.rotation(ordered);
        row.values[4..8].copy_from_slice(&[q.w, q.i, q.j, q.k]);
    }
    let unit = if unit == 1.0 { "radians" } else { "degrees" };
    let note =
        format!("orientations are made of Euler angles {sequence} in {unit}; --euler says another sequence");
    log.notes.push(note);
}

/// Makes quaternions of modified Rodrigues parameters: (1 − σ², 2σ) over 1 + σ².
fn of_rodrigues(log: &mut Log) {
    for row in &mut log.rows {
        let sigma = [4, 5, 6].map(|k| row.values[k]);
        let squared: f64 = sigma.iter().map(|x| x * x).sum();
        let [a, b, c] = sigma.map(|x| 2.0 * x / (1.0 + squared));
        row.values[4..8].copy_from_slice(&[(1.0 - squared) / (1.0 + squared), a, b, c]);
    }
    log.notes.push("orientations are made of modified Rodrigues parameters".to_owned());
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

/// Moves words that are units out of a name of several words.
pub(super) fn take_units(words: &mut Vec<String>, units: &mut Vec<String>) {
    let unit = |word: &str| {
        let known = [
            "deg",
            "degs",
            "degree",
            "degrees",
            "rad",
            "rads",
            "radians",
            "rpm",
            "dps",
            "ft",
            "feet",
            "mm",
            "cm",
            "km",
            "m",
            "ms",
            "us",
            "ns",
            "nsec",
            "nanosec",
            "usec",
            "msec",
            "s",
            "rps",
            "mps",
            "fps",
            "min",
            "nanoseconds",
            "milliseconds",
            "microseconds",
            "sec",
            "seconds",
        ];
        known.contains(&word)
    };
    let mut index = 1;
    while index < words.len() {
        // A last `s` is a component: the scalar of a quaternion.
        let scalar = index + 1 == words.len()
            && words[index] == "s"
            && super::columns::QUATERNIONS.contains(&words[0].as_str());
        if unit(&words[index]) && !scalar {
            units.push(words.remove(index));
        } else {
            index += 1;
        }
    }
}

/// SI units in a stated unit.
pub(super) fn factor(kind: Kind, units: &[String]) -> Option<f64> {
    let has = |names: &[&str]| units.iter().any(|unit| names.contains(&unit.as_str()));
    let first =
        |table: &[(&[&str], f64)]| table.iter().find(|(names, _)| has(names)).map(|(_, factor)| *factor);
    match kind {
        Kind::Time => first(&[
            (&["ns", "nsec", "nanosec", "nanoseconds"], 1e-9),
            (&["us", "µs", "usec", "microseconds"], 1e-6),
            (&["ms", "msec", "milliseconds"], 1e-3),
            (&["min"], 60.0),
            (&["s", "sec", "seconds"], 1.0),
        ]),
        Kind::Position | Kind::Velocity => first(&[
            (&["mm"], 1e-3),
            (&["cm"], 1e-2),
            (&["km"], if kind == Kind::Velocity && has(&["h"]) { 1.0 / 3.6 } else { 1e3 }),
            (&["ft", "feet", "fps"], 0.3048),
            (&["in", "inch", "inches"], 0.0254),
            (&["m", "mps"], 1.0),
        ]),
        Kind::Spin | Kind::Angles | Kind::Roll => first(&[
            (&["deg", "degs", "degree", "degrees", "dps", "°"], PI / 180.0),
            (&["rpm"], PI / 30.0),
            (&["rps"], 2.0 * PI),
            (&["rad", "rads", "radians"], 1.0),
        ]),
        Kind::Quaternion | Kind::Sigma | Kind::Qpos | Kind::Qvel => None,
    }
}
