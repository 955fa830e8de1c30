//! Kahan and Li's composition of order 8: seventeen steps of exact-rotor.
//!
//! (1)  γ₁ … γ₉ of kahan-li-8, then mirrored
//!
//! The free body turns exactly in every sub-step, so that only the kicks leave an error.
//! Source: kahan1997. Order 8 under torque, exact without; symplectic, symmetric.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use super::kahan_li_8::half;

composition! {
    /// Kahan and Li's seventeen steps of exact-rotor.
    ExactRotor8 of ExactRotor by half, Card {
        name: "exact-rotor-8",
        title: "Kahan and Li's seventeen steps of exact-rotor, order 8",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL;
            Order(8), Exact(Orientation, NoTorque), Exact(AngularVelocity, NoTorque), Energy(Constant),
            Evaluations(17),
        ],
    }
}
