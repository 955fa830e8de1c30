//! A row of a trajectory, and the parts that it may have.

use nalgebra::Vector3;

use super::layout::Reading;

/// Length of a quaternion below which it is none: printed to one digit, a unit quaternion keeps 0.85.
const NO_QUATERNION: f64 = 0.1;

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

    /// What both have.
    pub fn common(self, other: Parts) -> Parts {
        Parts(self.0 & other.0)
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

/// Which parts of rows there are.
#[derive(Debug, Default)]
pub(super) struct Marks {
    /// Rows.
    pub all: usize,
    /// Rows that lack each part for which there are columns, in the order of [`Part::ALL`], and the line of the first.
    pub lacking: [usize; 4],
    first: [Option<u32>; 4],
    untimed: usize,
}

impl Marks {
    /// Says of each row which of `parts` it has, and leaves out those without a time.
    pub fn mark(&mut self, parts: Parts, rows: &mut Vec<Row>) {
        for row in rows.iter_mut() {
            row.parts = parts;
            for part in parts.each() {
                let numbers = &row.values[part.columns()];
                let length = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
                let none = part == Part::Orientation && length < NO_QUATERNION;
                if none || numbers.iter().any(|x| !x.is_finite()) {
                    row.parts = row.parts.without(part);
                    self.lacking[part as usize] += 1;
                    self.first[part as usize].get_or_insert(row.line);
                }
            }
        }
        self.all += rows.len();
        let before = rows.len();
        // A row without any quantity stays: its time may be the end that is asked for.
        rows.retain(|row| row.time().is_finite());
        self.untimed += before - rows.len();
    }

    /// What is to be said of them.
    pub fn notes(&self) -> Vec<String> {
        let note = |part: Part| {
            let (line, count) = (self.first[part as usize]?, self.lacking[part as usize]);
            let (all, word) = (self.all, part.word());
            Some(format!(
                "{count} of {all} rows have no {word} (zeros, NaN, infinity or an empty cell) and were left out where it counts, the first in line {line}"
            ))
        };
        let untimed =
            (self.untimed > 0).then(|| format!("{} rows have no time and were left out", self.untimed));
        Part::ALL.into_iter().filter_map(note).chain(untimed).collect()
    }
}

/// A file: all of its rows, or blocks of consecutive ones.
#[derive(Debug)]
pub(super) struct Log {
    /// In the order of their times.
    pub rows: Vec<Row>,
    /// Rows of a block: those of different blocks are no neighbours.
    pub block: usize,
    /// Rows of the file.
    pub count: usize,
    /// First and last time of the file [s].
    pub span: (f64, f64),
    /// The parts that the file has columns for.
    pub parts: Parts,
    /// Rows that lack each part for which there are columns, in the order of [`Part::ALL`].
    pub lacking: [usize; 4],
    /// How the file was read.
    pub reading: Reading,
    /// What was seen on the way.
    pub notes: Vec<String>,
}

impl Log {
    /// Of all rows.
    pub fn of(rows: Vec<Row>, lacking: [usize; 4], reading: Reading, notes: Vec<String>) -> Log {
        let parts = reading.parts();
        let (block, count, span) = (usize::MAX, 0, (0.0, 0.0));
        let mut log = Log { rows, block, count, span, parts, lacking, reading, notes };
        log.counted();
        log
    }

    /// Counts the rows anew, all of which are here.
    pub fn counted(&mut self) {
        let time = |row: Option<&Row>| row.map_or(0.0, Row::time);
        (self.count, self.span) = (self.rows.len(), (time(self.rows.first()), time(self.rows.last())));
    }

    /// Neighbours.
    pub fn pairs(&self) -> impl Iterator<Item = &[Row]> {
        self.rows.chunks(self.block).flat_map(|block| block.windows(2))
    }
}
