//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that nobody noticed, and fails.

use crate::record::{Ruling, Verdict};

/// A verdict that is known not to hold.
struct Deviation {
    scene: &'static str,
    schemes: &'static [&'static str],
    claim: &'static str,
    /// Every quantity that does not hold, where none is named; then one of them at least must not.
    quantities: &'static [&'static str],
    reason: &'static str,
}

impl Deviation {
    fn speaks_of(&self, verdict: &Verdict) -> bool {
        self.scene == verdict.scene
            && self.schemes.contains(&verdict.scheme.as_str())
            && self.claim == verdict.claim
            && (self.quantities.is_empty() || self.quantities.contains(&verdict.quantity.as_str()))
    }
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

const TWO_TERMS: &str = "over so many turns two terms of the error, the leading one and the next, stay of one size down to the \
     steps where rounding takes over: the slope lies between their orders or has not settled";

const HIGH_ORDER: &str = "between the steps where a scheme of this order begins to converge and those where rounding takes over \
     there are fewer rungs than a window needs";

const COLD_START: &str = "the order of 2 comes from the first steps alone, whose history is made up; over so many turns the formula's own \
     error of order 3 or 4 covers that of the start at every step above rounding";

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
        scene: "thin-body",
        schemes: &["rk4-quaternion"],
        claim: "order",
        quantities: &["angular-velocity-end"],
        reason: NEAR_ROUNDING,
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["adams-bashforth-3-cold", "adams-bashforth-4-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "sleeping-top",
        schemes: &["adams-bashforth-3-cold", "adams-bashforth-4-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "thin-body",
        schemes: &["adams-bashforth-3-cold", "adams-bashforth-4-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "lagrange-top-pivot-spring-undamped",
        schemes: &["adams-bashforth-3-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "exact-separatrix",
        schemes: &["adams-bashforth-3-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "sciml-rigidbody-wpd",
        schemes: &["adams-bashforth-3-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "spinning-coin",
        schemes: &["adams-bashforth-3-cold"],
        claim: "order",
        quantities: &[],
        reason: COLD_START,
    },
    Deviation {
        scene: "thin-body",
        schemes: &[
            "adams-bashforth-3",
            "adams-bashforth-4",
            "cf4",
            "crouch-grossman-3",
            "kahan-li-8",
            "magnus-4",
            "moser-veselov-10",
            "peskin-heun",
            "peskin-ralston",
            "peskin-rk3",
            "rkmk4",
        ],
        claim: "order",
        quantities: &[],
        reason: TWO_TERMS,
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["adams-bashforth-3", "kahan-li-8", "moser-veselov-10"],
        claim: "order",
        quantities: &[],
        reason: TWO_TERMS,
    },
    Deviation {
        scene: "sleeping-top",
        schemes: &["adams-bashforth-3", "kahan-li-8", "magnus-4", "rkmk4"],
        claim: "order",
        quantities: &[],
        reason: TWO_TERMS,
    },
    Deviation {
        scene: "lagrange-fast-top",
        schemes: &["kahan-li-8", "rkmk4"],
        claim: "order",
        quantities: &[],
        reason: TWO_TERMS,
    },
    Deviation {
        scene: "nasa-check-case-2",
        schemes: &["kahan-li-8", "moser-veselov-8", "moser-veselov-10"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "free-asymmetric",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "exact-separatrix",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "free-oblate",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "gravity-gradient",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "spinning-coin",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "time-dependent-field",
        schemes: &["kahan-li-8"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "gravity-drag",
        schemes: &["gauss-legendre-6"],
        claim: "order",
        quantities: &[],
        reason: HIGH_ORDER,
    },
    Deviation {
        scene: "heavy-asymmetric-top",
        schemes: &["rk4-matrix"],
        claim: "order",
        quantities: &[],
        reason: NEAR_ROUNDING,
    },
    Deviation {
        scene: "euler-top-unit",
        schemes: &["crouch-grossman-3"],
        claim: "order",
        quantities: &[],
        reason: TWO_TERMS,
    },
    Deviation {
        scene: "thin-body",
        schemes: &["strang-rotations", "no-squish"],
        claim: "order",
        quantities: &[],
        reason: "the splitting takes the body apart into turns about its axes, and about the axis of the thin body's small \
                 moment each turns it many times in a step: no step of the ladder is asymptotic",
    },
    Deviation {
        scene: "thin-body",
        schemes: &["euler-linear", "momentum-clamped-euler", "semi-implicit-euler-explicit-gyro"],
        claim: "order",
        quantities: &[],
        reason: SATURATED,
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["euler-linear", "momentum-clamped-euler", "semi-implicit-euler-explicit-gyro"],
        claim: "order",
        quantities: &[],
        reason: SATURATED,
    },
    Deviation {
        scene: "sleeping-top",
        schemes: &["euler-linear"],
        claim: "order",
        quantities: &[],
        reason: SATURATED,
    },
    Deviation {
        scene: "nasa-check-case-2",
        schemes: &["course-code-euler", "euler-linear", "rk2-linear", "substepped-4-euler"],
        claim: "exact",
        quantities: &[],
        reason: "L is exact but for rounding, and the torques of the weight, which cancel in their sum to rounding, are added \
                 to it in every step: in a million steps they pass the bound",
    },
    Deviation {
        scene: "slow-sphere",
        schemes: &["bdf", "tr-bdf2"],
        claim: "follows-tolerance",
        quantities: &[],
        reason: "the body turns by so little that a few steps of the solver's first guess are the whole run at every tolerance",
    },
    Deviation {
        scene: "mujoco-fast-spin",
        schemes: &["bdf"],
        claim: "run",
        quantities: &[],
        reason: "at the loosest tolerance the solver does not get through 2000 radians: its error test fails too often in a step",
    },
    Deviation {
        scene: "bouncing-body",
        schemes: &["gauss-legendre-4", "gauss-legendre-6"],
        claim: "solves",
        quantities: &[],
        reason: "the fixed-point iteration of the stages does not converge on the stiff ground at the steps of the ladder",
    },
    Deviation {
        scene: "osrf-boxes-complex",
        schemes: &["peskin-ralston"],
        claim: "energy",
        quantities: &[],
        reason: "the h³ part of the rate nearly vanishes for this body, and the h⁴ part shows",
    },
];

pub(super) fn apply(verdicts: &mut [Verdict]) {
    for known in KNOWN {
        let holds = |verdict: &Verdict| verdict.verdict == Ruling::Pass;
        let spoken: Vec<&mut Verdict> = verdicts.iter_mut().filter(|v| known.speaks_of(v)).collect();
        let all_hold = !spoken.is_empty() && spoken.iter().all(|verdict| holds(verdict));
        for verdict in spoken {
            if !holds(verdict) {
                if verdict.verdict != Ruling::NotApplicable {
                    verdict.known_deviation = Some(known.reason.to_owned());
                }
            } else if all_hold || !known.quantities.is_empty() {
                verdict.verdict = Ruling::Fail;
                verdict.detail = format!(
                    "listed as a known deviation ({}), yet it holds: {}",
                    known.reason, verdict.detail
                );
            }
        }
    }
}
