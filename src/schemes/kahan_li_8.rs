//! Kahan and Li's composition of order 8: seventeen steps of strang-rotations.
//!
//! (1)  γ₁ … γ₉ as printed below, then mirrored:   Σ γ = 1,  Σ γ³ = Σ γ⁵ = Σ γ⁷ = 0, and conditions on commutators
//!
//! Source: kahan1997. Order 8, symplectic, symmetric. The digits are checked by these sums and by the order.

use super::Card;
use super::composed::{Composed, Composition};
use super::strang_rotations::StrangRotations;
use crate::claim::{Claim, Quantity, When};

/// Kahan and Li's seventeen steps.
pub type KahanLi8 = Composed<SeventeenSteps>;

/// Its coefficients.
#[derive(Clone, Copy, Debug)]
pub struct SeventeenSteps;

impl Composition for SeventeenSteps {
    type Base = StrangRotations;
    type Half = [f64; 9];

    const CARD: Card = Card {
        name: "kahan-li-8",
        title: "Kahan and Li's seventeen steps of strang-rotations, order 8",
        family: "geometric",
        source: "kahan1997",
        claims: &[
            Claim::Order(8),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(17),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
        ],
    };

    #[expect(clippy::excessive_precision, reason = "the digits as printed")]
    fn half() -> [f64; 9] {
        [
            0.130_202_483_088_890_080_88,
            0.561_162_981_775_108_384_56,
            -0.389_474_962_644_847_286_41,
            0.158_841_906_555_155_600_90,
            -0.395_903_894_133_237_577_34,
            0.184_539_640_978_315_707_09,
            0.258_374_387_686_322_047_29,
            0.295_011_723_609_310_298_87,
            -0.605_508_533_830_034_511_70,
        ] // (1)
    }
}
