//! The reduced model against the note as written: the same scheme, so they agree to rounding.

use super::{Case, at_most};
use crate::model::body::Shape;
use crate::record::{Ruling, Verdict};

/// Largest difference of any quantity, over its scale, after 1,000 steps: a few times √1000 roundings.
const LARGEST: f64 = 1e-12;
/// Roundings, over the condition of I, that a solution of I Ω = L with a summed I may be off by: those of the sum and those of
/// an elimination in three unknowns.
const SOLVED_TO: f64 = 8.0 * f64::EPSILON;
/// Radians that a run turns.
const TURNED: f64 = 2.0;

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    if case.evidence.model == "points" {
        let detail = "the scheme runs on the mass points alone";
        return vec![super::ruled(case, "reduction", "all", Ruling::NotApplicable, detail)];
    }
    let Some(points) = case.points else {
        let detail = "no point form: the body has none, or the scheme takes none";
        return vec![super::ruled(case, "reduction", "all", Ruling::NotApplicable, detail)];
    };
    // What Σ X̃_k × F_k adds to L by rounding turns the body by as much again for each radian of the run, two here.
    let rounding = if points.torque_rounding.is_finite() { 4.0 * 3.0 * points.torque_rounding } else { 0.0 };
    let moments = case.system.body.moments;
    let condition = if case.system.body.shape == Shape::Extended { moments.max() / moments.min() } else { 1.0 };
    let bound = LARGEST + rounding + TURNED * SOLVED_TO * condition;
    let detail = format!(
        "largest difference between model '{}' and the mass points in {} steps, over the scale of each quantity: {:.2e} ≤ {bound:.1e}",
        case.evidence.model, points.steps, points.difference
    );
    vec![at_most(case, "reduction", "all", points.difference, bound, detail)]
}
