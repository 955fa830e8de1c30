//! Kahan and Li's composition of order 6: nine steps of strang-rotations.
//!
//! (1)  γ₁ … γ₅ as printed below, then mirrored:   Σ γ = 1,  Σ γ³ = Σ γ⁵ = 0, and a condition on commutators
//!
//! Source: kahan1997. Order 6, symplectic, symmetric. The digits are checked by these sums and by the order.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use crate::arithmetic::Real;

composition! {
    /// Kahan and Li's nine steps.
    KahanLi6 of StrangRotations by half, Card {
        name: "kahan-li-6",
        title: "Kahan and Li's nine steps of strang-rotations, order 6",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL; Order(6), Evaluations(9)],
    }
}

/// γ₁ … as printed; each is the f64 nearest to it and the rest.
#[expect(clippy::excessive_precision, reason = "the digits as printed")]
pub(super) fn half<T: Real>() -> [T; 5] {
    [
        T::constant(0.392_161_444_007_314_139_28, 1.98268441460107e-17),
        T::constant(0.332_599_136_789_359_438_60, 9.999068221580819e-18),
        T::constant(-0.706_246_172_557_639_359_81, -3.081729314915952e-17),
        T::constant(0.082_213_596_293_550_800_23, 5.549728434915305e-18),
        T::constant(0.798_543_990_934_829_963_40, -9.116695306694601e-18),
    ] // (1)
}
