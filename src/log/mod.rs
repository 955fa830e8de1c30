//! A trajectory that another program wrote, held against the reference of its scene at its own times.
//!
//! Errors at the end and the largest, the metrics of a run, the convention that the log follows, and the fixed change that explains it.
//! Columns may be missing; what needs them is then not applicable, with the reason.

mod columns;
mod euler;
mod explain;
mod file;
mod frames;
mod layout;
mod measure;
mod row;
mod said;
mod series;
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

use measure::Reader;
use row::{Log, Part, Parts};
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

/// Judges a file.
///
/// # Errors
/// [`FileError`]: it cannot be read, or is no trajectory.
pub fn judge(path: &Path, scene: &Scene, request: &Request) -> Result<Judgement, FileError> {
    judge_log(file::read(path, &request.said)?, scene, request).map_err(|why| FileError::Content {
        file: path.display().to_string(),
        line: 2,
        why,
    })
}

/// Judges the text of a file.
///
/// # Errors
/// [`FileError`]: it is no trajectory.
pub fn judge_text(text: &str, scene: &Scene, request: &Request) -> Result<Judgement, FileError> {
    judge_log(file::parse(text, "log", &request.said)?, scene, request).map_err(|why| FileError::Content {
        file: "log".to_owned(),
        line: 2,
        why,
    })
}

fn judge_log(mut log: Log, scene: &Scene, request: &Request) -> Result<Judgement, String> {
    let mut declared = Convention {
        spin_in_body_axes: request.spin_in_body_axes.unwrap_or(log.reading.spin_in_body_axes),
        world_to_body: request.world_to_body.unwrap_or(false),
    };
    if request.spin_in_body_axes.is_none() && declared.spin_in_body_axes {
        log.notes.push("angular velocities are in body axes, as the names of the columns say".to_owned());
    }
    leave_out(&mut log, |row| row.time() >= 0.0, "are before t = 0")?;
    let mut scene = scene.clone();
    if let Some(row) = request.from_log {
        start_at(&mut scene, &mut log, row, declared)?;
    }
    let track = track(&scene, &log);
    if request.as_found {
        let (_, frames) = compared(&log, &scene, track.as_ref(), declared, &mut Vec::new());
        if let FrameCheck::Follows(fit) = frames {
            declared = fit.convention;
        }
    }
    let examined = times::examine(&log.rows);
    let mut notes = std::mem::take(&mut log.notes);
    notes.extend(examined.notes);
    let (findings, frames) = compared(&log, &scene, track.as_ref(), declared, &mut notes);
    let reader = Reader { log: &log, system: &scene.system, declared };
    let explanations = explanations(&reader, &scene);
    let series = match &track {
        Ok(track) if request.series => series::series(&reader, track),
        _ => Series::default(),
    };
    Ok(Judgement {
        reading: log.reading.words.clone(),
        rows: log.rows.len(),
        span: (log.rows[0].time(), log.rows[log.rows.len() - 1].time()),
        spacing: examined.spacing,
        reference: track.map(|track| track.told),
        findings,
        declared,
        frames,
        series,
        explanations,
        notes,
    })
}

/// What explains the log, where anything needs to be explained.
fn explanations(reader: &Reader, scene: &Scene) -> Vec<Explanation> {
    let last = reader.log.rows.iter().map(row::Row::time).fold(0.0, f64::max);
    // A log that starts late, or in another unit of time, is looked for within twice its length or the scene's.
    let last = if last > LONGEST * scene.duration { scene.duration } else { last.max(scene.duration) };
    let last = 2.0 * last;
    match Track::dense(&scene.system, last) {
        Ok(track) => explain::explain(*reader, &track),
        Err(_) => Vec::new(),
    }
}

fn leave_out(log: &mut Log, keep: impl Fn(&row::Row) -> bool, why: &str) -> Result<(), String> {
    let all = log.rows.len();
    log.rows.retain(keep);
    match all - log.rows.len() {
        0 => Ok(()),
        count if count == all => Err(format!("all rows {why}: times count from the start of the motion")),
        count => {
            log.notes.push(format!("{count} rows {why} and were left out"));
            Ok(())
        }
    }
}

fn track(scene: &Scene, log: &Log) -> Result<Track, String> {
    let times: Vec<f64> = log.rows.iter().map(row::Row::time).collect();
    let last = times.iter().copied().fold(0.0, f64::max);
    if last > LONGEST * scene.duration {
        return Err(format!(
            "the log ends at t = {last} s, after more than {LONGEST} durations of the scene ({} s)",
            scene.duration
        ));
    }
    Track::of(&scene.system, &times).map_err(|error| error.to_string())
}

/// The findings and the frame check under a convention.
fn compared(
    log: &Log,
    scene: &Scene,
    track: Result<&Track, &String>,
    declared: Convention,
    notes: &mut Vec<String>,
) -> (Vec<Finding>, FrameCheck) {
    let reader = Reader { log, system: &scene.system, declared };
    let findings = measure::measure(&reader, track, notes);
    let agree = findings.iter().any(|finding| {
        let small = |value: &Value| value.max <= ORIENTATIONS_AGREE;
        finding.name == "orientation" && finding.value.as_ref().is_ok_and(small)
    });
    let both = log.parts.covers(Parts::of(&[Part::Orientation, Part::Spin]));
    let fastest = track.map_or(0.0, |track| measure::fastest(&track.samples()));
    let frames = frames::check(&log.rows, both, agree.then_some(declared), fastest);
    (findings, frames)
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
    let reader = Reader { log, system: &scene.system, declared };
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
