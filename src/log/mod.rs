//! A trajectory that another program wrote, held against the reference of its scene at its own times.
//!
//! Errors at the end and the largest, the metrics of a run, the convention that the log follows, and the fixed change that explains it.
//! Columns may be missing; what needs them is then not applicable, with the reason.

mod clock;
mod columns;
mod euler;
mod explain;
mod file;
mod frames;
mod headless;
mod layout;
mod measure;
mod names;
mod recognise;
mod row;
mod said;
mod series;
mod source;
mod stream;
mod times;
mod track;
mod units;
mod verdict;

use std::path::Path;

pub use crate::bounded::FileError;
use crate::scenes::Scene;

pub use euler::Sequence;
pub use explain::{Change, Explanation};
pub use frames::{Convention, Fit, FrameCheck};
pub use said::{Columns, Said};
pub use series::{Deviation, Series};
pub use units::{AngleUnit, TimeUnit};
pub use verdict::Verdict;

use file::Table;
use layout::Reading;
use measure::{Meter, Reader};
use row::Log;
use source::Source;
use times::Odd;
use track::Track;

/// Durations of the scene after which a log is no longer compared with it.
const LONGEST: f64 = 100.0;

/// One number about a log.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name, as in records.
    pub name: &'static str,
    /// Unit; `1` for pure numbers.
    pub unit: &'static str,
    /// At the last row and the largest, with what they may be wrong by; or why there are none.
    pub value: Result<Value, String>,
}

/// The two values of a finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// At the last row of the log; `None` where that row lacks what it needs.
    pub end: Option<f64>,
    /// The largest over the rows.
    pub max: f64,
    /// Time of the largest [s]; NaN for a metric.
    pub time: f64,
    /// Rows that have what it needs.
    pub rows: usize,
    /// Uncertainty of the reference.
    pub uncertainty: f64,
}

/// How a log is to be judged.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// What the user says about the file.
    pub said: Said,
    /// Axes of angular velocities, where the user says them.
    pub spin_in_body_axes: Option<bool>,
    /// Sense of quaternions, where the user says it.
    pub world_to_body: Option<bool>,
    /// Read the log by the convention that it follows.
    pub as_found: bool,
    /// Keep the errors of every row.
    pub series: bool,
    /// Row, from 1, at which the reference starts; at the scene's own start where there is none.
    pub from_log: Option<usize>,
}

/// All that is to be said about a log.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// How the file was read.
    pub reading: String,
    /// Rows judged.
    pub rows: usize,
    /// First and last time [s].
    pub span: (f64, f64),
    /// Usual distance of two rows [s].
    pub spacing: f64,
    /// How the reference was made, or why there is none.
    pub reference: Result<String, String>,
    /// Errors and metrics.
    pub findings: Vec<Finding>,
    /// The convention by which the log was read.
    pub declared: Convention,
    /// What it follows.
    pub frames: FrameCheck,
    /// Errors of every row, where they were asked for and there is a reference.
    pub series: Series,
    /// The fixed changes that explain the log.
    pub explanations: Vec<Explanation>,
    /// Missing columns, gaps, rows left out.
    pub notes: Vec<String>,
}

/// Bytes of a file above which its rows are not kept.
const LONG: u64 = 16 << 20;

/// Judges a file. A long one is read in constant memory where its rows are in order and no errors of single rows are asked for.
///
/// # Errors
/// [`FileError`]: it cannot be read, or is no trajectory.
pub fn judge(path: &Path, scene: &Scene, request: &Request) -> Result<Judgement, FileError> {
    judge_table(&Table::open(path, &request.said)?, scene, request, LONG)
}

/// Judges the text of a file.
///
/// # Errors
/// [`FileError`]: it is no trajectory.
pub fn judge_text(text: &str, scene: &Scene, request: &Request) -> Result<Judgement, FileError> {
    let source = Source::Bytes(text.as_bytes().into());
    judge_table(&Table::of(source, "log".to_owned(), &request.said)?, scene, request, LONG)
}

fn judge_table(table: &Table, scene: &Scene, request: &Request, long: u64) -> Result<Judgement, FileError> {
    if table.length() > long
        && let Some(judgement) = stream::judge(table, scene, request)?
    {
        return Ok(judgement);
    }
    judge_log(table.log(&request.said)?, scene, request)
        .map_err(|why| table.refuse(table.lines_before + 1, why))
}

