//! A trajectory file: comments, a header, then a row a time. Columns may be missing, more are ignored.

use std::path::Path;

use rayon::prelude::*;

use super::layout::{self, FIELDS, Reading, Separator, number};
use super::row::{COLUMNS, Log, Part, Parts, Row};
use super::said::Said;
use super::units;
use crate::bounded::{self, FileError};

/// Bytes that one thread reads at a time.
const PIECE: usize = 1 << 20;
/// Most rows: 1.2 GB of numbers.
const MOST_ROWS: usize = 10_000_000;
/// Most bytes of a first line.
const MOST_OF_A_HEADER: usize = 1 << 20;
/// Length of a quaternion below which it is none: printed to one digit, a unit quaternion keeps 0.85.
const NO_QUATERNION: f64 = 0.1;

/// Reads a file.
pub(super) fn read(path: &Path, said: &Said) -> Result<Log, FileError> {
    let text = bounded::text(path, bounded::MOST_OF_A_LOG)?;
    parse(&text, &path.display().to_string(), said)
}

/// Reads the text of a file.
pub(super) fn parse(text: &str, file: &str, said: &Said) -> Result<Log, FileError> {
    let refuse = |line, why: String| FileError::Content { file: file.to_owned(), line, why };
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let Some(head) = Head::of(text) else {
        let why = format!("the file is empty: write a header {}, then rows", COLUMNS.join(","));
        return Err(refuse(1, why));
    };
    if head.line.len() > MOST_OF_A_HEADER {
        let why = format!("the line has more than {MOST_OF_A_HEADER} bytes, which no header has");
        return Err(refuse(head.lines_before + 1, why));
    }
    let reading = Reading::find(head.comment, head.line, said.columns.as_ref());
    let mut reading = reading.map_err(|why| refuse(head.lines_before + 1, why))?;
    let (after, lines_before) =
        if reading.header { (head.after, head.lines_before + 1) } else { (head.from, head.lines_before) };
    if let (Some(sequence), Some(said)) = (&mut reading.sequence, said.sequence) {
        *sequence = said;
    }
    if after.bytes().filter(|byte| *byte == b'\n').count() > MOST_ROWS {
        return Err(refuse(
            lines_before + 1,
            format!("there are more than {MOST_ROWS} rows: write every tenth"),
        ));
    }
    let cut_is_allowed = !text.ends_with('\n');
    let (rows, mut notes) =
        rows(after, &reading, lines_before, cut_is_allowed).map_err(|(line, why)| refuse(line, why))?;
    if rows.is_empty() {
        return Err(refuse(
            lines_before + 1,
            "there is a header and no whole row: nothing to judge".to_owned(),
        ));
    }
    let parts = reading.parts();
    notes.extend(missing_columns(parts));
    let mut log = Log { rows, parts, lacking: [0; 4], reading, notes };
    units::apply(&mut log, said);
    let first = log.rows.first().map_or(lines_before + 1, |row| row.line as usize);
    finish(&mut log);
    if log.rows.iter().all(|row| row.parts == Parts::default()) {
        return Err(refuse(first, "no row has finite numbers: nothing to judge".to_owned()));
    }
    Ok(log)
}

/// The rows of the text after a header, and what was seen on the way; or the line that is no row, and why.
fn rows(
    text: &str,
    reading: &Reading,
    lines_before: usize,
    cut_is_allowed: bool,
) -> Result<(Vec<Row>, Vec<String>), (usize, String)> {
    let (mut rows, mut notes) = (Vec::new(), Vec::new());
    let pieces: Vec<Piece> = pieces(text).into_par_iter().map(|piece| read_piece(piece, reading)).collect();
    rows.reserve(pieces.iter().map(|piece| piece.rows.len()).sum());
    let (mut before, last) = (lines_before, pieces.len());
    for (index, mut piece) in pieces.into_iter().enumerate() {
        if let Some((line, issue)) = piece.issue {
            let cut = cut_is_allowed && index + 1 == last && line == piece.lines;
            match issue {
                Issue::Short if cut => {
                    notes.push(format!("the last row, line {}, is cut and was left out", before + line));
                }
                issue => return Err((before + line, issue.in_words())),
            }
        }
        piece.rows.iter_mut().for_each(|row| row.line += before as u32);
        rows.append(&mut piece.rows);
        before += piece.lines;
    }
    Ok((rows, notes))
}

/// The beginning of a file.
struct Head<'a> {
    comment: Option<&'a str>,
    /// The first line that is no comment.
    line: &'a str,
    /// The text from there on, and after it.
    from: &'a str,
    after: &'a str,
    lines_before: usize,
}

impl Head<'_> {
    fn of(text: &str) -> Option<Head<'_>> {
        let (mut comment, mut from, mut lines_before) = (None, text, 0);
        loop {
            let (line, after) = from.split_once('\n').unwrap_or((from, ""));
            let bare = line.trim();
            if is_comment(bare) && !is_header(bare) {
                comment = Some(bare).filter(|bare| bare.len() <= MOST_OF_A_HEADER);
            } else if !bare.is_empty() {
                // A header may begin with the sign of a comment.
                let line = if is_comment(bare) { bare.trim_start_matches(['#', '%', ' ']) } else { bare };
                return Some(Head { comment, line, from, after, lines_before });
            }
            if after.is_empty() {
                return None;
            }
            (from, lines_before) = (after, lines_before + 1);
        }
    }
}

