//! Triple jump: three steps of strang-rotations, the middle one backwards.
//!
//! (1)  γ₁ = 1/(2 − ∛2),  γ₂ = −∛2/(2 − ∛2),  γ₃ = γ₁:   Σ γ = 1,  Σ γ³ = 0
//!
//! Source: yoshida1990; the triple jump, found by several authors at about that time. Order 4, symplectic, symmetric.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use crate::arithmetic::Real;

composition! {
    /// Triple jump.
    Yoshida4 of StrangRotations by half, Card {
        name: "yoshida-4",
        title: "Triple jump of strang-rotations",
        family: "geometric",
        source: "yoshida1990",
        claims: claims![CANONICAL; Order(4), Energy(Bounded), Evaluations(3)],
    }
}

pub(super) fn half<T: Real>() -> [T; 2] {
    let root = T::of(2.0).cbrt();
    let gamma = T::one() / (T::of(2.0) - root);
    [gamma, -root * gamma] // (1)
}
