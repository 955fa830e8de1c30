//! A trajectory file: comments, a header, then a row a time. Columns may be missing, more are ignored.

use std::io::ErrorKind;
use std::path::Path;

use rayon::prelude::*;

use super::clock;
use super::layout::{self, FIELDS, Reading, Separator, number};
use super::row::{COLUMNS, Log, Marks, Parts, Row};
use super::said::Said;
use super::source::{CHUNK, MOST_OF_A_LINE, Source};
use super::units::Units;
use crate::bounded::{FileError, NO_TEXT};
use crate::interrupt;

/// Bytes that one thread reads at a time.
const PIECE: usize = 1 << 20;
/// Most rows that are kept: 1.2 GB of numbers.
const MOST_ROWS: usize = 10_000_000;
/// Most bytes of a first line.
const MOST_OF_A_HEADER: usize = 1 << 20;
/// Bytes at the end of a file among which its last row is looked for.
const TAIL: usize = 1 << 16;

/// A file whose header was read.
#[derive(Debug)]
pub(super) struct Table<'a> {
    source: Source<'a>,
    /// Its name in messages.
    file: String,
    pub reading: Reading,
    /// Where its rows begin [bytes], and the lines before.
    from: u64,
    pub lines_before: usize,
}

impl Table<'_> {
    /// Opens a file and reads its header.
    pub fn open(path: &Path, said: &Said) -> Result<Table<'static>, FileError> {
        Table::of(Source::open(path)?, path.display().to_string(), said)
    }

    /// Reads the header of what is there.
    pub fn of<'s>(source: Source<'s>, file: String, said: &Said) -> Result<Table<'s>, FileError> {
        let refuse = |line, why: String| FileError::Content { file: file.clone(), line, why };
        let unreadable = |source| FileError::Unreadable { file: file.clone(), source };
        let first = source.some(0, CHUNK).map_err(unreadable)?;
        // What is no text stands in a row, or there is no header before it: both are refused with their line.
        let valid = first.utf8_chunks().next().map_or("", |chunk| chunk.valid());
        let text = valid.strip_prefix('\u{feff}').unwrap_or(valid);
        let Some(head) = Head::of(text) else {
            let why = match first.len() {
                length if valid.len() < length => format!("{NO_TEXT}: save the file as UTF-8"),
                CHUNK => format!("the first {} MiB are comments: write a header", CHUNK >> 20),
                _ => format!("the file is empty: write a header {}, then rows", COLUMNS.join(",")),
            };
            return Err(refuse(1, why));
        };
        if head.line.len() > MOST_OF_A_HEADER {
            let why = format!("the line has more than {MOST_OF_A_HEADER} bytes, which no header has");
            return Err(refuse(head.lines_before + 1, why));
        }
        if head.line.trim_end().contains('\r') {
            let why = "lines end with a carriage return alone: end them with a line feed";
            return Err(refuse(head.lines_before + 1, why.to_owned()));
        }
        let (below, after_below) = head.after.split_once('\n').unwrap_or((head.after, ""));
        let reading = Reading::find(head.comment, head.line, below, said.columns.as_ref());
        let mut reading = reading.map_err(|why| refuse(head.lines_before + 1, why))?;
        let (rest, lines_before) = match (reading.header, reading.units) {
            (false, _) => (head.from, head.lines_before),
            (true, false) => (head.after, head.lines_before + 1),
            (true, true) => (after_below, head.lines_before + 2),
        };
        if let (Some(sequence), Some(said)) = (&mut reading.sequence, said.sequence) {
            *sequence = said;
        }
        let from = (valid.len() - rest.len()) as u64;
        Ok(Table { source, file, reading, from, lines_before })
    }

    /// Bytes of the file.
    pub fn length(&self) -> u64 {
        self.source.length()
    }

    pub fn refuse(&self, line: usize, why: impl Into<String>) -> FileError {
        FileError::Content { file: self.file.clone(), line, why: why.into() }
    }

    fn unreadable(&self, source: std::io::Error) -> FileError {
        FileError::Unreadable { file: self.file.clone(), source }
    }

    /// Hands over all rows as the file has them, some at a time, until `take` says that it has enough; returns what is to be said.
    /// Rows are taken while the next ones are read.
    pub fn rows(&self, take: &mut (dyn FnMut(Vec<Row>) -> bool + Send)) -> Result<Vec<String>, FileError> {
        let (mut before, mut refused, mut notes) = (self.lines_before, None, Vec::new());
        let mut rows = Vec::new();
        let lines = &mut |bytes: &[u8]| {
            if interrupt::requested() {
                return false;
            }
            if bytes.len() > MOST_OF_A_LINE && !bytes.ends_with(b"\n") {
                let why = format!("the line has more than {} MiB, which no row has", MOST_OF_A_LINE >> 20);
                refused = Some(self.refuse(before + 1, why));
                return false;
            }
            let read = || pieces(bytes).into_par_iter().map(|piece| self.piece(piece)).collect();
            let earlier = std::mem::take(&mut rows);
            let (pieces, more): (Vec<Piece>, bool) =
                rayon::join(read, || earlier.is_empty() || take(earlier));
            if !more {
                return false;
            }
            refused = self.join(pieces, (&mut rows, &mut before, &mut notes)).err();
            refused.is_none()
        };
        self.source.lines(self.from, lines).map_err(|source| self.unreadable(source))?;
        if interrupt::requested() {
            return Err(self.unreadable(ErrorKind::Interrupted.into()));
        }
        if let Some(refused) = refused {
            return Err(refused);
        }
        if !rows.is_empty() {
            take(rows);
        }
        Ok(notes)
    }

    /// Appends the rows of pieces that follow each other to those so far, and counts their lines.
    fn join(
        &self,
        pieces: Vec<Piece>,
        (rows, before, notes): (&mut Vec<Row>, &mut usize, &mut Vec<String>),
    ) -> Result<(), FileError> {
        rows.reserve(pieces.iter().map(|piece| piece.rows.len()).sum());
        for mut piece in pieces {
            match piece.issue {
                Some((line, Issue::Short)) if piece.cut && line == piece.lines => {
                    notes.push(format!("the last row, line {}, is cut and was left out", *before + line));
                }
                Some((line, issue)) => return Err(self.refuse(*before + line, issue.in_words())),
                None => {}
            }
            piece.rows.iter_mut().for_each(|row| row.line += *before as u32);
            rows.append(&mut piece.rows);
            *before += piece.lines;
        }
        Ok(())
    }

    /// The rows in the first bytes of the file and in the last, as far as they are rows.
    pub fn ends(&self) -> Result<(Vec<Row>, Vec<Row>), FileError> {
        let some = |from, most| self.source.some(from, most).map_err(|source| self.unreadable(source));
        let whole =
            |bytes: &[u8]| bytes.iter().rposition(|byte| *byte == b'\n').map_or(bytes.len(), |end| end + 1);
        let first = some(self.from, PIECE)?;
        let last = some(self.length().saturating_sub(TAIL as u64).max(self.from), TAIL)?;
        let begins = last.iter().position(|byte| *byte == b'\n').map_or(last.len(), |end| end + 1);
        Ok((self.piece(&first[..whole(&first)]).rows, self.piece(&last[begins..]).rows))
    }

    /// All rows, in memory and in the order of their times.
    pub fn log(&self, said: &Said) -> Result<Log, FileError> {
        let mut rows = Vec::new();
        let mut notes = self.rows(&mut |mut more| {
            rows.append(&mut more);
            rows.len() <= MOST_ROWS
        })?;
        if rows.is_empty() {
            let why = "there is a header and no whole row: nothing to judge";
            return Err(self.refuse(self.lines_before + 1, why));
        }
        if rows.len() > MOST_ROWS {
            let why =
                format!("more than {MOST_ROWS} rows cannot be put in order: sort them, or write every tenth");
            return Err(self.refuse(self.lines_before + 1, why));
        }
        notes.extend(self.reading.missing_columns());
        let units = Units::of(&rows, &self.reading, said);
        units.apply(&mut rows);
        notes.extend(units.notes());
        let first = rows[0].line as usize;
        let mut marks = Marks::default();
        marks.mark(self.reading.parts(), &mut rows);
        notes.extend(marks.notes());
        notes.extend(in_order(&mut rows));
        if rows.iter().all(|row| row.parts == Parts::default()) {
            return Err(self.refuse(first, "no row has finite numbers: nothing to judge"));
        }
        Ok(Log::of(rows, marks.lacking, self.reading.clone(), notes))
    }

    fn piece(&self, bytes: &[u8]) -> Piece {
        read_piece(bytes, &self.reading)
    }
}

