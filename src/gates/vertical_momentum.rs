//! L·g of a body on a pivot under uniform gravity, constant because every torque c × M g is across g.

use super::{at_most, ruled, walk};
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let name = "vertical-momentum";
    // Each of n sums L + h τ is rounded by at most u |L|.
    let changes = evidence
        .ladder
        .rungs
        .iter()
        .filter_map(|rung| Some((rung.vertical_momentum?, f64::EPSILON * walk(rung.steps))));
    let Some((change, bound)) = changes.max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1))) else {
        let detail = "not a body on a pivot under uniform gravity alone";
        return ruled(evidence, ClaimName::VerticalMomentum, name, Ruling::NotApplicable, detail);
    };
    let detail = format!("largest change of L·g over |L||g|: {change:.2e} ≤ {bound:.2e}");
    at_most(evidence, ClaimName::VerticalMomentum, name, change, bound, detail)
}
