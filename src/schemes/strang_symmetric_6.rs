//! Kahan and Li's composition of order 6: nine steps of strang-symmetric.
//!
//! (1)  γ₁ … γ₅ of kahan-li-6, then mirrored
//!
//! A sub-step turns the body three times instead of the five times of strang-rotations.
//! Source: kahan1997. Order 6, symplectic, symmetric; exact for free spheres and symmetric bodies.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use super::kahan_li_6::half;

composition! {
    /// Kahan and Li's nine steps of strang-symmetric.
    StrangSymmetric6 of StrangSymmetric by half, Card {
        name: "strang-symmetric-6",
        title: "Kahan and Li's nine steps of strang-symmetric, order 6",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL;
            Order(6), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
            Evaluations(9),
        ],
    }
}
