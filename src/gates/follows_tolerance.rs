//! The gate of solvers that choose their own steps: the error falls as the tolerance falls, until the floor.
//!
//! An error control per step leaves an error in proportion to the tolerance to the power p/(p+1), and one per unit of
//! time in proportion to the tolerance itself; changes of the step by jumps scatter both. The slope of log error against log
//! tolerance must lie between one half and three halves; an interval that reaches into the band from outside decides nothing.

use super::{Case, ruled};
use crate::metrics::{Place, QuantityLadder};
use crate::model::Quantity;
use crate::record::{Ruling, Verdict};
use crate::regression;

/// The band of the slope.
const BAND: (f64, f64) = (0.5, 1.5);
/// Fewest clear rungs.
const FEWEST: usize = 4;
/// Evaluations at a tolerance over those at the next larger one, where tolerances rule.
const MORE_WORK: f64 = 1.1;
/// An error of this part of the body's size or of a radian is no convergence yet.
const COARSE: f64 = 0.3;

pub(super) fn judge(case: &Case, power: u32) -> Vec<Verdict> {
    let asked = [Quantity::Position, Quantity::Orientation, Quantity::BodyPoint];
    case.evidence
        .ladders
        .iter()
        .filter(|ladder| ladder.place == Place::End && asked.contains(&ladder.quantity))
        .map(|ladder| judge_ladder(case, ladder, power))
        .collect()
}

/// Whether the tolerance of a rung rules the steps, and not the stored times that cut them: the next smaller one makes more work.
fn governs(case: &Case, index: usize) -> bool {
    let work = |rung: usize| case.evidence.rungs.get(rung).map(|rung| rung.outcome.evaluations as f64);
    match (work(index), work(index + 1)) {
        (Some(own), Some(next)) => next >= MORE_WORK * own,
        _ => true,
    }
}

fn judge_ladder(case: &Case, ladder: &QuantityLadder, power: u32) -> Verdict {
    let name = format!("{}-end", ladder.quantity.name());
    let rule = |verdict, detail: String| ruled(case, "follows-tolerance", &name, verdict, detail);
    let Some((_, finest, floor)) = ladder.rungs.last().copied() else {
        return rule(Ruling::Inconclusive, "no runs".to_owned());
    };
    if !finest.is_finite() {
        let why = case.evidence.rungs.last().and_then(|rung| rung.outcome.broken.as_ref());
        return rule(Ruling::Broken, why.map_or("no finite error".to_owned(), ToString::to_string));
    }
    let scale = if ladder.quantity == Quantity::Orientation { 1.0 } else { case.system.body.extent() };
    let clear: Vec<(f64, f64)> = ladder
        .rungs
        .iter()
        .enumerate()
        .filter(|(index, (_, error, floor))| {
            *error > 10.0 * floor && *error < COARSE * scale && governs(case, *index)
        })
        .map(|(_, (step, error, _))| (step.powi(power as i32), *error))
        .collect();
    let at_floor = ladder.rungs.iter().all(|(_, error, floor)| *error <= 10.0 * floor);
    if at_floor {
        return rule(
            Ruling::NotApplicable,
            "at the floor of rounding and reference at every tolerance".to_owned(),
        );
    }
    let Some(fit) = (clear.len() >= FEWEST).then(|| regression::fit_power(&clear)).flatten() else {
        let detail = format!(
            "{} of {} tolerances rule the steps and leave an error between the floor ({floor:.1e}) and the size of the motion; a slope needs {FEWEST}",
            clear.len(),
            ladder.rungs.len()
        );
        return rule(Ruling::Inconclusive, detail);
    };
    let verdict = if fit.slope >= BAND.0 && fit.slope <= BAND.1 {
        Ruling::Pass
    } else if fit.high < BAND.0 || fit.low > BAND.1 {
        Ruling::Fail
    } else {
        Ruling::Inconclusive
    };
    Verdict {
        measured: Some(fit.slope),
        low: Some(fit.low),
        high: Some(fit.high),
        ..rule(
            verdict,
            format!(
                "error ∝ tolerance^{:.2} [{:.2}, {:.2}] over {} tolerances, band {} … {}",
                fit.slope,
                fit.low,
                fit.high,
                clear.len(),
                BAND.0,
                BAND.1
            ),
        )
    }
}
