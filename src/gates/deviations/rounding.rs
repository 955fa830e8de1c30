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
    Deviation {
        reason: "for most of its time the body spins almost steadily about its middle axis, where every step rounds alike: the \
                 roundings add up faster than as the root of n, which is what the floor counts, to 14 times that at most",
        claim: "equivariant",
        quantities: &[],
        places: &[("dzhanibekov", &["exact-rotor", "yoshida-4", "kahan-li-6", "kahan-li-8"])],
    },
];
