//! Kahan and Li's composition of order 6: nine steps of strang-rotations.
//!
//! (1)  γ₁ … γ₅ as printed below, then mirrored:   Σ γ = 1,  Σ γ³ = Σ γ⁵ = 0, and a condition on commutators
//!
//! Source: kahan1997. Order 6, symplectic, symmetric. The digits are checked by these sums and by the order.

use super::Card;
use super::composed::{Composed, Composition};
use super::strang_rotations::StrangRotations;
use crate::claim::{Claim, Quantity, When};

/// Kahan and Li's nine steps.
pub type KahanLi6 = Composed<NineSteps>;

/// Its coefficients.
#[derive(Clone, Copy, Debug)]
pub struct NineSteps;

impl Composition for NineSteps {
    type Base = StrangRotations;
    type Half = [f64; 5];

    const CARD: Card = Card {
        name: "kahan-li-6",
        title: "Kahan and Li's nine steps of strang-rotations, order 6",
        family: "geometric",
        source: "kahan1997",
        claims: &[
            Claim::Order(6),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(9),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
        ],
    };

    #[expect(clippy::excessive_precision, reason = "the digits as printed")]
    fn half() -> [f64; 5] {
        [
            0.392_161_444_007_314_139_28,
            0.332_599_136_789_359_438_60,
            -0.706_246_172_557_639_359_81,
            0.082_213_596_293_550_800_23,
            0.798_543_990_934_829_963_40,
        ] // (1)
    }
}