/// Puts rows in the order of their times; says so where they were not.
fn in_order(rows: &mut [Row]) -> Option<String> {
    let back = |pair: &&[Row]| pair[1].time() < pair[0].time();
    let first = rows.windows(2).find(back)?;
    let (line, count) = (first[1].line, rows.windows(2).filter(back).count());
    rows.sort_by(|a, b| a.time().total_cmp(&b.time()));
    Some(format!(
        "{count} times go back, the first in line {line}; the rows were put in the order of their times"
    ))
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
    matches!(line.as_bytes(), [b'#' | b'%', ..] | [b'/', b'/', ..])
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

/// Some lines of a file, read; lines are counted from 1 in the piece.
#[derive(Default)]
struct Piece {
    rows: Vec<Row>,
    /// The first line that is no row, where there is one; nothing after it was read.
    issue: Option<(usize, Issue)>,
    lines: usize,
    /// Whether the last line has no end.
    cut: bool,
}

/// What is wrong with a line.
enum Issue {
    Short,
    NoText,
    NoNumber { field: usize, text: String },
}

impl Issue {
    fn in_words(&self) -> String {
        match self {
            Issue::Short => "the row has fewer columns than the header".to_owned(),
            Issue::NoText => format!("{NO_TEXT}: save the file as UTF-8"),
            Issue::NoNumber { field, text } => {
                format!("column {} holds '{text}', which is not a number", FIELDS[*field])
            }
        }
    }
}

/// The lines in pieces of about [`PIECE`].
fn pieces(mut bytes: &[u8]) -> Vec<&[u8]> {
    let mut pieces = Vec::new();
    while bytes.len() > PIECE {
        let end = bytes[PIECE..].iter().position(|byte| *byte == b'\n');
        let Some(end) = end else { break };
        let (piece, rest) = bytes.split_at(PIECE + end + 1);
        pieces.push(piece);
        bytes = rest;
    }
    if !bytes.is_empty() {
        pieces.push(bytes);
    }
    pieces
}

fn read_piece(bytes: &[u8], reading: &Reading) -> Piece {
    let mut piece = Piece { cut: !bytes.ends_with(b"\n"), ..Piece::default() };
    let valid = |_| bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    let text = std::str::from_utf8(bytes).unwrap_or_else(valid);
    // A row has a digit and a sign for each column at least.
    let shortest = text.lines().next().map_or(0, str::len).max(2 * reading.slots.len());
    piece.rows.reserve(text.len() / shortest.max(1) + 1);
    for line in text.lines() {
        piece.lines += 1;
        let bare = line.trim_start();
        if bare.is_empty() || is_comment(bare) {
            continue;
        }
        let row = match reading.separator {
            Separator::Sign(sign) => row(cells(line, sign), reading),
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
    if text.len() < bytes.len() && piece.issue.as_ref().is_none_or(|(line, _)| *line == piece.lines) {
        let line = 1 + text.bytes().filter(|byte| *byte == b'\n').count();
        piece.issue = Some((line, Issue::NoText));
    }
    piece
}

/// What stands between signs.
fn cells(line: &str, sign: u8) -> impl Iterator<Item = &str> {
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let text = rest?;
        let end = text.bytes().position(|byte| byte == sign);
        rest = end.map(|end| &text[end + 1..]);
        Some(end.map_or(text, |end| &text[..end]))
    })
}

/// A line as numbers. Angles and Rodrigues parameters stand in the place of the quaternion.
fn row<'a>(mut cells: impl Iterator<Item = &'a str>, reading: &Reading) -> Result<[f64; 14], Issue> {
    let mut values = [f64::NAN; 14];
    for slot in &reading.slots {
        let Some(cell) = cells.next() else { return Err(Issue::Short) };
        let Some(slot) = slot else { continue };
        let value = match cell.parse() {
            Ok(value) => value,
            Err(_) => {
                let cell = layout::clean(cell);
                let none = || Issue::NoNumber { field: slot.field, text: layout::shown(cell) };
                let moment = || clock::moment(cell).filter(|_| slot.field == 0);
                number(cell, reading.separator).or_else(moment).ok_or_else(none)?
            }
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