fn is_comment(line: &str) -> bool {
    line.starts_with(['#', '%']) || line.starts_with("//")
}

/// Whether a comment is a header between commas, as EuRoC and ROS write it.
fn is_header(line: &str) -> bool {
    if line.len() > MOST_OF_A_HEADER {
        return false;
    }
    let bare = line.trim_start_matches(['#', '%', ' ']);
    let names: Vec<&str> = bare.split(',').take(FIELDS.len()).collect();
    let known = names.iter().filter(|name| super::columns::meaning(name).is_some()).count();
    known > 1 && super::columns::meaning(names[0]).is_some()
}

fn missing_columns(parts: Parts) -> Vec<String> {
    let missing = Part::ALL.into_iter().filter(|part| !parts.has(*part));
    let note = |part: Part| {
        format!("no column {}: what needs it is not applicable", COLUMNS[part.columns()].join(", "))
    };
    missing.map(note).collect()
}

/// Some lines of a file, read; lines are counted from 1 in the piece.
#[derive(Default)]
struct Piece {
    rows: Vec<Row>,
    /// The first line that is no row, where there is one; nothing after it was read.
    issue: Option<(usize, Issue)>,
    lines: usize,
}

/// What is wrong with a line.
enum Issue {
    Short,
    NoNumber { field: usize, text: String },
}

impl Issue {
    fn in_words(&self) -> String {
        match self {
            Issue::Short => "the row has fewer columns than the header".to_owned(),
            Issue::NoNumber { field, text } => {
                format!("column {} holds '{text}', which is not a number", FIELDS[*field])
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

fn read_piece(text: &str, reading: &Reading) -> Piece {
    let mut piece = Piece::default();
    for line in text.lines() {
        piece.lines += 1;
        if line.trim().is_empty() || is_comment(line.trim_start()) {
            continue;
        }
        let row = match reading.separator {
            Separator::Sign(sign) => row(line.split(char::from(sign)), reading),
            Separator::Blanks => row(line.split_ascii_whitespace(), reading),
        };
        match row {
            Ok(values) => {
                piece.rows.push(Row { values, line: piece.lines as u32, parts: Parts::default() });
            }
            Err(issue) => {
                piece.issue = Some((piece.lines, issue));
                break;
            }
        }
    }
    piece
}

/// A line as numbers. Angles and Rodrigues parameters stand in the place of the quaternion.
fn row<'a>(mut cells: impl Iterator<Item = &'a str>, reading: &Reading) -> Result<[f64; 14], Issue> {
    let mut values = [f64::NAN; 14];
    for slot in &reading.slots {
        let Some(cell) = cells.next() else { return Err(Issue::Short) };
        let Some(slot) = slot else { continue };
        let cell = layout::clean(cell);
        let Some(value) = number(cell, reading.separator) else {
            return Err(Issue::NoNumber { field: slot.field, text: layout::shown(cell) });
        };
        let place = match slot.field {
            field if field < COLUMNS.len() => field,
            field if reading.has_all(4, 4) => {
                debug_assert!(field >= COLUMNS.len());
                continue;
            }
            field => 4 + (field - COLUMNS.len()) % 3,
        };
        values[place] = value;
    }
    Ok(values)
}

/// Says of each row which parts it has, leaves out those without a time, and puts them in order.
fn finish(log: &mut Log) {
    let all = log.rows.len();
    let mut first = [None; 4];
    for row in &mut log.rows {
        row.parts = log.parts;
        for part in log.parts.each() {
            let numbers = &row.values[part.columns()];
            let length = numbers.iter().map(|x| x * x).sum::<f64>().sqrt();
            let none = part == Part::Orientation && length < NO_QUATERNION;
            if none || numbers.iter().any(|x| !x.is_finite()) {
                row.parts = row.parts.without(part);
                log.lacking[part as usize] += 1;
                first[part as usize].get_or_insert(row.line);
            }
        }
    }
    for part in log.parts.each() {
        if let Some(line) = first[part as usize] {
            let count = log.lacking[part as usize];
            let word = part.word();
            log.notes.push(format!(
                "{count} of {all} rows have no {word} (zeros, NaN, infinity or an empty cell) and were left out where it counts, the first in line {line}"
            ));
        }
    }
    // A row without any quantity stays: its time may be the end that is asked for.
    log.rows.retain(|row| row.time().is_finite());
    if log.rows.len() < all {
        let count = all - log.rows.len();
        log.notes.push(format!("{count} rows have no time and were left out"));
    }
    if log.rows.windows(2).any(|pair| pair[1].time() < pair[0].time()) {
        let back: Vec<&[Row]> = log.rows.windows(2).filter(|pair| pair[1].time() < pair[0].time()).collect();
        let line = back[0][1].line;
        log.notes.push(format!(
            "{} times go back, the first in line {line}; the rows were put in the order of their times",
            back.len()
        ));
        log.rows.sort_by(|a, b| a.time().total_cmp(&b.time()));
    }
}
