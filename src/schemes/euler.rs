//! The Euler-only baseline: the first stage of Peskin's scheme taken over the whole step.
//!
//! (1)–(4)  s1 = advance(s0, h, rates(t, s0))
//!
//! Source: peskin2021, steps (1)–(4). First order, with the exact rotation; L constant without torque.

use super::families::{EULERS, claims};
use super::{Card, Scheme, SideBySide, Step};
use crate::model::{Broken, Model};

/// Euler's method with an exact rotation.
#[derive(Clone, Copy, Debug)]
pub struct Euler;

impl Scheme for Euler {
    fn card(&self) -> Card {
        Card {
            name: "euler",
            title: "Euler-only baseline with exact rotation",
            family: "the note",
            source: "peskin2021",
            claims: claims![EULERS; Energy(GrowsSecularly { rate_order: 1 }), Evaluations(1)],
        }
    }
    const SIDE_BY_SIDE: Option<SideBySide> = Some(SideBySide::Euler);
    const STATES: usize = 0;

    #[inline(always)]
    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        model.advance(from, h, &k0, to); // (1)–(4)
        Ok(())
    }
}
