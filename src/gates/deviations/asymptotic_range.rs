//! Orders whose asymptotic range, above rounding, is too short or is not reached.

use super::Deviation;
use crate::record::ClaimName;

const FEW_RUNGS: &str = "the slopes settle at the claimed order, but between the steps where they begin to and those where \
     rounding takes over there are fewer rungs than a window needs";

const TWO_TERMS: &str = "two terms of the error, the leading one and the next, stay of one size down to the steps where rounding \
     takes over: the slope is still on its way to the claimed order, or its interval reaches out of the band";

const COLD_START: &str = "the order of 2 comes from the first steps alone, whose history is made up; the formula's own error of \
     order 3 or 4 covers that of the start down to the last steps above rounding";

const SCATTERED: &str = "over 600 radians and more: the slope is inside the band, but the errors of all clear rungs scatter about it, and \
     the interval that allows for their scatter reaches out of the band";

const MANY_TURNS: &str = "the splitting takes the body apart into turns about its axes, and about the axis of the thin body's small \
     moment each turns it many times in a step: only the last step of the ladder is asymptotic";

const FLIPS_CANCEL: &str = "two parts of the error of a flip's time, ∝ h² and what the logarithmic period makes of the energy, have other \
     signs and cancel within the steps of the ladder: behind that the slopes rise again, and are not at rest at its last steps";

/// An order that cannot be read, in these scenes.
const fn order(
    reason: &'static str,
    places: &'static [(&'static str, &'static [&'static str])],
) -> Deviation {
    Deviation { reason, claim: ClaimName::Order, quantities: &[], places }
}

pub(super) const KNOWN: &[Deviation] = &[
    order(
        FEW_RUNGS,
        &[
            ("exact-separatrix", &["kahan-li-8"]),
            ("euler-top-unit", &["crouch-grossman-3"]),
            ("free-asymmetric", &["kahan-li-8"]),
            ("free-oblate", &["kahan-li-8"]),
            ("gravity-drag", &["gauss-legendre-6"]),
            ("gravity-gradient", &["kahan-li-8"]),
            ("lagrange-fast-top", &["kahan-li-8"]),
            ("mujoco-fast-spin", &["kahan-li-8", "moser-veselov-10"]),
            ("nasa-check-case-2", &["kahan-li-8", "moser-veselov-8", "moser-veselov-10"]),
            ("released-top", &["kahan-li-8"]),
            ("sleeping-top", &["kahan-li-8"]),
            ("spin-1e-8", &["kahan-li-8"]),
            ("spin-1e8", &["kahan-li-8"]),
            ("spinning-coin", &["kahan-li-8"]),
            ("thin-body", &["kahan-li-8", "moser-veselov-10", "peskin-rk3"]),
            ("time-dependent-field", &["kahan-li-8"]),
        ],
    ),
    order(
        TWO_TERMS,
        &[
            ("heavy-asymmetric-top", &["rk4-matrix"]),
            ("lagrange-fast-top", &["rkmk4"]),
            ("mujoco-fast-spin", &["adams-bashforth-3"]),
            ("sleeping-top", &["adams-bashforth-3", "magnus-4", "rkmk4"]),
            (
                "thin-body",
                &[
                    "adams-bashforth-3",
                    "adams-bashforth-4",
                    "cf4",
                    "magnus-4",
                    "peskin-heun",
                    "peskin-ralston",
                    "rk4-quaternion",
                    "rkmk4",
                ],
            ),
        ],
    ),
    order(
        COLD_START,
        &[
            ("exact-separatrix", &["adams-bashforth-3-cold"]),
            ("lagrange-top-pivot-spring-undamped", &["adams-bashforth-3-cold"]),
            ("mujoco-fast-spin", &["adams-bashforth-3-cold", "adams-bashforth-4-cold"]),
            ("sciml-rigidbody-wpd", &["adams-bashforth-3-cold"]),
            ("sleeping-top", &["adams-bashforth-3-cold", "adams-bashforth-4-cold"]),
            ("spinning-coin", &["adams-bashforth-3-cold"]),
            ("thin-body", &["adams-bashforth-3-cold", "adams-bashforth-4-cold"]),
        ],
    ),
    Deviation {
        reason: FLIPS_CANCEL,
        claim: ClaimName::FlipTimes,
        quantities: &[],
        places: &[
            ("jsbsim-rotations", &["adams-bashforth-2", "buss-augmented"]),
            ("osrf-boxes-complex", &["adams-bashforth-2", "buss-augmented"]),
        ],
    },
    order(MANY_TURNS, &[("thin-body", &["strang-rotations", "no-squish"])]),
    order(
        SCATTERED,
        &[
            ("mujoco-fast-spin", &["adams-bashforth-2", "buss-augmented"]),
            ("thin-body", &["buss-augmented", "krysl-liemid", "peskin-rk2", "peskin-trapezoid"]),
        ],
    ),
];
