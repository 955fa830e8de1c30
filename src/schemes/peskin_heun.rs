//! Heun's corrector with exact rotations: the mean of the rates at both ends of an Euler step.
//!
//! (1)  s* = advance(s0, h, k0),  k0 = rates(t, s0)
//! (2)  s1 = advance(s0, h, ½ (k0 + k1)),  k1 = rates(t + h, s*)
//!
//! Source: peskin2021, whose ingredients take the place of sums in heun1900. Second order like the note's scheme
//! at the same cost, with error constants of its own.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::model::{Broken, Model};

/// Heun's corrector.
#[derive(Clone, Copy, Debug)]
pub struct PeskinHeun;

impl Scheme for PeskinHeun {
    fn card(&self) -> Card {
        Card {
            name: "peskin-heun",
            title: "Heun's corrector with exact rotations",
            family: "the note, varied",
            source: "heun1900; peskin2021",
            claims: claims![ROTATIONS; Order(2), Energy(Secular { rate_order: 3 }), Evaluations(2)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [predicted] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h, &k0, predicted); // (1)
        let k1 = model.rates(t + h, predicted)?;
        model.advance(from, h, &((k0 + k1) * (1.0 / 2.0)), to); // (2)
        Ok(())
    }
}
