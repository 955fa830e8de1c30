//! A trajectory file: a header, then a row a time. Columns may be missing, more are ignored.

use std::path::Path;

use rayon::prelude::*;

use crate::bounded::{self, FileError};

/// The columns that are read, in the order of [`Row`].
pub(super) const COLUMNS: [&str; 14] =
    ["t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"];
/// Bytes that one thread reads at a time.
const PIECE: usize = 1 << 20;

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
}

/// One row: the columns of [`COLUMNS`], 0 where the file has none, and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub values: [f64; 14],
    pub line: usize,
}

impl Row {
    pub fn time(&self) -> f64 {
        self.values[0]
    }

    fn is_finite(&self) -> bool {
        self.values.iter().all(|value| value.is_finite())
    }

    pub fn numbers<const N: usize>(&self, part: Part) -> [f64; N] {
        let columns = &self.values[part.columns()];
        std::array::from_fn(|i| columns[i])
    }
}

/// A whole file.
#[derive(Debug)]
pub(super) struct Log {
    pub rows: Vec<Row>,
    /// Which parts it has, in the order of [`Part::ALL`].
    pub has: [bool; 4],
    /// What was seen on the way.
    pub notes: Vec<String>,
}

impl Log {
    pub fn has(&self, part: Part) -> bool {
        self.has[part as usize]
    }
}

/// Reads a file.
pub(super) fn read(path: &Path) -> Result<Log, FileError> {
    let text = bounded::text(path, bounded::MOST_OF_A_LOG)?;
    parse(&text, &path.display().to_string())
}

/// Reads the text of a file.
pub(super) fn parse(text: &str, file: &str) -> Result<Log, FileError> {
    let refuse = |line, why: String| FileError::Content { file: file.to_owned(), line, why };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let Some(first) = text.lines().position(|line| !line.trim().is_empty()) else {
        return Err(refuse(1, format!("the file is empty: write a header {}, then rows", COLUMNS.join(","))));
    };
    let head = text.lines().nth(first).unwrap_or_default();
    let after = text.splitn(first + 2, '\n').nth(first + 1).unwrap_or_default();
    let (columns, has, mut notes) = header(head).map_err(|why| refuse(first + 1, why))?;
    let pieces: Vec<Piece> = pieces(after).into_par_iter().map(|piece| read_piece(piece, &columns)).collect();
    let mut rows = Vec::with_capacity(pieces.iter().map(|piece| piece.rows.len()).sum());
    let (mut before, mut not_finite) = (first + 1, Vec::new());
    let last = pieces.len();
    for (index, mut piece) in pieces.into_iter().enumerate() {
        if let Some((line, issue)) = piece.issue {
            let cut = index + 1 == last && line == piece.lines && !text.ends_with('\n');
            match issue {
                Issue::Short if cut => {
                    notes.push(format!("the last row, line {}, is cut and was left out", before + line));
                }
                issue => return Err(refuse(before + line, issue.in_words())),
            }
        }
        piece.rows.iter_mut().for_each(|row| row.line += before);
        rows.append(&mut piece.rows);
        not_finite.extend(piece.not_finite.iter().map(|line| line + before));
        before += piece.lines;
    }
    if let Some(line) = not_finite.first() {
        let count = not_finite.len();
        notes.push(format!(
            "{count} rows hold NaN, infinity or an empty cell and were left out, the first in line {line}"
        ));
    }
    match (rows.is_empty(), not_finite.first()) {
        (true, None) => {
            Err(refuse(first + 2, "there is a header and no whole row: nothing to judge".to_owned()))
        }
        (true, Some(line)) => Err(refuse(*line, "no row has finite numbers: nothing to judge".to_owned())),
        _ => Ok(Log { rows, has, notes }),
    }
}

/// Some lines of a file, read; lines are counted from 1 in the piece.
#[derive(Default)]
struct Piece {
    rows: Vec<Row>,
    not_finite: Vec<usize>,
    /// The first line that is no row, where there is one; nothing after it was read.
    issue: Option<(usize, Issue)>,
    lines: usize,
}

