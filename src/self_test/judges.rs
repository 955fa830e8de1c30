//! Judges that are wrong in one way each: every one must be told from the right one by a ladder.

use super::ladders::{Row, Rungs, TABLE, judge};
use crate::measure::slope;
use crate::record::Ruling;

/// Says something of a ladder and a claimed order.
type Judge = fn(&[(f64, f64, f64)], f64) -> Ruling;

/// A judge that is wrong in one way.
pub struct WrongJudge {
    /// What is wrong.
    pub name: &'static str,
    judge: Judge,
}

impl WrongJudge {
    /// Ladders of the table on which it says something else than what is right.
    pub fn exposed_by(&self) -> impl Iterator<Item = &'static Row> {
        TABLE.iter().filter(|row| (self.judge)(&row.rungs(), f64::from(row.order)) != row.right)
    }
}

/// Half-width of the band.
const BAND: f64 = 0.15;

fn slopes(rungs: &[(f64, f64, f64)]) -> Vec<f64> {
    rungs.windows(2).map(|w| (w[0].1 / w[1].1).abs().log2()).collect()
}

fn within(slope: f64, order: f64, band: f64) -> Ruling {
    if (slope - order).abs() <= band { Ruling::Pass } else { Ruling::Fail }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The right judge on other rungs, or where it says one thing, another.
fn right(rungs: &[(f64, f64, f64)], order: f64) -> Ruling {
    judge(rungs, order as u32)
}

/// The least-squares slope over all rungs.
fn fitted(rungs: &[(f64, f64, f64)]) -> f64 {
    slope(&rungs.iter().map(|(h, error, _)| (h.ln(), error.abs().ln())).collect::<Vec<_>>())
}

fn with_floor(rungs: &[(f64, f64, f64)], floor: fn(f64) -> f64) -> Rungs {
    rungs.iter().map(|(h, e, f)| (*h, *e, floor(*f))).collect()
}

/// Judges that respected projects have had, and some more.
pub const WRONG_JUDGES: &[WrongJudge] = &[
    WrongJudge {
        name: "fails where p < p0 - tolerance, so that NaN passes",
        judge: |rungs, order| {
            if mean(&slopes(rungs)) < order - BAND { Ruling::Fail } else { Ruling::Pass }
        },
    },
    WrongJudge {
        name: "takes the largest pairwise slope",
        judge: |rungs, order| within(slopes(rungs).into_iter().fold(f64::NAN, f64::max), order, BAND),
    },
    WrongJudge {
        name: "takes the smallest pairwise slope",
        judge: |rungs, order| within(slopes(rungs).into_iter().fold(f64::NAN, f64::min), order, BAND),
    },
    WrongJudge {
        name: "has a band of 0.35 about the slope of all rungs",
        judge: |rungs, order| within(fitted(rungs), order, 0.35),
    },
    WrongJudge {
        name: "fits a line through every rung",
        judge: |rungs, order| within(fitted(rungs), order, BAND),
    },
    WrongJudge {
        name: "passes every slope above the band",
        judge: |rungs, order| {
            if fitted(rungs) >= order - BAND { Ruling::Pass } else { right(rungs, order) }
        },
    },
    WrongJudge {
        name: "compares lengths, which have no sign",
        judge: |rungs, order| {
            let lengths: Rungs = rungs.iter().map(|(h, error, off)| (*h, error.abs(), *off)).collect();
            right(&lengths, order)
        },
    },
    WrongJudge {
        name: "knows no other limit than the truth",
        judge: |rungs, order| match (right(rungs, order), fitted(rungs)) {
            (Ruling::Fail, slope) if slope.abs() < 0.5 => Ruling::Inconclusive,
            (other, _) => other,
        },
    },
    WrongJudge {
        name: "takes the two coarsest rungs",
        judge: |rungs, order| slopes(rungs).first().map_or(Ruling::Broken, |s| within(*s, order, BAND)),
    },
    WrongJudge {
        name: "takes the two finest rungs",
        judge: |rungs, order| slopes(rungs).last().map_or(Ruling::Broken, |s| within(*s, order, BAND)),
    },
    WrongJudge { name: "knows no rounding", judge: |rungs, order| right(&with_floor(rungs, |_| 0.0), order) },
    WrongJudge {
        name: "takes 1e-6 for the rounding of everything",
        judge: |rungs, order| right(&with_floor(rungs, |floor| floor.max(1e-6)), order),
    },
    WrongJudge {
        name: "calls too few rungs a pass",
        judge: |rungs, order| match right(rungs, order) {
            Ruling::Inconclusive => Ruling::Pass,
            other => other,
        },
    },
    WrongJudge {
        name: "calls what is undecided a failure",
        judge: |rungs, order| match right(rungs, order) {
            Ruling::Inconclusive => Ruling::Fail,
            other => other,
        },
    },
    WrongJudge {
        name: "leaves out rungs that are not finite",
        judge: |rungs, order| {
            let finite: Rungs = rungs.iter().copied().filter(|rung| rung.1.is_finite()).collect();
            right(&finite, order)
        },
    },
    WrongJudge {
        name: "calls exact what has no error left, and that a pass",
        judge: |rungs, order| match right(rungs, order) {
            Ruling::NotApplicable => Ruling::Pass,
            other => other,
        },
    },
    WrongJudge {
        name: "takes the size of a slope for the slope",
        judge: |rungs, order| {
            let sizes: Vec<f64> = slopes(rungs).into_iter().map(f64::abs).collect();
            within(mean(&sizes), order, BAND)
        },
    },
    WrongJudge {
        name: "forgets the finest rungs, as if they were outliers",
        judge: |rungs, order| right(&rungs[..rungs.len().saturating_sub(4)], order),
    },
    WrongJudge {
        name: "takes the first window that settles, from the coarse end",
        judge: |rungs, order| {
            let windows = (4..=rungs.len()).map(|end| right(&rungs[..end], order));
            windows.into_iter().find(|ruling| *ruling != Ruling::Inconclusive).unwrap_or(Ruling::Inconclusive)
        },
    },
    WrongJudge {
        name: "takes every window that has the order for the order",
        judge: |rungs, order| {
            let any = (4..=rungs.len()).any(|end| right(&rungs[..end], order) == Ruling::Pass);
            if any { Ruling::Pass } else { right(rungs, order) }
        },
    },
];
