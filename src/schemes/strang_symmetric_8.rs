//! Kahan and Li's composition of order 8: seventeen steps of strang-symmetric.
//!
//! (1)  γ₁ … γ₉ of kahan-li-8, then mirrored
//!
//! A sub-step turns the body three times instead of the five times of strang-rotations.
//! Source: kahan1997. Order 8, symplectic, symmetric; exact for free spheres and symmetric bodies.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use super::kahan_li_8::half;

composition! {
    /// Kahan and Li's seventeen steps of strang-symmetric.
    StrangSymmetric8 of StrangSymmetric by half, Card {
        name: "strang-symmetric-8",
        title: "Kahan and Li's seventeen steps of strang-symmetric, order 8",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL;
            Order(8), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
            Evaluations(17),
        ],
    }
}
