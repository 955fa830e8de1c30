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
        reason: "a step takes L apart into moments and spins and puts it together again, a dozen roundings where the floor \
                 counts one, and the long tumble amplifies them to 4 times the bound",
        claim: "equivariant",
        quantities: &[],
        places: &[("osrf-boxes-complex", &["generalized-alpha"])],
    },
];
