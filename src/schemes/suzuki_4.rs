//! Suzuki's fractal: five steps of strang-rotations, the middle one backwards.
//!
//! (1)  γ₁ = γ₂ = 1/(4 − ∛4),  γ₃ = −∛4/(4 − ∛4),  γ₄ = γ₅ = γ₁:   Σ γ = 1,  Σ γ³ = 0
//!
//! Source: suzuki1990. Order 4, symplectic, symmetric; smaller steps and errors than the triple jump's.

use super::Card;
use super::composed::{Composed, Composition};
use super::strang_rotations::StrangRotations;
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};

/// Suzuki's fractal.
pub type Suzuki4 = Composed<Fractal>;

/// Its coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Fractal;

impl Composition for Fractal {
    type Base = StrangRotations;
    type Half = [f64; 3];

    const CARD: Card = Card {
        name: "suzuki-4",
        title: "Suzuki's five-step composition of strang-rotations",
        family: "geometric",
        source: "suzuki1990",
        claims: &[
            Claim::Order(4),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(5),
            Claim::Energy(EnergyOfFreeBody::Bounded),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
        ],
    };

    fn half() -> [f64; 3] {
        let gamma = 1.0 / (4.0 - f64::cbrt(4.0));
        [gamma, gamma, -f64::cbrt(4.0) * gamma] // (1)
    }
}
