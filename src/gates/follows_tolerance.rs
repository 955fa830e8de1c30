//! The gate of solvers that choose their own steps: the error falls as the tolerance falls, until the floor.
//!
//! An error control per step leaves an error in proportion to the tolerance to the power p/(p+1), and one per unit of
//! time in proportion to the tolerance itself; changes of the step by jumps scatter both. The slope of log error against log
//! tolerance must lie between one half and three halves; an interval that reaches into the band from outside decides nothing.

use super::{Case, ruled};
use crate::measure::regression;
use crate::measure::{self, FEWEST_TOLERANCES, QuantityLadder};
use crate::record::{ClaimName, Ruling, Verdict};

/// The band of the slope.
const BAND: (f64, f64) = (0.5, 1.5);
/// What leaves a slope open.
const SCATTERED: &str =
    "; whole steps between the stored times, few as they are, jump in number and scatter the errors";

pub(super) fn judge(case: &Case, power: u32) -> Vec<Verdict> {
    let asked = case.evidence.ladders.iter().filter(|ladder| measure::judged_by_tolerance(ladder));
    asked.map(|ladder| judge_ladder(case, ladder, power)).collect()
}

fn judge_ladder(case: &Case, ladder: &QuantityLadder, power: u32) -> Verdict {
    let name = format!("{}-end", ladder.quantity.name());
    let rule = |verdict, detail: String| ruled(case, ClaimName::FollowsTolerance, &name, verdict, detail);
    let Some((_, finest, floor)) = ladder.rungs.last().copied() else {
        return rule(Ruling::Inconclusive, "no runs".to_owned());
    };
    if !finest.is_finite() {
        let why = case.evidence.rungs.last().and_then(|rung| rung.outcome.broken.as_ref());
        return rule(Ruling::Broken, why.map_or("no finite error".to_owned(), ToString::to_string));
    }
    let governed = measure::governed(case.evidence, ladder, case.system, power);
    let clear = &governed.rungs;
    let at_floor = ladder.rungs.iter().all(|(_, error, floor)| *error <= 10.0 * floor);
    if at_floor {
        return rule(
            Ruling::NotApplicable,
            "at the floor of rounding and reference at every tolerance".to_owned(),
        );
    }
    let Some(fit) = (clear.len() >= FEWEST_TOLERANCES).then(|| regression::fit_power(clear)).flatten() else {
        let detail = format!(
            "{} of {} tolerances say how the error follows, and a slope needs {FEWEST_TOLERANCES}: the others leave an error as large as the motion ({}), at its floor of {floor:.1e} ({}), or the steps to the stored times and the solver's first guess ({})",
            clear.len(),
            ladder.rungs.len(),
            governed.coarse,
            governed.at_floor,
            governed.ruled_otherwise,
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
                "error ∝ tolerance^{:.2} [{:.2}, {:.2}] over {} tolerances, band {} … {}{}",
                fit.slope,
                fit.low,
                fit.high,
                clear.len(),
                BAND.0,
                BAND.1,
                if verdict == Ruling::Inconclusive { SCATTERED } else { "" }
            ),
        )
    }
}
