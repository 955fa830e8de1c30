//! Strang splitting into rotations about the principal axes: kick, five turns, kick.
//!
//! (1)  Q = X(½) Y(½) Z(1) Y(½) X(½),  each a turn of the body about its own axis k through  s h l_k/I_k
//! (2)  l ← Qᵀ l after each turn: the turn about k leaves l_k
//!
//! ½ Σ l_k²/I_k is taken one term at a time; each alone turns the body evenly about a principal axis.
//!
//! Source: dullweber1997, after touma1994. Order 2, symplectic, symmetric; one force evaluation a step.

use nalgebra::Vector3;

use super::Card;
use super::families::{KICKS, claims};
use super::splitting::splitting;
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational};
use crate::rotation::{self, Rotation};

splitting! {
    /// Three axis rotations and a kick.
    StrangRotations, free_turn, Card {
        name: "strang-rotations",
        title: "Strang splitting into rotations about principal axes",
        family: "geometric",
        source: "dullweber1997",
        claims: claims![KICKS; Energy(Bounded), FlipTimes],
    }
}

/// (1) and (2).
pub(super) fn free_turn<T: Real>(
    rotational: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    let (mut q, mut l) = (rotation::identity(), *momentum);
    for (axis, part) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
        let angle = h * part * l[axis] * rotational.inverse_moments[axis];
        let turn = rotation::turn(&rotation::along(axis, angle));
        q *= turn; // (1)
        l = rotation::turned_back(&turn, &l); // (2)
    }
    Ok(q)
}
