//! Peskin's two-stage scheme: Euler to the midpoint, then the midpoint rule, with exact rotations.
//!
//! (1)–(4)  s½ = advance(s0, h/2, rates(t, s0))
//! (5)–(8)  s1 = advance(s0, h, rates(t + h/2, s½))       from s0 again, not from s½
//!
//! Source: peskin2021, steps (1)–(8). Second order; L constant without torque; the energy of a free body grows
//! at a rate ∝ h³, so that it drifts: this is the scheme's weak side.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, SideBySide, Step};
use crate::model::{Broken, Model, Shortcut};

/// Peskin's scheme.
#[derive(Clone, Copy, Debug)]
pub struct PeskinRk2;

impl Scheme for PeskinRk2 {
    fn card(&self) -> Card {
        Card {
            name: "peskin-rk2",
            title: "Peskin's two-stage scheme",
            family: "the note",
            source: "peskin2021",
            claims: claims![ROTATIONS;
                Order(2), Energy(GrowsSecularly { rate_order: 3 }), FlipTimes, Evaluations(2),
            ],
        }
    }
    const SIDE_BY_SIDE: Option<SideBySide> = Some(SideBySide::PeskinRk2);
    const SHORTCUT: Option<Shortcut> = Some(Shortcut::PeskinRk2);
    const STATES: usize = 1;

    #[inline(always)]
    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k0, half); // (1)–(4)
        let k1 = model.rates(t + h / 2.0, half)?;
        model.advance(from, h, &k1, to); // (5)–(8)
        Ok(())
    }
}
