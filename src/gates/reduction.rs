//! The reduced model against the note as written: the same scheme, so they agree to rounding.

use super::{Case, at_most};
use crate::record::{ClaimName, Ruling, Verdict};

/// Largest difference of any quantity, over its scale, after 1,000 steps: a few times √1000 roundings. Where the moments of
/// a body lie far apart a rounding of its points turns the axis of the smallest one, and L about it is another: what that makes
/// of the roundings is measured.
const LARGEST: f64 = 1e-12;
/// Roundings of the point form that a difference may have.
const CLEAR: f64 = 10.0;

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    if case.evidence.model == "points" {
        let detail = "the scheme runs on the mass points alone";
        return vec![super::ruled(case, ClaimName::Reduction, "all", Ruling::NotApplicable, detail)];
    }
    let Some(points) = case.points else {
        let detail = "no point form: the body has none, or the scheme takes none";
        return vec![super::ruled(case, ClaimName::Reduction, "all", Ruling::NotApplicable, detail)];
    };
    // What Σ X̃_k × F_k adds to L by rounding turns the body by as much again for each radian of the run, two here.
    let rounding = if points.torque_rounding.is_finite() { 3.0 * points.torque_rounding } else { 0.0 };
    let bound = LARGEST + rounding + CLEAR * points.rounding;
    let detail = format!(
        "largest difference between model '{}' and the mass points in {} steps, over the scale of each quantity: {:.2e} ≤ {bound:.1e}",
        case.evidence.model, points.steps, points.difference
    );
    vec![at_most(case, ClaimName::Reduction, "all", points.difference, bound, detail)]
}