fn judge_log(mut log: Log, scene: &Scene, request: &Request) -> Result<Judgement, String> {
    let mut declared = declared(&log.reading, request, &mut log.notes);
    leave_early_out(&mut log)?;
    let mut scene = scene.clone();
    if let Some(row) = request.from_log {
        start_at(&mut scene, &mut log, row, declared)?;
    }
    log.counted();
    let (track, wide) = rayon::join(|| track(&scene, &log), || wide(&scene, log.span.1));
    let measured = |log: &Log, declared, notes: &mut Vec<String>| {
        let mut meter = Meter::new(Reader { system: &scene.system, declared }, track.as_ref());
        meter.take(&log.rows);
        let findings = meter.findings(log, notes);
        let frames = frames(log, &findings, track.as_ref(), declared);
        (findings, frames)
    };
    if request.as_found
        && let FrameCheck::Follows(fit) = measured(&log, declared, &mut Vec::new()).1
    {
        declared = fit.convention;
    }
    let mut odd = Odd::new(times::spacing(log.pairs()));
    odd.take(&log.rows);
    let mut notes = std::mem::take(&mut log.notes);
    notes.extend(odd.notes());
    let (findings, frames) = measured(&log, declared, &mut notes);
    let reader = Reader { system: &scene.system, declared };
    let series = match &track {
        Ok(track) if request.series => series::series(&log, &reader, track),
        _ => Series::default(),
    };
    let judgement = concluded(&log, &reader, (&track, wide.as_ref()), (findings, frames));
    Ok(Judgement { series, notes, ..judgement })
}

/// The convention by which a log is to be read.
fn declared(reading: &Reading, request: &Request, notes: &mut Vec<String>) -> Convention {
    let spin_in_body_axes = request.spin_in_body_axes.unwrap_or(reading.spin_in_body_axes);
    if request.spin_in_body_axes.is_none() && spin_in_body_axes {
        notes.push("angular velocities are in body axes, as the names of the columns say".to_owned());
    }
    Convention { spin_in_body_axes, world_to_body: request.world_to_body.unwrap_or(false) }
}

/// All that is to be said, but for errors of single rows and notes.
fn concluded(
    log: &Log,
    reader: &Reader,
    (track, wide): (&Result<Track, String>, Option<&Track>),
    (findings, frames): (Vec<Finding>, FrameCheck),
) -> Judgement {
    Judgement {
        reading: log.reading.words.clone(),
        rows: log.count,
        span: log.span,
        spacing: times::spacing(log.pairs()),
        reference: track.as_ref().map(|track| track.source.clone()).map_err(String::clone),
        findings,
        declared: reader.declared,
        frames,
        series: Series::default(),
        explanations: wide.map(|wide| explain::explain(log, *reader, wide)).unwrap_or_default(),
        notes: Vec::new(),
    }
}

/// The reference in which a log is looked for that starts late, or is in another unit of time: twice as long as the log or the scene.
fn wide(scene: &Scene, last: f64) -> Option<Track> {
    let last = if last > LONGEST * scene.duration { scene.duration } else { last.max(scene.duration) };
    Track::dense(&scene.system, 2.0 * last).ok()
}

fn leave_early_out(log: &mut Log) -> Result<(), String> {
    let all = log.rows.len();
    log.rows.retain(|row| row.time() >= 0.0);
    match all - log.rows.len() {
        count if count == all => {
            return Err("all rows are before t = 0: times count from the start of the motion".to_owned());
        }
        count => log.notes.extend(early(count)),
    }
    Ok(())
}

fn early(count: usize) -> Option<String> {
    (count > 0).then(|| format!("{count} rows are before t = 0 and were left out"))
}

fn track(scene: &Scene, log: &Log) -> Result<Track, String> {
    too_late(scene, log.span.1)?;
    let times: Vec<f64> = log.rows.iter().map(row::Row::time).collect();
    Track::of(&scene.system, &times).map_err(|error| error.to_string())
}

/// A log that ends so late that it is not compared.
fn too_late(scene: &Scene, last: f64) -> Result<(), String> {
    if last <= LONGEST * scene.duration {
        return Ok(());
    }
    Err(format!(
        "the log ends at t = {last} s, after more than {LONGEST} durations of the scene ({} s)",
        scene.duration
    ))
}

/// The frame check of a log that was read by a convention.
fn frames(
    log: &Log,
    findings: &[Finding],
    track: Result<&Track, &String>,
    declared: Convention,
) -> FrameCheck {
    let agree = findings.iter().any(|finding| {
        let small = |value: &Value| value.max <= ORIENTATIONS_AGREE;
        finding.name == "orientation" && finding.value.as_ref().is_ok_and(small)
    });
    let fastest = track.map_or(0.0, |track| measure::fastest(&track.samples()));
    frames::check(log, agree.then_some(declared), fastest)
}