/// What is wrong with a line.
enum Issue {
    Short,
    NoNumber { column: usize, text: String },
}

impl Issue {
    fn in_words(&self) -> String {
        match self {
            Issue::Short => "the row has fewer columns than the header".to_owned(),
            Issue::NoNumber { column, text } => {
                format!("column {} holds '{text}', which is not a number", COLUMNS[*column])
            }
        }
    }
}

/// The text in pieces of about [`PIECE`], each of whole lines.
fn pieces(mut text: &str) -> Vec<&str> {
    let mut pieces = Vec::new();
    while text.len() > PIECE {
        let end = text.as_bytes()[PIECE..].iter().position(|byte| *byte == b'\n');
        let Some(end) = end else { break };
        let (piece, rest) = text.split_at(PIECE + end + 1);
        pieces.push(piece);
        text = rest;
    }
    if !text.is_empty() {
        pieces.push(text);
    }
    pieces
}

fn read_piece(text: &str, columns: &[Option<usize>]) -> Piece {
    let mut piece = Piece::default();
    for line in text.lines() {
        piece.lines += 1;
        match row(line, columns) {
            Ok(Some(mut row)) if row.is_finite() => {
                row.line = piece.lines;
                piece.rows.push(row);
            }
            Ok(Some(_)) => piece.not_finite.push(piece.lines),
            Ok(None) => {}
            Err(issue) => {
                piece.issue = Some((piece.lines, issue));
                break;
            }
        }
    }
    piece
}

type Header = (Vec<Option<usize>>, [bool; 4], Vec<String>);

/// Which column each field of the file is, and which parts there are.
fn header(line: &str) -> Result<Header, String> {
    let names: Vec<&str> = line.split(',').map(|name| name.trim().trim_matches('"')).collect();
    let columns: Vec<Option<usize>> =
        names.iter().map(|name| COLUMNS.iter().position(|column| column == name)).collect();
    for (index, column) in COLUMNS.iter().enumerate() {
        if columns.iter().filter(|c| **c == Some(index)).count() > 1 {
            return Err(format!("the column {column} stands twice"));
        }
    }
    if !columns.contains(&Some(0)) {
        let other = [';', '\t'].into_iter().find(|other| line.contains(*other));
        let separated = other.map_or("", |_| "; columns are separated by commas");
        return Err(format!("there is no column t; expected are {}{separated}", COLUMNS.join(",")));
    }
    let mut has = [false; 4];
    let mut notes = Vec::new();
    for part in Part::ALL {
        let missing: Vec<&str> = part
            .columns()
            .filter(|column| !columns.contains(&Some(*column)))
            .map(|column| COLUMNS[column])
            .collect();
        has[part as usize] = missing.is_empty();
        if !missing.is_empty() {
            notes.push(format!("no column {}: what needs it is not applicable", missing.join(", ")));
        }
    }
    if has == [false; 4] {
        return Err(format!("there is no whole quantity beside t; expected are {}", COLUMNS.join(",")));
    }
    Ok((columns, has, notes))
}

/// A line as a row; `None` where it is blank. An empty cell is no number.
fn row(text: &str, columns: &[Option<usize>]) -> Result<Option<Row>, Issue> {
    if text.trim().is_empty() {
        return Ok(None);
    }
    let mut values = [0.0; 14];
    let mut fields = text.split(',');
    for column in columns {
        let Some(field) = fields.next() else { return Err(Issue::Short) };
        let Some(column) = *column else { continue };
        let field = field.trim().trim_matches('"');
        values[column] = match field.parse::<f64>() {
            Ok(value) => value,
            Err(_) if field.is_empty() => f64::NAN,
            Err(_) => return Err(Issue::NoNumber { column, text: field.chars().take(40).collect() }),
        };
    }
    Ok(Some(Row { values, line: 0 }))
}
