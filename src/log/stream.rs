//! A long log, judged in constant memory.
//!
//! Units and the last time are taken from both ends of the file, and the reference is made before the rows are read. A row is measured and
//! let go; the frame check, the usual spacing and the explanations work on blocks of neighbours, spread evenly over the file. Where the
//! rows show on the way that the ends said too little, as in a file that is not in order, the log is left to the way that keeps all rows.

use super::file::Table;
use super::measure::{Meter, Reader};
use super::row::{Log, Marks, Parts, Row};
use super::times::{self, Odd};
use super::track::Track;
use super::units::Units;
use super::{
    FileError, Finding, FrameCheck, Judgement, Request, concluded, declared, early, frames, too_late, wide,
};
use crate::scenes::Scene;

/// Neighbours that are kept together: a known scheme is looked for in the first 201.
const BLOCK: usize = 256;
/// Blocks that are kept, at most: with them four bytes in a hundred of the memory that a million rows take.
const BLOCKS: usize = 256;

/// What both ends of a file say.
struct Ahead {
    units: Units,
    /// Last time and usual spacing [s].
    last: f64,
    spacing: f64,
}

/// Judges a log; `None` where its rows have to be kept.
pub(super) fn judge(table: &Table, scene: &Scene, request: &Request) -> Result<Option<Judgement>, FileError> {
    if request.series || request.from_log.is_some() {
        return Ok(None);
    }
    let Some(ahead) = Ahead::of(table, request)? else { return Ok(None) };
    let mut notes = Vec::new();
    let mut convention = declared(&table.reading, request, &mut notes);
    let track = || {
        too_late(scene, ahead.last)?;
        Track::dense(&scene.system, ahead.last).map_err(|error| error.to_string())
    };
    let (track, wide) = rayon::join(track, || wide(scene, ahead.last));
    let read = |convention, notes: &mut Vec<String>| {
        let reader = Reader { system: &scene.system, declared: convention };
        let Some((log, findings)) = Pass::new(reader, &track, &ahead).over(table, notes)? else {
            return Ok(None);
        };
        let frames = frames(&log, &findings, track.as_ref(), convention);
        Ok(Some((log, findings, frames)))
    };
    if request.as_found {
        match read(convention, &mut Vec::new())? {
            None => return Ok(None),
            Some((_, _, FrameCheck::Follows(fit))) => convention = fit.convention,
            Some(_) => {}
        }
    }
    let Some((log, findings, frames)) = read(convention, &mut notes)? else { return Ok(None) };
    let reader = Reader { system: &scene.system, declared: convention };
    let judgement = concluded(&log, &reader, (&track, wide.as_ref()), (findings, frames));
    Ok(Some(Judgement { notes, ..judgement }))
}

impl Ahead {
    /// `None` where they say too little.
    fn of(table: &Table, request: &Request) -> Result<Option<Ahead>, FileError> {
        let (mut first, mut last) = table.ends()?;
        let units = Units::of(&first, &table.reading, &request.said);
        units.apply(&mut first);
        units.apply(&mut last);
        let times = last.iter().map(Row::time).filter(|time| time.is_finite());
        let last = times.fold(f64::NEG_INFINITY, f64::max);
        let spacing = times::spacing(first.windows(2));
        Ok((last >= 0.0).then_some(Ahead { units, last, spacing }))
    }
}

/// One reading of all rows.
struct Pass<'a> {
    meter: Meter<'a>,
    ahead: &'a Ahead,
    marks: Marks,
    odd: Odd,
    sample: Sample,
    /// Rows before t = 0.
    early: usize,
    /// First and last time so far [s].
    span: (f64, f64),
}

impl<'a> Pass<'a> {
    fn new(reader: Reader<'a>, track: &'a Result<Track, String>, ahead: &'a Ahead) -> Pass<'a> {
        Pass {
            meter: Meter::new(reader, track.as_ref()),
            ahead,
            marks: Marks::default(),
            odd: Odd::new(ahead.spacing),
            sample: Sample { rows: Vec::new(), stride: 1, count: 0 },
            early: 0,
            span: (f64::NAN, f64::NEG_INFINITY),
        }
    }

    /// The log without most of its rows, and what was measured; `None` where the ends said too little.
    fn over(
        mut self,
        table: &Table,
        notes: &mut Vec<String>,
    ) -> Result<Option<(Log, Vec<Finding>)>, FileError> {
        let parts = table.reading.parts();
        let mut sound = true;
        let cut = table.rows(&mut |rows| {
            sound = self.take(rows, parts);
            sound
        })?;
        let empty = self.sample.rows.iter().all(|row| row.parts == Parts::default());
        if !sound || empty || self.span.1 != self.ahead.last {
            return Ok(None);
        }
        let (block, count, span, lacking) = (BLOCK, self.sample.count, self.span, self.marks.lacking);
        let rows = std::mem::take(&mut self.sample.rows);
        let log = Log {
            rows,
            block,
            count,
            span,
            parts,
            lacking,
            reading: table.reading.clone(),
            notes: Vec::new(),
        };
        notes.extend(cut);
        notes.extend(table.reading.missing_columns());
        notes.extend(self.ahead.units.notes());
        notes.extend(self.marks.notes());
        notes.extend(early(self.early));
        notes.extend(self.odd.notes());
        let findings = self.meter.findings(&log, notes);
        Ok(Some((log, findings)))
    }

    /// Measures rows of the file; false where the ends said too little.
    fn take(&mut self, mut rows: Vec<Row>, parts: Parts) -> bool {
        if !self.ahead.units.holds(&rows) {
            return false;
        }
        self.ahead.units.apply(&mut rows);
        self.marks.mark(parts, &mut rows);
        let all = rows.len();
        rows.retain(|row| row.time() >= 0.0);
        self.early += all - rows.len();
        let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return true };
        let in_order = rows.windows(2).all(|pair| pair[0].time() <= pair[1].time());
        if !in_order || first.time() < self.span.1 || last.time() > self.ahead.last {
            return false;
        }
        let start = if self.span.0.is_nan() { first.time() } else { self.span.0 };
        self.span = (start, last.time());
        self.odd.take(&rows);
        self.sample.take(&rows);
        self.meter.take(&rows);
        true
    }
}

/// Blocks of neighbours, spread evenly.
struct Sample {
    rows: Vec<Row>,
    /// Of so many blocks one is kept.
    stride: usize,
    /// Rows so far.
    count: usize,
}

impl Sample {
    fn take(&mut self, rows: &[Row]) {
        for row in rows {
            if (self.count / BLOCK).is_multiple_of(self.stride) {
                self.rows.push(*row);
            }
            self.count += 1;
            if self.rows.len() == BLOCK * BLOCKS {
                self.rows = self.rows.chunks(BLOCK).step_by(2).flatten().copied().collect();
                self.stride *= 2;
            }
        }
    }
}
