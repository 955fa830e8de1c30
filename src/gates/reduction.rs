//! The reduced model against the note as written: the same scheme, so they agree to rounding.

use super::{at_most, ruled};
use crate::measure::CLEAR;
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

/// Largest difference of any quantity, over its scale, in units of the arithmetic: a few times √1000 roundings. Where the moments of
/// a body lie far apart a rounding of its points turns the axis of the smallest one, and L about it is another: copies show what that makes
/// of the roundings.
const LARGEST: f64 = 4096.0;

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let rule = |detail| ruled(evidence, ClaimName::Reduction, "all", Ruling::NotApplicable, detail);
    if evidence.model == "points" {
        return rule("the scheme runs on the mass points alone");
    }
    let Some(points) = &evidence.points else {
        return rule("no point form: the body has none, or the scheme takes none");
    };
    // What Σ X̃_k × F_k adds to L by rounding turns the body by as much again for each radian of the run, two here.
    let rounding = if points.torque_rounding.is_finite() { 3.0 * points.torque_rounding } else { 0.0 };
    let bound = LARGEST * points.unit + rounding + CLEAR * points.rounding;
    let detail = format!(
        "largest difference between model '{}' and the mass points in {} steps, over the scale of each quantity: {:.2e} ≤ {bound:.1e}",
        evidence.model, points.steps, points.difference
    );
    at_most(evidence, ClaimName::Reduction, "all", points.difference, bound, detail)
}
