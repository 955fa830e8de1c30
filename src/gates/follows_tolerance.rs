//! The gate of solvers that choose their own steps: the error falls as the tolerance falls, until rounding.
//!
//! An error control per step leaves an error in proportion to the tolerance to the power p/(p+1), and one per unit of
//! time in proportion to the tolerance itself; changes of the step by jumps scatter both. The least-squares slope of log error against log
//! tolerance must lie between one half and three halves.

use super::ruled;
use crate::measure::{Asked, BELOW, FEWEST, Run, slope};
use crate::model::Quantity;
use crate::record::{ClaimName, Evidence, Rule, Ruling, Rung, Verdict, length};

/// The band of the slope.
const BAND: (f64, f64) = (0.5, 1.5);
/// Evaluations at a tolerance over those at the next larger one, where tolerances rule.
const MORE_WORK: f64 = 1.1;

pub(super) fn judge(evidence: &Evidence, power: u32) -> Vec<Verdict> {
    [Quantity::Position, Quantity::Orientation, Quantity::BodyPoint]
        .into_iter()
        .map(|quantity| judge_quantity(evidence, quantity, power))
        .collect()
}

fn judge_quantity(evidence: &Evidence, quantity: Quantity, power: u32) -> Verdict {
    let rule = |ruling, detail| ruled(evidence, ClaimName::FollowsTolerance, quantity.name(), ruling, detail);
    if let Some(reason) = &evidence.setting.not_for_order {
        return rule(Ruling::NotApplicable, reason.clone());
    }
    let asked = Asked::of(&evidence.ladder, quantity);
    let rungs = &evidence.ladder.rungs;
    let samples = asked.times.len();
    // An error counts between rounding, of as many operations as there are evaluations, and the size of the motion, and where the next smaller
    // tolerance makes more work: otherwise the stored times, which cut steps, or the solver's first guess rule.
    let floor =
        |(run, rung): (&Run, &Rung)| asked.floor(&Run { steps: rung.evaluations, ..run.clone() }, samples);
    let governs = |index: usize| match rungs.get(index + 1) {
        Some(next) => next.evaluations as f64 >= MORE_WORK * rungs[index].evaluations as f64,
        None => true,
    };
    let mut clear: Vec<(f64, f64)> = Vec::new();
    let mut exact = true;
    for (index, pair) in asked.runs.iter().zip(rungs).enumerate() {
        let (error, floor) = (length(&pair.0.errors), floor(pair));
        exact &= error <= floor;
        let converges = error < BELOW * asked.scale * (samples as f64).sqrt();
        if pair.1.broken.is_none() && error > floor && converges && governs(index) {
            clear.push((f64::from(power) * pair.0.step.ln(), error.ln()));
        }
    }
    if exact {
        return rule(Ruling::NotApplicable, "every error is at its rounding".to_owned());
    }
    if clear.len() < FEWEST {
        let detail = format!(
            "{} of {} tolerances say how the error follows, and a slope needs {FEWEST}: the others leave an error as large as the motion, at its rounding, or the steps to the stored times",
            clear.len(),
            rungs.len()
        );
        return rule(Ruling::Inconclusive, detail).by(Rule::FewRuns);
    }
    let slope = slope(&clear);
    let ruling = if (BAND.0..=BAND.1).contains(&slope) { Ruling::Pass } else { Ruling::Fail };
    let detail =
        format!("error ∝ tolerance^{slope:.2} over {} tolerances, band {} … {}", clear.len(), BAND.0, BAND.1);
    Verdict { measured: Some(slope), low: Some(BAND.0), high: Some(BAND.1), ..rule(ruling, detail) }
}
