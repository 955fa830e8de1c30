//! The last word about a log: the largest error of a quantity against a limit, and the rows of records.

use super::frames::{Convention, Fit, FrameCheck};
use super::{Finding, Judgement};
use crate::model::Quantity;
use crate::record::{self, ClaimName, Measurement, Ruling, RunStatus};
use crate::scenes::Scene;

/// The least part of the rows that must have a quantity: a maximum over fewer is not one over the run.
const MOST: f64 = 0.5;

/// Whether the largest error of a quantity is within a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The quantity.
    pub quantity: Quantity,
    /// The limit, in its SI unit.
    pub limit: f64,
    /// Pass, fail, or inconclusive.
    pub ruling: Ruling,
    /// The largest error, and its time [s].
    pub largest: Option<(f64, f64)>,
    /// Rows that have it, and all rows.
    pub rows: (usize, usize),
    /// Why it is inconclusive.
    pub why: Option<String>,
}

impl Verdict {
    /// The line that ends the output.
    pub fn in_words(&self) -> String {
        let (quantity, unit) = (self.quantity.name(), self.quantity.unit());
        let size = self.largest.map_or(String::new(), |(size, time)| {
            let sign = if self.ruling == Ruling::Fail { ">" } else { "<=" };
            let sign = if self.ruling == Ruling::Inconclusive { "against" } else { sign };
            format!(": largest error {size:.4e} {unit} {sign} limit {:e} {unit}, at t = {time} s", self.limit)
        });
        let (some, all) = self.rows;
        let rows = if some < all { format!(" ({some} of {all} rows have it)") } else { String::new() };
        match (self.ruling, &self.why) {
            (Ruling::Pass, _) => format!("PASS {quantity}{size}{rows}"),
            (Ruling::Fail, _) => format!("FAIL {quantity}{size}{rows}"),
            (_, why) => {
                format!("UNDECIDED {quantity}{size}; {}", why.as_deref().unwrap_or("there is no number"))
            }
        }
    }
}

impl Judgement {
    /// Holds the largest error of a quantity against a limit.
    pub fn against(&self, quantity: Quantity, limit: f64) -> Verdict {
        let finding = self.findings.iter().find(|finding| finding.name == quantity.name());
        let rows = finding.and_then(|finding| finding.value.as_ref().ok()).map_or(0, |value| value.rows);
        let rows = (rows, self.rows);
        let verdict = |ruling, largest, why| Verdict { quantity, limit, ruling, largest, rows, why };
        let undecided = |largest, why: String| verdict(Ruling::Inconclusive, largest, Some(why));
        let Some(finding) = finding else { return undecided(None, "it was not measured".to_owned()) };
        let value = match &finding.value {
            Ok(value) => value,
            Err(why) => return undecided(None, why.clone()),
        };
        let largest = Some((value.max, value.time));
        if let Some(followed) = self.contradicted() {
            return undecided(largest, format!("the log follows {}", followed.words()));
        }
        if value.max > limit {
            return verdict(Ruling::Fail, largest, None);
        }
        if self.span.1 == 0.0 {
            return undecided(largest, "every row is at t = 0: nothing has moved".to_owned());
        }
        if value.end.is_none() {
            return undecided(largest, format!("the last row has no {}", quantity.name()));
        }
        if (value.rows as f64) < MOST * self.rows as f64 {
            return undecided(largest, format!("only {} of {} rows have it", value.rows, self.rows));
        }
        if value.max.is_nan() {
            return undecided(largest, "the error is not a number".to_owned());
        }
        if value.uncertainty.is_nan() || value.uncertainty > limit {
            return undecided(largest, format!("the reference is known to {:.1e} only", value.uncertainty));
        }
        verdict(Ruling::Pass, largest, None)
    }

    /// The convention that the log follows, where it is another than it was read by.
    pub fn contradicted(&self) -> Option<Convention> {
        match &self.frames {
            FrameCheck::Follows(fit) if fit.convention != self.declared => Some(fit.convention),
            _ => None,
        }
    }

    /// The findings as rows of records; `name` stands for the log.
    pub fn measurements(&self, scene: &Scene, name: &str) -> Vec<Measurement> {
        let row = |finding: &Finding, place: &str, value: Option<f64>| {
            let value = value.filter(|value| value.is_finite());
            let lost = "the last row has no value, or it is not a number".to_owned();
            let why = finding.value.as_ref().err().cloned();
            Measurement {
                scene: scene.name.clone(),
                scheme: name.to_owned(),
                model: "log".to_owned(),
                step_s: self.spacing,
                steps: self.rows as u64 - 1,
                metric: format!("{}-{place}", finding.name),
                value,
                unit: finding.unit.to_owned(),
                uncertainty: finding
                    .value
                    .as_ref()
                    .ok()
                    .map(|value| value.uncertainty)
                    .filter(|u| u.is_finite()),
                status: if value.is_some() { RunStatus::Ok } else { RunStatus::NotApplicable },
                why: why.or(value.is_none().then_some(lost)),
                ..Measurement::default()
            }
        };
        let both = |finding: &Finding| {
            let value = finding.value.as_ref().ok();
            [row(finding, "end", value.and_then(|v| v.end)), row(finding, "max", value.map(|v| v.max))]
        };
        self.findings.iter().flat_map(both).collect()
    }

    /// The frame check as a verdict.
    pub fn frame_verdict(&self, scene: &Scene, name: &str) -> record::Verdict {
        let verdict = match &self.frames {
            FrameCheck::Follows(_) if self.contradicted().is_some() => Ruling::Fail,
            FrameCheck::Alike(fits) if fits.iter().any(|fit| fit.convention == self.declared) => Ruling::Pass,
            FrameCheck::Follows(_) => Ruling::Pass,
            FrameCheck::Alike(_) | FrameCheck::None(_) => Ruling::Inconclusive,
            FrameCheck::Nothing(_) => Ruling::NotApplicable,
        };
        record::Verdict {
            scene: scene.name.clone(),
            scheme: name.to_owned(),
            claim: ClaimName::Frames,
            quantity: "angular-velocity".to_owned(),
            verdict,
            rule: ClaimName::Frames.word().into(),
            detail: self.frames_in_words(),
            ..record::Verdict::default()
        }
    }

    /// What the frame check found.
    pub fn frames_in_words(&self) -> String {
        let fitted = |fit: &Fit| {
            let (words, factor, left) = (fit.convention.words(), fit.factor, fit.left);
            format!("{words} (dq/dt = {factor:.6} × ½ w q, {left:.1e} of it left)")
        };
        match &self.frames {
            FrameCheck::Nothing(why) => format!("no frame check: {why}"),
            FrameCheck::None(best) => {
                format!("the log follows no convention; the nearest is {}", fitted(best))
            }
            FrameCheck::Alike(fits) => format!(
                "this motion does not tell apart {}",
                fits.iter().map(fitted).collect::<Vec<_>>().join(" and ")
            ),
            FrameCheck::Follows(fit) if fit.convention == self.declared => {
                format!("the log follows {}, as it was read", fitted(fit))
            }
            FrameCheck::Follows(fit) => format!(
                "the log follows {}, and not {} as it was read: the errors below are those of a misread log; --as-found reads it so",
                fitted(fit),
                self.declared.words()
            ),
        }
    }
}
