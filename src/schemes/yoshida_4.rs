//! Triple jump: three steps of strang-rotations, the middle one backwards.
//!
//! (1)  γ₁ = 1/(2 − ∛2),  γ₂ = −∛2/(2 − ∛2),  γ₃ = γ₁:   Σ γ = 1,  Σ γ³ = 0
//!
//! Source: yoshida1990; the triple jump, found by several authors at about that time. Order 4, symplectic, symmetric.

use super::Card;
use super::composed::{Composed, Composition};
use super::strang_rotations::StrangRotations;
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};

/// Triple jump.
pub type Yoshida4 = Composed<TripleJump>;

/// Its coefficients.
#[derive(Clone, Copy, Debug)]
pub struct TripleJump;

impl Composition for TripleJump {
    type Base = StrangRotations;
    type Half = [f64; 2];

    const CARD: Card = Card {
        name: "yoshida-4",
        title: "Triple jump of strang-rotations",
        family: "geometric",
        source: "yoshida1990",
        claims: &[
            Claim::Order(4),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(3),
            Claim::Energy(EnergyOfFreeBody::Bounded),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
        ],
    };

    fn half() -> [f64; 2] {
        let gamma = 1.0 / (2.0 - f64::cbrt(2.0));
        [gamma, -f64::cbrt(2.0) * gamma] // (1)
    }
}
