//! Euler's method without rotations: every mass point goes straight along its velocity, and the body is not rigid.
//!
//! (1)  X̃_k(t+h) = X̃_k(t) + h Ω(t) × X̃_k(t)
//! (2)–(4)  X_cm, U_cm and L as in the note's first stage, taken over h
//!
//! Source: peskin2021 with (1) linear. First order; the body swells by |Ω|² h/2 of its size a second.

use super::families::{MOMENTA, claims};
use super::{Card, PointScheme, Step};
use crate::model::{Broken, Pointwise};

/// Euler's method on the points as free vectors.
#[derive(Clone, Copy, Debug)]
pub struct EulerLinear;

impl PointScheme for EulerLinear {
    fn card(&self) -> Card {
        Card {
            name: "euler-linear",
            title: "Euler's method without rotations",
            family: "the note, varied",
            source: "peskin2021",
            claims: claims![MOMENTA; Order(1), Exact(Position, NoForce), Evaluations(1)],
        }
    }
    const STATES: usize = 0;

    fn step<M: Pointwise>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        model.advance_straight(from, h, &k0, from, to); // (1)–(4)
        Ok(())
    }
}
