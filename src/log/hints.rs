//! What a log probably meant: another unit, a turned sign, a quaternion in another order.
//!
//! A quantity l of the log is held against the reference's r: s = Σ l·r / Σ l·l is the factor that takes one to
//! the other, and √(1 − (Σ l·r)²/(Σ l·l Σ r·r)) is what no factor explains. A factor that is a known unit is a
//! hint, where little is left. A turned sign of one component is a hint where it takes away nearly all of the
//! error.

use std::f64::consts::PI;

use nalgebra::Vector3;

use super::file::{COLUMNS, Part};
use super::frames::{Convention, FrameCheck};

/// What may be left of a quantity that a unit explains, relative.
const LEFT: f64 = 0.1;
/// How near a factor must be to that of a unit, relative.
const NEAR: f64 = 0.02;
/// Part of the squared error that may be left by what explains it.
const EXPLAINED: f64 = 0.01;
/// Mean squared orientation error [rad²] below which nothing needs an explanation.
const SMALL: f64 = 0.01;

const LENGTHS: [(f64, &str); 4] =
    [(0.01, "centimetres"), (0.001, "millimetres"), (0.3048, "feet"), (0.0254, "inches")];
const SPINS: [(f64, &str); 2] = [(PI / 180.0, "degrees per second"), (PI / 30.0, "turns per minute")];
const TIMES: [(f64, &str); 3] = [(1e-3, "milliseconds"), (1e-6, "microseconds"), (1e-9, "nanoseconds")];

/// Sums over the rows of one quantity.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    log: f64,
    reference: f64,
    apart: f64,
    both: [f64; 3],
}

impl Sums {
    pub fn push(&mut self, log: &Vector3<f64>, reference: &Vector3<f64>) {
        self.log += log.norm_squared();
        self.reference += reference.norm_squared();
        self.apart += (log - reference).norm_squared();
        (0..3).for_each(|k| self.both[k] += log[k] * reference[k]);
    }

    pub fn add(&mut self, other: &Sums) {
        self.log += other.log;
        self.reference += other.reference;
        self.apart += other.apart;
        (0..3).for_each(|k| self.both[k] += other.both[k]);
    }

    fn factor(&self) -> Option<f64> {
        let both: f64 = self.both.iter().sum();
        let explained = both * both / (self.log * self.reference);
        (self.log > 0.0 && self.reference > 0.0 && 1.0 - explained < LEFT * LEFT).then(|| both / self.log)
    }

    /// Hints on a part of the log.
    pub fn hints(&self, part: Part) -> Vec<String> {
        let (what, units) = match part {
            Part::Position => ("positions", &LENGTHS[..]),
            Part::Velocity => ("velocities", &LENGTHS[..]),
            Part::Spin => ("angular velocities", &SPINS[..]),
            Part::Orientation => return Vec::new(),
        };
        let Some(factor) = self.factor() else { return self.turned_component(part) };
        if near(factor, -1.0) {
            return vec![format!("{what} look turned round: every sign is the other one")];
        }
        let a_second = if part == Part::Velocity { " a second" } else { "" };
        match units.iter().find(|(unit, _)| near(factor, *unit)) {
            Some((_, name)) => vec![format!(
                "{what} look like {name}{a_second}: they are {:.4} times the reference's",
                1.0 / factor
            )],
            None if (factor - 1.0).abs() > NEAR => {
                vec![format!(
                    "{what} are {:.4} times the reference's throughout: another unit?",
                    1.0 / factor
                )]
            }
            None => self.turned_component(part),
        }
    }

    fn turned_component(&self, part: Part) -> Vec<String> {
        let left = |k: usize| self.apart + 4.0 * self.both[k];
        let turned = (0..3).find(|k| self.apart > 0.0 && left(*k) < EXPLAINED * self.apart);
        let name = |k: usize| COLUMNS[part.columns().start + k];
        turned.map(|k| format!("the sign of {} looks turned", name(k))).into_iter().collect()
    }
}

/// Squared orientation errors [rad²], summed: as written, read as x, y, z, w, and inverted.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Orientations {
    pub written: f64,
    pub scalar_last: f64,
    pub inverted: f64,
    pub rows: f64,
}

impl Orientations {
    pub fn add(&mut self, other: &Orientations) {
        self.written += other.written;
        self.scalar_last += other.scalar_last;
        self.inverted += other.inverted;
        self.rows += other.rows;
    }

    /// Whether the orientations, as they were declared, are the reference's.
    pub fn agree(&self) -> bool {
        self.rows > 0.0 && self.written <= SMALL * self.rows
    }

    pub fn hints(&self) -> Vec<String> {
        let explains = |other: f64| self.written > SMALL * self.rows && other < EXPLAINED * self.written;
        let mut hints = Vec::new();
        if explains(self.scalar_last) {
            hints.push(
                "the quaternion looks as if its columns held x, y, z, w: write the scalar into qw".to_owned(),
            );
        }
        if explains(self.inverted) {
            hints.push("the quaternion looks inverted: try the other --quaternion".to_owned());
        }
        hints
    }
}

/// Hints of the frame check: units, and the sign of w.
pub(super) fn of_frames(check: &FrameCheck) -> Vec<String> {
    let mut hints = Vec::new();
    let fitting = match check {
        FrameCheck::Follows(fit) => Some(fit),
        FrameCheck::Alike(fits) => fits.first(),
        FrameCheck::None(_) | FrameCheck::Nothing(_) => None,
    };
    if let Some(fit) = fitting
        && !near(fit.factor, 1.0)
    {
        let factor = fit.factor.abs();
        if fit.factor < 0.0 {
            hints.push("the sign of w looks turned: dq/dt goes the other way".to_owned());
        }
        let unit = SPINS.iter().map(|(unit, name)| (unit, "angular velocities", name));
        let time = TIMES.iter().map(|(unit, name)| (unit, "times", name));
        hints.push(match unit.chain(time).find(|(unit, _, _)| near(factor, **unit)) {
            Some((_, what, name)) => format!("{what} look like {name}: dq/dt is {factor:.4e} of what w says"),
            None if near(factor, 1.0) => return hints,
            None => format!("dq/dt is {factor:.4} of what w says: w, or t, is in another unit"),
        });
    }
    hints
}

/// A hint where the times are many times the duration of the scene [s].
pub(super) fn of_times(last: f64, duration: f64) -> Option<String> {
    let ratio = last / duration;
    let like = TIMES.iter().find(|(unit, _)| ratio * unit > 0.05 && ratio * unit < 2.0);
    match like {
        _ if ratio < 20.0 => None,
        Some((_, name)) => {
            Some(format!("times look like {name}: the log ends at t = {last}, the scene lasts {duration} s"))
        }
        None => Some(format!(
            "the log ends at t = {last} s, the scene lasts {duration} s: times count from the start of the motion"
        )),
    }
}

fn near(factor: f64, unit: f64) -> bool {
    (factor / unit - 1.0).abs() < NEAR
}

/// The convention that a log follows, where one alone fits.
pub(super) fn followed(check: &FrameCheck) -> Option<Convention> {
    if let FrameCheck::Follows(fit) = check { Some(fit.convention) } else { None }
}
