//! Ralston's choice of the second stage, with exact rotations: two thirds of the step.
//!
//! (1)  s⅔ = advance(s0, ⅔ h, k0),  k0 = rates(t, s0)
//! (2)  s1 = advance(s0, h, ¼ k0 + ¾ k1),  k1 = rates(t + ⅔ h, s⅔)
//!
//! Source: ralston1962, whose weights have the least bound on the error of a vector equation; with the
//! ingredients of peskin2021 in place of sums. What is least for vectors need not be least for rotations.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model};

/// Ralston's second-order weights.
#[derive(Clone, Copy, Debug)]
pub struct PeskinRalston;

impl Scheme for PeskinRalston {
    fn card(&self) -> Card {
        Card {
            name: "peskin-ralston",
            title: "Ralston's second-order weights with exact rotations",
            family: "the note, varied",
            source: "ralston1962; peskin2021",
            claims: claims![ROTATIONS; Order(2), Energy(Secular { rate_order: 3 }), Evaluations(2)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [later] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h * M::Real::ratio(2.0, 3.0), &k0, later); // (1)
        let k1 = model.rates(t + h * M::Real::ratio(2.0, 3.0), later)?;
        model.advance(from, h, &(k0 * (1.0 / 4.0) + k1 * (3.0 / 4.0)), to); // (2)
        Ok(())
    }
}
