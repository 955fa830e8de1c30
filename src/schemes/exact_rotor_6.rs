//! Kahan and Li's composition of order 6: nine steps of exact-rotor.
//!
//! (1)  γ₁ … γ₅ of kahan-li-6, then mirrored
//!
//! The free body turns exactly in every sub-step, so that only the kicks leave an error.
//! Source: kahan1997. Order 6 under torque, exact without; symplectic, symmetric.

use super::Card;
use super::composed::composition;
use super::families::{CANONICAL, claims};
use super::kahan_li_6::half;

composition! {
    /// Kahan and Li's nine steps of exact-rotor.
    ExactRotor6 of ExactRotor by half, Card {
        name: "exact-rotor-6",
        title: "Kahan and Li's nine steps of exact-rotor, order 6",
        family: "geometric",
        source: "kahan1997",
        claims: claims![CANONICAL;
            Order(6), Exact(Orientation, NoTorque), Exact(AngularVelocity, NoTorque), Energy(Constant),
            Evaluations(9),
        ],
    }
}
