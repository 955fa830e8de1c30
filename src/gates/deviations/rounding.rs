//! Promises of exactness and of sameness that rounding alone breaks.

use super::Deviation;

pub(super) const KNOWN: &[Deviation] = &[
    Deviation {
        reason: "L is exact but for rounding, and the torques of the weight, which cancel in their sum to rounding, are \
                 added to it in every step: in a million steps they pass the bound",
        claim: "exact",
        quantities: &[],
        places: &[(
            "nasa-check-case-2",
            &["course-code-euler", "euler-linear", "rk2-linear", "substepped-4-euler"],
        )],
    },
    Deviation {
        reason: "L, constant but for rounding, differs by up to 223 of its floors between worlds; the floor does not count the torques \
                 of the weight, which cancel in their sum to rounding, and that is taken to be the cause",
        claim: "equivariant",
        quantities: &[],
        places: &[("nasa-check-case-2", &["rk2-linear"])],
    },
];
