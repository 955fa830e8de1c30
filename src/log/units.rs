//! Units of a file: what the header says, what the user says, and what the numbers show.

use std::f64::consts::PI;

use super::columns::Kind;
use super::euler::Sequence;
use super::layout::{ANGLES, ROLL, Reading, SIGMA};
use super::row::{Part, Row};
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

/// How numbers of a file become SI units, and orientations quaternions.
pub(super) struct Units {
    /// A time of the file at which the log begins, and its unit [s].
    start: f64,
    time: f64,
    /// Of positions, velocities and angular velocities, where it is not one.
    scales: Vec<(Part, f64)>,
    orientation: Orientation,
}

/// What orientations are written as.
enum Orientation {
    Quaternion,
    /// Euler angles, about axes that are named or in the order of the sequence; whether the unit is a guess by their size.
    Angles {
        sequence: Sequence,
        unit: f64,
        by_axis: bool,
        seen: bool,
    },
    Rodrigues,
}

impl Units {
    /// By what is said, by the header, and by what rows show.
    pub fn of(rows: &[Row], reading: &Reading, said: &Said) -> Units {
        let said_angle = said.angle_unit.map(AngleUnit::radians);
        let scales = [
            (Part::Position, reading.unit(1)),
            (Part::Velocity, reading.unit(8)),
            (Part::Spin, reading.unit(11).or(said_angle)),
        ];
        let scale = |(part, unit): (Part, Option<f64>)| Some((part, unit.filter(|unit| *unit != 1.0)?));
        let orientation = match reading.sequence {
            Some(sequence) => angles(rows, reading, sequence, said_angle),
            None if !reading.has_all(4, 4) && reading.has_all(SIGMA, 3) => Orientation::Rodrigues,
            None => Orientation::Quaternion,
        };
        let (start, time) = times(rows, reading, said);
        Units { start, time, scales: scales.into_iter().filter_map(scale).collect(), orientation }
    }

    /// Whether what some rows showed is so in others.
    pub fn holds(&self, rows: &[Row]) -> bool {
        let guessed = matches!(self.orientation, Orientation::Angles { unit: 1.0, seen: true, .. });
        !guessed || !rows.iter().any(more_than_a_turn)
    }

    /// Takes rows to SI units.
    pub fn apply(&self, rows: &mut [Row]) {
        for row in rows {
            if self.time != 1.0 || self.start > 0.0 {
                row.values[0] = (row.values[0] - self.start) * self.time;
            }
            for (part, unit) in &self.scales {
                row.values[part.columns()].iter_mut().for_each(|x| *x *= unit);
            }
            if let Some(q) = self.orientation.quaternion([4, 5, 6].map(|k| row.values[k])) {
                row.values[4..8].copy_from_slice(&q);
            }
        }
    }

    /// What is to be said.
    pub fn notes(&self) -> Vec<String> {
        let (start, unit) = (self.start, self.time);
        let begins = (start > 0.0).then(|| {
            format!("times start at {start} ({} s after 1970): the first row is t = 0", start * unit)
        });
        let in_units = (unit != 1.0).then(|| format!("times are in units of {unit:e} s"));
        let made = match self.orientation {
            Orientation::Quaternion => None,
            Orientation::Rodrigues => {
                Some("orientations are made of modified Rodrigues parameters".to_owned())
            }
            Orientation::Angles { sequence, unit, .. } => {
                let unit = if unit == 1.0 { "radians" } else { "degrees" };
                Some(format!(
                    "orientations are made of Euler angles {sequence} in {unit}; --euler says another sequence"
                ))
            }
        };
        [begins, in_units, made].into_iter().flatten().collect()
    }
}

impl Orientation {
    /// A quaternion of three numbers; `None` where the file has one.
    fn quaternion(&self, given: [f64; 3]) -> Option<[f64; 4]> {
        match *self {
            Orientation::Quaternion => None,
            Orientation::Angles { sequence, unit, by_axis, .. } => {
                let angles = given.map(|angle| angle * unit);
                let mut ordered = angles;
                if by_axis && sequence.of_three_axes() {
                    (0..3).for_each(|axis| ordered[sequence.place_of(axis)] = angles[axis]);
                }
                let q = sequence.rotation(ordered);
                Some([q.w, q.i, q.j, q.k])
            }
            // (1 − σ², 2σ) over 1 + σ².
            Orientation::Rodrigues => {
                let squared: f64 = given.iter().map(|x| x * x).sum();
                let [a, b, c] = given.map(|x| 2.0 * x / (1.0 + squared));
                Some([(1.0 - squared) / (1.0 + squared), a, b, c])
            }
        }
    }
}

/// Euler angles in the unit of the header, else the one that is said, else degrees where an angle is more than a turn in radians.
fn angles(rows: &[Row], reading: &Reading, sequence: Sequence, said: Option<f64>) -> Orientation {
    let by_axis = reading.has_all(ROLL, 3) && !reading.has_all(ANGLES, 3);
    let stated = reading.unit(if by_axis { ROLL } else { ANGLES }).or(said);
    let guess = if rows.iter().any(more_than_a_turn) { PI / 180.0 } else { 1.0 };
    Orientation::Angles { sequence, unit: stated.unwrap_or(guess), by_axis, seen: stated.is_none() }
}

fn more_than_a_turn(row: &Row) -> bool {
    row.values[4..7].iter().any(|x| x.is_finite() && x.abs() > LARGEST_ANGLE)
}

/// The time at which a log begins and its unit [s]; times that count from 1970 count from the first row.
fn times(rows: &[Row], reading: &Reading, said: &Said) -> (f64, f64) {
    let first = rows.iter().map(Row::time).filter(|t| t.is_finite()).fold(f64::INFINITY, f64::min);
    if !first.is_finite() {
        return (0.0, 1.0);
    }
    let stated = said.time_unit.map(TimeUnit::seconds).or(reading.unit(0));
    // A count of seconds since 1970 has ten digits, of milliseconds thirteen, of microseconds sixteen, of nanoseconds nineteen.
    let seen = [1.0, 1e-3, 1e-6, 1e-9].into_iter().find(|unit| (UNIX..UNIX * 1e3).contains(&(first * unit)));
    let unit = stated.or(seen).unwrap_or(1.0);
    (if first * unit >= UNIX { first } else { 0.0 }, unit)
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
