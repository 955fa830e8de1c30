//! Orders in h of the rate at which a free body's energy changes.

use super::Deviation;
use crate::record::ClaimName;

const RATE: &[&str] = &["rotational-energy-rate"];

const NEVER_STEADY: &str = "a first-order rule gains energy so fast that its rate changes within a hundred radians, or within \
     sixteen polhode periods, at every step that the long runs can afford (four million steps)";

const VANISHES: &str = "the h³ part of the rate nearly vanishes for this body, and the h⁴ part shows";

const BELOW_ROUNDING: &str =
    "the rate, ∝ h⁵, is already no more than what rounding leaves where it becomes steady";

const ROUNDING_DRIFTS: &str = "a step takes L apart into moments and spins and puts it together again, and with moments of 26 : 1 its \
     rounding drifts: a rate ∝ 1/h covers the one ∝ h³ at every step where that is steady";

pub(super) const KNOWN: &[Deviation] = &[
    Deviation {
        reason: BELOW_ROUNDING,
        claim: ClaimName::Energy,
        quantities: RATE,
        places: &[("thin-body", &["magnus-4", "peskin-rk4", "rk4-matrix", "rk4-quaternion"])],
    },
    Deviation {
        reason: ROUNDING_DRIFTS,
        claim: ClaimName::Energy,
        quantities: RATE,
        places: &[("thin-body", &["generalized-alpha"])],
    },
    Deviation {
        reason: NEVER_STEADY,
        claim: ClaimName::Energy,
        quantities: RATE,
        places: &[
            ("dzhanibekov", &["euler"]),
            ("free-asymmetric", &["euler"]),
            ("jsbsim-rotations", &["euler"]),
            ("mujoco-fast-spin", &["euler"]),
            ("mujoco-middle-axis", &["euler"]),
            ("nasa-check-case-2", &["euler"]),
            ("osrf-boxes-complex", &["euler"]),
            ("thin-body", &["euler"]),
        ],
    },
    Deviation {
        reason: VANISHES,
        claim: ClaimName::Energy,
        quantities: RATE,
        places: &[("osrf-boxes-complex", &["peskin-ralston"])],
    },
];
