//! The rigidity gate: distances between points of the point form change by rounding only.

use super::{at_most, ruled, walk};
use crate::record::{ClaimName, Evidence, PointRun, Ruling, Verdict};

/// Rounding of n exact rotations of a point in units u: up to 1.3 √n u where the axis tumbles, as measured, and allowed three
/// times that. Where the axis stands still every rotation is the same and rounds the same way: n u.
fn rounding(points: &PointRun, steady: bool) -> f64 {
    points.unit * (walk(points.steps) + if steady { points.steps as f64 } else { 0.0 })
}

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let Some(points) = &evidence.points else {
        let detail = "no point form: the body has none, or the scheme takes none";
        return ruled(evidence, ClaimName::Rigid, "rigidity", Ruling::NotApplicable, detail);
    };
    let bound = rounding(points, evidence.setting.steady_spin);
    let detail = format!(
        "largest change of a distance in {} steps of the point form, over the extent: {:.2e} ≤ {bound:.2e}",
        points.steps, points.stretch
    );
    at_most(evidence, ClaimName::Rigid, "rigidity", points.stretch, bound, detail)
}
