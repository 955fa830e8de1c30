//! Implicit equations and solvers that choose their own steps.

use super::Deviation;
use crate::record::ClaimName;

pub(super) const KNOWN: &[Deviation] = &[
    Deviation {
        reason: "the body turns by so little that a few steps of the solver's first guess are the whole run at every tolerance",
        claim: ClaimName::FollowsTolerance,
        quantities: &[],
        places: &[("slow-sphere", &["bdf", "esdirk34", "tr-bdf2"])],
    },
    Deviation {
        reason: "whole steps between the stored times, few as they are, jump in number, and so do the errors at the end",
        claim: ClaimName::FollowsTolerance,
        quantities: &[],
        places: &[("free-asymmetric", &["dop853"])],
    },
    Deviation {
        reason: "at the loosest tolerance the solver does not get through 2000 radians: its error test fails too often in a step",
        claim: ClaimName::Run,
        quantities: &[],
        places: &[("mujoco-fast-spin", &["bdf"])],
    },
    Deviation {
        reason: "the way back ends at rest, where an iteration that ends by a relative change of L no longer ends: the last \
                 step is not made",
        claim: ClaimName::Reversible,
        quantities: &[],
        places: &[("released-top", &["implicit-midpoint"])],
    },
];
