//! The midpoint rule without rotations: what is left of the note's scheme where points are free vectors.
//!
//! (1)  X̃_k(t+h/2) = X̃_k(t) + h/2 Ω(t) × X̃_k(t)
//! (5)  X̃_k(t+h) = X̃_k(t) + h Ω(t+h/2) × X̃_k(t+h/2)       the arm of the midpoint too, or it were first order
//! (2)–(4), (6)–(8)  as in the note
//!
//! Source: peskin2021 with (1) and (5) linear. Second order; the body is not rigid: its size changes as h³.

use super::families::{BALLISTIC, claims};
use super::{Card, PointScheme, Step};
use crate::model::{Broken, Pointwise};

/// The midpoint rule on the points as free vectors.
#[derive(Clone, Copy, Debug)]
pub struct Rk2Linear;

impl PointScheme for Rk2Linear {
    fn card(&self) -> Card {
        Card {
            name: "rk2-linear",
            title: "Midpoint rule without rotations",
            family: "the note, varied",
            source: "peskin2021",
            claims: claims![BALLISTIC; Order(2), Energy(Secular { rate_order: 3 }), Evaluations(2)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Pointwise>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance_straight(from, h / 2.0, &k0, from, half); // (1)–(4)
        let k1 = model.rates(t + h / 2.0, half)?;
        model.advance_straight(from, h, &k1, half, to); // (5)–(8)
        Ok(())
    }
}
