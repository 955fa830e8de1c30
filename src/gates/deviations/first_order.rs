//! Orders of first-order rules over many turns.

use super::{Deviation, ROTATION, WITHOUT_SPIN};
use crate::record::ClaimName;

/// Those whose every error is of first order.
const EULER: &[&str] = &["euler", "course-notes-euler", "course-code-euler", "substepped-4-euler"];

const SATURATED: &str = "over so many turns the error of a first-order rule is as large as the motion itself down to the last \
     steps that the ladder can afford (a million a run): no order can be read";

const HIDDEN: &str = "over so many turns the part ∝ h² of the error is the larger one, or cancels that ∝ h, down to the \
     last steps that the ladder can afford (a million a run): the slope has not come down to 1";

const BLOWN_UP: &str = "the energy of the explicit gyroscopic term grows without bound at the larger steps: of the ladder only the \
     three smallest come to the end of the run";

pub(super) const KNOWN: &[Deviation] = &[
    Deviation {
        reason: SATURATED,
        claim: ClaimName::Order,
        quantities: ROTATION,
        places: &[("mujoco-fast-spin", EULER), ("thin-body", EULER)],
    },
    Deviation {
        reason: SATURATED,
        claim: ClaimName::Order,
        quantities: &[],
        places: &[
            ("thin-body", &["euler-linear"]),
            ("mujoco-fast-spin", &["euler-linear"]),
            ("sleeping-top", &["euler-linear"]),
        ],
    },
    Deviation {
        reason: HIDDEN,
        claim: ClaimName::Order,
        quantities: WITHOUT_SPIN,
        places: &[(
            "thin-body",
            &[
                "semi-implicit-euler-implicit-gyro",
                "semi-implicit-euler-explicit-gyro",
                "momentum-clamped-euler",
            ],
        )],
    },
    Deviation {
        reason: HIDDEN,
        claim: ClaimName::Order,
        quantities: &[],
        places: &[("mujoco-fast-spin", &["semi-implicit-euler-implicit-gyro", "momentum-clamped-euler"])],
    },
    Deviation {
        reason: BLOWN_UP,
        claim: ClaimName::Order,
        quantities: &[],
        places: &[("mujoco-fast-spin", &["semi-implicit-euler-explicit-gyro"])],
    },
];
