//! Promises of exactness that rounding alone breaks.

use super::Deviation;
use crate::record::ClaimName;

pub(super) const KNOWN: &[Deviation] = &[Deviation {
    reason: "L is exact but for rounding, and the torques of the weight, which cancel in their sum to rounding, are \
                 added to it in every step: in a million steps they pass the bound",
    claim: ClaimName::Exact,
    quantities: &[],
    places: &[("nasa-check-case-2", &["course-code-euler", "euler-linear", "substepped-4-euler"])],
}];
