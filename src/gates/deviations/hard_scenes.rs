//! Scenes that are there because they are hard on numbers: moments ten powers of ten apart, and a start next to the separatrix.

use super::Deviation;

const SHAFT: &str = "disc-on-long-shaft";
const SEPARATRIX: &str = "near-separatrix";

/// What the shaft does to everything that is judged to rounding.
const MOMENTS_APART: &str = "the moments about the pivot are 1e10 apart, so that a rounding of L is a millionth of the spin about \
     the shaft, and every step amplifies the last one's";

const UNSOLVED: &str = "with moments 1e10 apart the equation of a step, solved by repetition or by Newton's method from the last \
     spin, has no solution that these find at the steps of the ladder";

const CARRIED_OVER: &str = "the energy that the scheme gains or loses carries the motion over the separatrix, which is next to the \
     start, at every step of the runs: it flips once more";

const SLOW_RATE: &str = "next to the separatrix a period of the polhode is long and the rate small: it does not become steady, or is \
     lost in the oscillation or in rounding, at the steps that the long runs can afford (four million)";

const AMPLIFIED: &str =
    "passing next to the separatrix amplifies roundings, of which a step makes more than the floor counts";

const STIFF: &str =
    "the fixed-point iteration does not converge on the stiff spring at the steps of the ladder";

const fn known(
    claim: &'static str,
    reason: &'static str,
    places: &'static [(&'static str, &'static [&'static str])],
) -> Deviation {
    Deviation { reason, claim, quantities: &[], places }
}

pub(super) const KNOWN: &[Deviation] = &[
    known(
        "reduction",
        MOMENTS_APART,
        &[(
            SHAFT,
            &[
                "peskin-rk2",
                "euler",
                "peskin-heun",
                "peskin-ralston",
                "peskin-trapezoid",
                "peskin-cayley",
                "peskin-rk3",
                "peskin-rk4",
                "course-notes-euler",
                "substepped-4-euler",
                "crouch-grossman-3",
                "rkmk4",
                "magnus-4",
            ],
        )],
    ),
    known("rigid", MOMENTS_APART, &[(SHAFT, &["peskin-rk2", "peskin-heun", "peskin-trapezoid", "magnus-4"])]),
    known(
        "reversible",
        MOMENTS_APART,
        &[(SHAFT, &["strang-rotations", "no-squish", "yoshida-4", "suzuki-4", "kahan-li-6", "kahan-li-8"])],
    ),
    known(
        "symplectic",
        MOMENTS_APART,
        &[(
            SHAFT,
            &[
                "strang-rotations",
                "strang-symmetric",
                "exact-rotor",
                "no-squish",
                "moser-veselov",
                "yoshida-4",
                "suzuki-4",
                "kahan-li-6",
                "kahan-li-8",
            ],
        )],
    ),
    known(
        "equivariant",
        MOMENTS_APART,
        &[(SHAFT, &["moser-veselov-4", "moser-veselov-6", "moser-veselov-10"])],
    ),
    known("evaluations", UNSOLVED, &[(SHAFT, &["rattle", "omelyan-leapfrog", "krysl-liemid-ea"])]),
    known(
        "solves",
        UNSOLVED,
        &[(
            SHAFT,
            &[
                "omelyan-leapfrog",
                "krysl-liemid",
                "krysl-liemid-ea",
                "simo-wong",
                "generalized-alpha",
                "gauss-legendre-4",
                "gauss-legendre-6",
            ],
        )],
    ),
    known(
        "flip-times",
        CARRIED_OVER,
        &[(
            SEPARATRIX,
            &[
                "peskin-rk2",
                "peskin-trapezoid",
                "peskin-rk3",
                "crouch-grossman-3",
                "buss-augmented",
                "adams-bashforth-2",
                "adams-bashforth-3",
                "adams-bashforth-3-cold",
            ],
        )],
    ),
    known(
        "energy",
        SLOW_RATE,
        &[(
            SEPARATRIX,
            &[
                "peskin-rk2",
                "euler",
                "peskin-heun",
                "peskin-ralston",
                "peskin-trapezoid",
                "peskin-cayley",
                "peskin-rk3",
                "peskin-rk4",
                "crouch-grossman-3",
                "rkmk4",
                "magnus-4",
                "rk4-quaternion",
                "rk4-matrix",
                "buss-augmented",
                "generalized-alpha",
                "cf4",
                "adams-bashforth-2",
                "adams-bashforth-3",
                "adams-bashforth-4",
                "adams-bashforth-3-cold",
                "adams-bashforth-4-cold",
                "rk2-linear",
            ],
        )],
    ),
    known("exact", AMPLIFIED, &[(SEPARATRIX, &["exact-rotor"])]),
    known(
        "equivariant",
        AMPLIFIED,
        &[(
            SEPARATRIX,
            &[
                "moser-veselov-4",
                "moser-veselov-10",
                "yoshida-4",
                "suzuki-4",
                "kahan-li-8",
                "gauss-legendre-4",
            ],
        )],
    ),
    known("solves", STIFF, &[("one-stiff-spring", &["gauss-legendre-4", "gauss-legendre-6"])]),
    known("reversible", STIFF, &[("one-stiff-spring", &["krysl-liemid", "simo-wong"])]),
];
