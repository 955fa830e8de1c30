//! Suzuki's fractal: five steps of strang-rotations, the middle one backwards.
//!
//! (1)  γ₁ = γ₂ = 1/(4 − ∛4),  γ₃ = −∛4/(4 − ∛4),  γ₄ = γ₅ = γ₁:   Σ γ = 1,  Σ γ³ = 0
//!
//! Source: suzuki1990. Order 4, symplectic, symmetric; smaller steps and errors than the triple jump's.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use crate::arithmetic::Real;

composition! {
    /// Suzuki's fractal.
    Suzuki4 of StrangRotations by half, Card {
        name: "suzuki-4",
        title: "Suzuki's five-step composition of strang-rotations",
        family: "geometric",
        source: "suzuki1990",
        claims: claims![CANONICAL; Order(4), Energy(Bounded), Evaluations(5)],
    }
}

pub(super) fn half<T: Real>() -> [T; 3] {
    let root = T::of(4.0).cbrt();
    let gamma = T::one() / (T::of(4.0) - root);
    [gamma, gamma, -root * gamma] // (1)
}
