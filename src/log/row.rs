//! A row of a trajectory, and the parts that it may have.

use nalgebra::Vector3;

/// The columns of [`Row::values`], in order.
pub(super) const COLUMNS: [&str; 14] =
    ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"];

/// What a log holds besides t: three or four columns each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Position,
    Orientation,
    Velocity,
    Spin,
}

impl Part {
    pub const ALL: [Part; 4] = [Part::Position, Part::Orientation, Part::Velocity, Part::Spin];

    /// Its columns.
    pub fn columns(self) -> std::ops::Range<usize> {
        match self {
            Part::Position => 1..4,
            Part::Orientation => 4..8,
            Part::Velocity => 8..11,
            Part::Spin => 11..14,
        }
    }

    /// Its name in messages.
    pub fn word(self) -> &'static str {
        match self {
            Part::Position => "position",
            Part::Orientation => "orientation",
            Part::Velocity => "velocity",
            Part::Spin => "angular velocity",
        }
    }

    fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// A set of parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Parts(u8);

impl Parts {
    pub fn of(parts: &[Part]) -> Parts {
        Parts(parts.iter().fold(0, |bits, part| bits | part.bit()))
    }

    pub fn has(self, part: Part) -> bool {
        self.0 & part.bit() != 0
    }

    pub fn covers(self, needed: Parts) -> bool {
        self.0 & needed.0 == needed.0
    }

    pub fn without(self, part: Part) -> Parts {
        Parts(self.0 & !part.bit())
    }

    pub fn each(self) -> impl Iterator<Item = Part> {
        Part::ALL.into_iter().filter(move |part| self.has(*part))
    }

    /// The first of `needed` that is not here.
    pub fn missing(self, needed: Parts) -> Option<Part> {
        Part::ALL.into_iter().find(|part| needed.has(*part) && !self.has(*part))
    }
}

/// One row: the columns of [`COLUMNS`], NaN where there is no number, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub values: [f64; 14],
    pub line: u32,
    /// The parts that this row has.
    pub parts: Parts,
}

impl Row {
    pub fn time(&self) -> f64 {
        self.values[0]
    }

    pub fn numbers<const N: usize>(&self, part: Part) -> [f64; N] {
        let columns = &self.values[part.columns()];
        std::array::from_fn(|i| columns[i])
    }

    pub fn vector(&self, part: Part) -> Vector3<f64> {
        Vector3::from(self.numbers::<3>(part))
    }
}

/// A whole file.
#[derive(Debug)]
pub(super) struct Log {
    /// In the order of their times.
    pub rows: Vec<Row>,
    /// The parts that the file has columns for.
    pub parts: Parts,
    /// Rows that lack each part for which there are columns, in the order of [`Part::ALL`].
    pub lacking: [usize; 4],
    /// How the file was read.
    pub reading: super::layout::Reading,
    /// What was seen on the way.
    pub notes: Vec<String>,
}
