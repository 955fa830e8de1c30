//! The rigidity gate: distances between points of the point form change by rounding only.

use super::{Case, at_most, ruled};
use crate::record::{Ruling, Verdict};

/// Rounding of n exact rotations of a point: up to 1.3 √n u where the axis tumbles and 0.007 n u where it
/// stands still, as measured; allowed is three times either.
fn rounding(steps: u64) -> f64 {
    f64::EPSILON * (8.0 + 4.0 * (steps as f64).sqrt() + 0.02 * steps as f64)
}

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    let Some(points) = case.points else {
        let detail = "no point form: the body has none, or the scheme takes none";
        return vec![ruled(case, "rigid", "rigidity", Ruling::NotApplicable, detail)];
    };
    let bound = rounding(points.steps);
    let detail = format!(
        "largest change of a distance in {} steps of the point form, over the extent: {:.2e} ≤ {bound:.2e}",
        points.steps, points.stretch
    );
    vec![at_most(case, "rigid", "rigidity", points.stretch, bound, detail)]
}
