//! L·g of a body on a pivot under uniform gravity, constant because every torque c × M g is across g.

use super::{Case, at_most, ruled};
use crate::measure;
use crate::record::{ClaimName, Ruling, Verdict};

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    let name = "vertical-momentum";
    let index = measure::ALL.iter().position(|metric| metric.name == name);
    let worst = case
        .evidence
        .rungs
        .iter()
        .filter_map(|rung| Some((rung.readings.get(index?).copied()??.max, rounding(rung.steps))))
        .max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)));
    vec![match worst {
        None => {
            let detail = "not a body on a pivot under uniform gravity alone";
            ruled(case, ClaimName::VerticalMomentum, name, Ruling::NotApplicable, detail)
        }
        Some((change, bound)) => {
            let detail = format!("largest change of L·g over |L||g|: {change:.2e} ≤ {bound:.2e}");
            at_most(case, ClaimName::VerticalMomentum, name, change, bound, detail)
        }
    }]
}

/// Each of n sums L + h τ is rounded by at most u |L|: √n of them in the mean, four times that at most.
fn rounding(steps: u64) -> f64 {
    f64::EPSILON * (8.0 + 4.0 * (steps as f64).sqrt())
}
