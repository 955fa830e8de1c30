//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that nobody noticed, and fails.

use crate::record::{Ruling, Verdict};

/// A verdict that is known not to hold.
struct Deviation {
    scene: &'static str,
    schemes: &'static [&'static str],
    claim: &'static str,
    quantities: &'static [&'static str],
    reason: &'static str,
}

/// What an order of the rotation is read from.
const ROTATION: &[&str] = &[
    "orientation-end",
    "orientation-max",
    "angular-velocity-end",
    "angular-velocity-max",
    "body-point-end",
    "body-point-max",
];

/// The same, and L, for rules that do not keep it.
const ROTATION_AND_MOMENTUM: &[&str] = &[
    "orientation-end",
    "orientation-max",
    "angular-velocity-end",
    "angular-velocity-max",
    "angular-momentum-end",
    "body-point-end",
    "body-point-max",
];

const WITHOUT_SPIN: &[&str] = &["orientation-end", "orientation-max", "body-point-end", "body-point-max"];

const NEAR_ROUNDING: &str = "a fourth-order scheme has few steps between its asymptotic range and rounding: the slope of this \
     quantity is inside the band but its interval ends up to 0.05 outside; the other quantities of the scene hold";

/// First-order rules whose error saturates over many turns.
const FIRST_ORDER: &[&str] = &["euler", "course-notes-euler", "course-code-euler", "substepped-4-euler"];

const ENERGY_RATE: &[&str] = &["rotational-energy-rate"];

const SATURATED: &str = "over so many turns the error of a first-order rule is as large as the motion itself at every step that \
     the ladder can afford (a million steps): no order can be read";

const NEVER_STEADY: &str = "a first-order rule gains energy so fast that its rate changes within a hundred radians, or within \
     sixteen polhode periods, at every step that the long runs can afford (four million steps)";

const KNOWN: &[Deviation] = &[
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: FIRST_ORDER,
        claim: "order",
        quantities: ROTATION,
        reason: SATURATED,
    },
    Deviation {
        scene: "thin-body",
        schemes: FIRST_ORDER,
        claim: "order",
        quantities: ROTATION,
        reason: SATURATED,
    },
    Deviation {
        scene: "free-asymmetric",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "dzhanibekov",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "mujoco-middle-axis",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "jsbsim-rotations",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "osrf-boxes-complex",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "thin-body",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "nasa-check-case-2",
        schemes: &["euler"],
        claim: "energy",
        quantities: ENERGY_RATE,
        reason: NEVER_STEADY,
    },
    Deviation {
        scene: "dzhanibekov",
        schemes: &["exact-rotor"],
        claim: "exact",
        quantities: &["orientation-end", "angular-velocity-end"],
        reason: "each step multiplies five rotations of many radians, and passing near the separatrix amplifies their \
                 rounding to 1.2 times the bound",
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["semi-implicit-euler-implicit-gyro"],
        claim: "order",
        quantities: ROTATION_AND_MOMENTUM,
        reason: SATURATED,
    },
    Deviation {
        scene: "thin-body",
        schemes: &["semi-implicit-euler-implicit-gyro"],
        claim: "order",
        quantities: WITHOUT_SPIN,
        reason: SATURATED,
    },
    Deviation {
        scene: "exact-separatrix",
        schemes: &["rk4-quaternion"],
        claim: "order",
        quantities: &["angular-velocity-end"],
        reason: NEAR_ROUNDING,
    },
    Deviation {
        scene: "time-dependent-field",
        schemes: &["rk4-quaternion"],
        claim: "order",
        quantities: &["angular-velocity-end", "angular-momentum-end"],
        reason: NEAR_ROUNDING,
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["rk4-quaternion"],
        claim: "order",
        quantities: &["angular-velocity-end"],
        reason: NEAR_ROUNDING,
    },
    Deviation {
        scene: "thin-body",
        schemes: &["rk4-quaternion"],
        claim: "order",
        quantities: &["angular-velocity-end"],
        reason: NEAR_ROUNDING,
    },
];

pub(super) fn apply(verdicts: &mut [Verdict]) {
    for verdict in verdicts {
        let known = KNOWN.iter().find(|known| {
            known.scene == verdict.scene
                && known.schemes.contains(&verdict.scheme.as_str())
                && known.claim == verdict.claim
                && known.quantities.contains(&verdict.quantity.as_str())
        });
        let Some(known) = known else { continue };
        match verdict.verdict {
            Ruling::Fail | Ruling::Inconclusive => verdict.known_deviation = Some(known.reason.to_owned()),
            Ruling::Pass => {
                verdict.verdict = Ruling::Fail;
                verdict.detail = format!(
                    "listed as a known deviation ({}), yet it holds: {}",
                    known.reason, verdict.detail
                );
            }
            Ruling::NotApplicable | Ruling::Broken => {}
        }
    }
}