/// Largest orientation error [rad] at which the sense of a quaternion is known: the conjugate is farther off once a body has turned by
/// twice as much.
const ORIENTATIONS_AGREE: f64 = 0.1;

/// Starts the scene at a row of the log.
fn start_at(scene: &mut Scene, log: &mut Log, row: usize, declared: Convention) -> Result<(), String> {
    let Some(first) = row.checked_sub(1).and_then(|index| log.rows.get(index)).copied() else {
        return Err(format!("--from-log {row}: there are {} rows", log.rows.len()));
    };
    if first.time() > 0.0 && scene.system.forces.fastest_clock() > 0.0 {
        return Err(format!(
            "--from-log {row}: the forces depend on the time, and the row is at t = {} s",
            first.time()
        ));
    }
    let own = Track::of(&scene.system, &[0.0]).map_err(|error| error.to_string())?.at(0, 0.0);
    let reader = Reader { system: &scene.system, declared };
    if let Some(part) = log.parts.each().find(|part| !first.parts.has(*part)) {
        return Err(format!("--from-log {row}: the row has no {}", part.word()));
    }
    let start = reader.start(&first, &own);
    scene.system = scene.system.started_at(&start);
    log.rows.drain(..row - 1);
    log.rows.iter_mut().for_each(|row| row.values[0] -= first.time());
    log.notes.push(format!("the reference starts at row {row} of the log, at t = {} s", first.time()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A log in memory and in constant memory: the same numbers, of more rows than a block and more bytes than a piece has.
    #[test]
    fn a_long_log_is_judged_as_a_short_one() {
        let scene = Scene::find("dzhanibekov").expect("a scene");
        let mut text = "t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n".to_owned();
        let times: Vec<f64> = (0..40_000).map(|n| f64::from(n) * 1e-4).collect();
        let track = Track::dense(&scene.system, 4.0).expect("a track");
        for (n, t) in times.iter().enumerate() {
            let s = track.truth(*t);
            let (q, w) = (s.orientation, s.angular_velocity);
            let late = if n == 12_345 { 7e-4 } else { 0.0 };
            let x = if n % 5000 == 17 { f64::NAN } else { s.position.x + 1e-3 * t };
            let (y, z, v) = (s.position.y, s.position.z, s.velocity);
            text += &format!(
                "{},{x},{y},{z},{},{},{},{},{},{},{},{},{},{}\n",
                t + late,
                q.w,
                q.i,
                q.j,
                q.k,
                v.x,
                v.y,
                v.z,
                w.x,
                w.y,
                w.z
            );
        }
        let judged = |text: &str, long| {
            let source = Source::Bytes(text.as_bytes().into());
            let request = Request::default();
            let table = Table::of(source, "log".to_owned(), &request.said).expect("a table");
            judge_table(&table, &scene, &request, long).expect("a judgement")
        };
        // One time is out of order: the rows are put in order in both ways.
        let (kept, streamed) = (judged(&text, u64::MAX), judged(&text, 0));
        let printed = |judgement: &Judgement| format!("{:?}", judgement.findings);
        assert_eq!(printed(&kept), printed(&streamed));
        assert!(kept.notes.iter().any(|note| note.contains("times go back")));
        let text = text.replacen(&format!("\n{},", times[12_345] + 7e-4), "\n1.23455,", 1);
        let (kept, streamed) = (judged(&text, u64::MAX), judged(&text, 0));
        assert!(!kept.notes.iter().any(|note| note.contains("times go back")), "{:?}", kept.notes);
        assert_eq!((kept.rows, kept.span), (streamed.rows, streamed.span));
        assert_eq!(kept.notes, streamed.notes);
        assert!((kept.spacing / streamed.spacing - 1.0).abs() < 1e-9);
        for (a, b) in kept.findings.iter().zip(&streamed.findings) {
            let (Ok(x), Ok(y)) = (&a.value, &b.value) else {
                assert_eq!(format!("{a:?}"), format!("{b:?}"));
                continue;
            };
            assert_eq!((x.rows, x.end.is_some()), (y.rows, y.end.is_some()), "{}", a.name);
            assert!((x.max - y.max).abs() <= 1e-12, "{}: {} {}", a.name, x.max, y.max);
        }
        assert_eq!(kept.explanations.len(), streamed.explanations.len());
    }
}
