//! Kahan and Li's composition of order 8: seventeen steps of strang-rotations.
//!
//! (1)  γ₁ … γ₉ as printed below, then mirrored:   Σ γ = 1,  Σ γ³ = Σ γ⁵ = Σ γ⁷ = 0, and conditions on commutators
//!
//! Source: kahan1997. Order 8, symplectic, symmetric. The digits are checked by these sums and by the order.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use crate::arithmetic::Real;

composition! {
    /// Kahan and Li's seventeen steps.
    KahanLi8 of StrangRotations by half, Card {
        name: "kahan-li-8",
        title: "Kahan and Li's seventeen steps of strang-rotations, order 8",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL; Order(8), Evaluations(17)],
    }
}

/// γ₁ … as printed; each is the f64 nearest to it and the rest.
#[expect(clippy::excessive_precision, reason = "the digits as printed")]
pub(super) fn half<T: Real>() -> [T; 9] {
    [
        T::constant(0.130_202_483_088_890_080_88, 1.1162108848587086e-17),
        T::constant(0.561_162_981_775_108_384_56, 1.3030629711955552e-17),
        T::constant(-0.389_474_962_644_847_286_41, -1.9608337955400347e-17),
        T::constant(0.158_841_906_555_155_600_90, 7.805147593533912e-18),
        T::constant(-0.395_903_894_133_237_577_34, -1.1273558895660098e-17),
        T::constant(0.184_539_640_978_315_707_09, -3.916274568717344e-18),
        T::constant(0.258_374_387_686_322_047_29, 9.396339691672474e-18),
        T::constant(0.295_011_723_609_310_298_87, 2.648293707662844e-17),
        T::constant(-0.605_508_533_830_034_511_70, 4.4864319457316306e-17), // 1 − 2 Σ: the printed digits leave a sum of 1 − 2e-20
    ] // (1)
}
