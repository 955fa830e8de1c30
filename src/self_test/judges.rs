//! Judges that are wrong in one way each: every one must be told from the right one by a ladder.

use super::ladders::{Row, Rungs, TABLE, judge};
use crate::measure::regression::fit_power;
use crate::measure::{Place, QuantityLadder};
use crate::model::Quantity;
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
    pub fn told_by(&self) -> impl Iterator<Item = &'static Row> {
        TABLE.iter().filter(|row| (self.judge)(&row.rungs(), f64::from(row.order)) != row.right)
    }
}

/// Half-width of the band.
const BAND: f64 = 0.15;

fn slopes(rungs: &[(f64, f64, f64)]) -> Vec<f64> {
    rungs.windows(2).map(|w| (w[0].1 / w[1].1).ln() / (w[0].0 / w[1].0).ln()).collect()
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

/// The slope and its interval over the window that the right judge finds.
fn fitted(rungs: &[(f64, f64, f64)]) -> Option<crate::measure::regression::Fit> {
    QuantityLadder::of(Quantity::BodyPoint, Place::End, rungs.to_vec(), 1).fit()
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
        name: "takes the mean of log2 whatever the ratio of steps",
        judge: |rungs, order| {
            let logs: Vec<f64> = rungs.windows(2).map(|w| (w[0].1 / w[1].1).log2()).collect();
            within(mean(&logs), order, BAND)
        },
    },
    WrongJudge {
        name: "has a band of 0.35",
        judge: |rungs, order| match (fitted(rungs), right(rungs, order)) {
            (Some(fit), _) => within(fit.slope, order, 0.35),
            (None, other) => other,
        },
    },
    WrongJudge {
        name: "looks at no interval",
        judge: |rungs, order| match (fitted(rungs), right(rungs, order)) {
            (Some(fit), _) => within(fit.slope, order, BAND),
            (None, other) => other,
        },
    },
    WrongJudge {
        name: "passes every slope above the band",
        judge: |rungs, order| match (fitted(rungs), right(rungs, order)) {
            (Some(fit), _) if fit.low > order + BAND => Ruling::Pass,
            (_, other) => other,
        },
    },
    WrongJudge {
        name: "passes where the interval touches the band",
        judge: |rungs, order| match (fitted(rungs), right(rungs, order)) {
            (Some(fit), _) if fit.low <= order + BAND && fit.high >= order - BAND => Ruling::Pass,
            (_, other) => other,
        },
    },
    WrongJudge {
        name: "fits a line through every rung",
        judge: |rungs, order| {
            let points: Vec<_> = rungs.iter().map(|r| (r.0, r.1)).collect();
            fit_power(&points).map_or(Ruling::Inconclusive, |fit| within(fit.slope, order, BAND))
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
    WrongJudge { name: "knows no floor", judge: |rungs, order| right(&with_floor(rungs, |_| 0.0), order) },
    WrongJudge {
        name: "takes 1e-6 for the floor of everything",
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
    WrongJudge {
        name: "holds a slope against the order before it has come down to it",
        judge: |rungs, order| match (fitted(rungs), right(rungs, order)) {
            (Some(fit), _) if fit.low > order + BAND || fit.high < order - BAND => Ruling::Fail,
            (_, other) => other,
        },
    },
];
