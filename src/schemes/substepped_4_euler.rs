//! The Euler-only baseline in four parts a step.
//!
//! (1)  s(i+1) = advance(s(i), h/4, rates(t + i h/4, s(i))),  i = 0 … 3
//!
//! Source: peskin2021, steps (1)–(4). First order with a quarter of Euler's error at four times its cost: what
//! substeps buy without a better scheme.

use super::families::{EULERS, claims};
use super::substepped::substepped;
use super::{Card, Euler, Scheme, Step};
use crate::model::{Broken, Model};

/// Euler's method in four parts.
#[derive(Clone, Copy, Debug)]
pub struct Substepped4Euler;

impl Scheme for Substepped4Euler {
    fn card(&self) -> Card {
        Card {
            name: "substepped-4-euler",
            title: "Euler-only baseline in four parts a step",
            family: "substepped",
            source: "peskin2021",
            claims: claims![EULERS; Evaluations(4)],
        }
    }
    const STATES: usize = Euler::STATES + 1;

    fn step<M: Model>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        substepped(&Euler, 4, model, step) // (1)
    }
}
