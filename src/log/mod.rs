//! A trajectory that another program wrote, held against the reference of its scene at its own times.
//!
//! Errors at the end and the largest, drift of what is conserved, the convention that the log follows, and
//! hints at what it may have meant. Columns may be missing; what needs them is then not applicable, with the
//! reason.

mod file;
mod frames;
mod hints;
mod measure;
mod times;
mod track;

use std::path::Path;

pub use crate::bounded::FileError;
use crate::record::{ClaimName, Measurement, Ruling, RunStatus, Verdict};
use crate::scenes::Scene;

pub use frames::{Convention, Fit, FrameCheck};

use file::{Log, Part};
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
    /// At the last row.
    pub end: f64,
    /// The largest over the rows.
    pub max: f64,
    /// Uncertainty of the reference.
    pub uncertainty: f64,
}

/// All that is to be said about a log.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Rows judged.
    pub rows: usize,
    /// First and last time [s].
    pub span: (f64, f64),
    /// Usual distance of two rows [s].
    pub spacing: f64,
    /// How the reference was made, or why there is none.
    pub reference: Result<String, String>,
    /// Errors and drifts.
    pub findings: Vec<Finding>,
    /// What the user said the log follows.
    pub declared: Convention,
    /// What it follows.
    pub frames: FrameCheck,
    /// What it may have meant.
    pub hints: Vec<String>,
    /// Missing columns, gaps, rows left out.
    pub notes: Vec<String>,
}

/// Judges a file.
///
/// # Errors
/// [`FileError`]: it cannot be read, or is no trajectory.
pub fn judge(path: &Path, scene: &Scene, declared: Convention) -> Result<Judgement, FileError> {
    judge_log(file::read(path)?, scene, declared).map_err(|why| FileError::Content {
        file: path.display().to_string(),
        line: 2,
        why,
    })
}

fn judge_log(mut log: Log, scene: &Scene, declared: Convention) -> Result<Judgement, String> {
    let all = log.rows.len();
    log.rows.retain(|row| row.time() >= 0.0);
    if log.rows.is_empty() {
        return Err("every time is before 0: times count from the start of the motion".to_owned());
    }
    if log.rows.len() < all {
        log.notes.push(format!("{} rows are before t = 0 and were left out", all - log.rows.len()));
    }
    let times: Vec<f64> = log.rows.iter().map(file::Row::time).collect();
    let examined = times::examine(&log.rows);
    let both = log.has(Part::Orientation) && log.has(Part::Spin);
    let last = times.iter().copied().fold(0.0, f64::max);
    let track = if last > LONGEST * scene.duration {
        Err(format!("the log goes on for more than {LONGEST} durations of the scene"))
    } else {
        Track::of(&scene.system, &times).map_err(|error| error.to_string())
    };
    let measured = measure::measure(&log, scene, track.as_ref(), declared);
    let frames = frames::check(&log.rows, both, measured.orientations_agree.then_some(declared));
    let mut hints = hints::of_frames(&frames);
    hints.extend(hints::of_times(last, scene.duration));
    hints.extend(measured.hints);
    log.notes.extend(examined.notes);
    log.notes.extend(measured.notes);
    Ok(Judgement {
        rows: log.rows.len(),
        span: (times[0], times[times.len() - 1]),
        spacing: examined.spacing,
        reference: track.map(|track| track.told),
        findings: measured.findings,
        declared,
        frames,
        hints,
        notes: log.notes,
    })
}

impl Judgement {
    /// The convention that the log follows, where it is another than was said.
    pub fn contradicted(&self) -> Option<Convention> {
        hints::followed(&self.frames).filter(|followed| *followed != self.declared)
    }

    /// The findings as rows of records; `name` stands for the log.
    pub fn measurements(&self, scene: &Scene, name: &str) -> Vec<Measurement> {
        let row = |finding: &Finding, place: &str, value: Option<f64>| Measurement {
            scene: scene.name.clone(),
            scheme: name.to_owned(),
            model: "log".to_owned(),
            step_s: self.spacing,
            steps: self.rows as u64 - 1,
            metric: format!("{}-{place}", finding.name),
            value: value.filter(|value| value.is_finite()),
            unit: finding.unit.to_owned(),
            uncertainty: finding.value.as_ref().ok().map(|value| value.uncertainty),
            status: if finding.value.is_ok() { RunStatus::Ok } else { RunStatus::NotApplicable },
            why: finding.value.as_ref().err().cloned(),
            ..Measurement::default()
        };
        let both = |finding: &Finding| {
            let value = finding.value.as_ref().ok();
            [row(finding, "end", value.map(|v| v.end)), row(finding, "max", value.map(|v| v.max))]
        };
        self.findings.iter().flat_map(both).collect()
    }

    /// The frame check as a verdict.
    pub fn verdict(&self, scene: &Scene, name: &str) -> Verdict {
        let verdict = match &self.frames {
            FrameCheck::Follows(_) if self.contradicted().is_some() => Ruling::Fail,
            FrameCheck::Alike(fits) if fits.iter().any(|fit| fit.convention == self.declared) => Ruling::Pass,
            FrameCheck::Follows(_) => Ruling::Pass,
            FrameCheck::Alike(_) | FrameCheck::None(_) => Ruling::Inconclusive,
            FrameCheck::Nothing(_) => Ruling::NotApplicable,
        };
        Verdict {
            scene: scene.name.clone(),
            scheme: name.to_owned(),
            claim: ClaimName::Frames,
            quantity: "angular-velocity".to_owned(),
            verdict,
            detail: self.frames_in_words(),
            ..Verdict::default()
        }
    }

    /// What the frame check found.
    pub fn frames_in_words(&self) -> String {
        let told = |fit: &Fit| {
            format!(
                "{} (dq/dt = {:.6} × ½ w q, {:.1e} of it left)",
                fit.convention.words(),
                fit.factor,
                fit.left
            )
        };
        match &self.frames {
            FrameCheck::Nothing(why) => format!("no frame check: {why}"),
            FrameCheck::None(best) => format!("the log follows no convention; the nearest is {}", told(best)),
            FrameCheck::Alike(fits) => format!(
                "this motion does not tell apart {}",
                fits.iter().map(told).collect::<Vec<_>>().join(" and ")
            ),
            FrameCheck::Follows(fit) if fit.convention == self.declared => {
                format!("the log follows {}, as was said", told(fit))
            }
            FrameCheck::Follows(fit) => format!(
                "the log follows {}, and not {} as was said: the errors below are those of a misread log",
                told(fit),
                self.declared.words()
            ),
        }
    }
}
