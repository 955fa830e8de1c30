//! The note's ingredients at fourth order: exact rotations composed without commutators.
//!
//! (1)  s2 = advance(s0, h/2, k1),  k1 = rates(t, s0)
//! (2)  s3 = advance(s0, h/2, k2),  k2 = rates(t + h/2, s2)
//! (3)  s4 = advance(s2, h, k3 − ½ k1),  k3 = rates(t + h/2, s3)
//! (4)  s½ = advance(s0, h, ¼ k1 + ⅙ k2 + ⅙ k3 − 1/12 k4),  k4 = rates(t + h, s4)
//! (5)  s1 = advance(s½, h, −1/12 k1 + ⅙ k2 + ⅙ k3 + ¼ k4)
//!
//! The two weights of (4) and (5) add up to the classical (⅙, ⅓, ⅓, ⅙); the rates near the start of the step turn
//! the body first.
//!
//! Source: celledoni2003, the fourth-order method; peskin2021.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Rates};

/// Fourth order, four evaluations and five rotations a step.
#[derive(Clone, Copy, Debug)]
pub struct PeskinRk4;

impl Scheme for PeskinRk4 {
    fn card(&self) -> Card {
        Card {
            name: "peskin-rk4",
            title: "The note's ingredients at fourth order",
            family: "the note, varied",
            source: "celledoni2003; peskin2021",
            claims: claims![ROTATIONS; Order(4), Energy(Secular { rate_order: 5 }), Evaluations(4)],
        }
    }
    const STATES: usize = 2;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [early, stage] = work.buffers();
        let k1 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k1, early); // (1)
        let k2 = model.rates(t + h / 2.0, early)?;
        model.advance(from, h / 2.0, &k2, stage); // (2)
        let k3 = model.rates(t + h / 2.0, stage)?;
        model.advance(early, h, &(k3 + k1 * (-1.0 / 2.0)), stage); // (3)
        let k4 = model.rates(t + h, stage)?;
        let [sixth, twelfth] = [6.0, 12.0].map(|parts| M::Real::ratio(1.0, parts));
        let middle = (k2 + k3).scaled(sixth);
        model.advance(from, h, &(k1 * (1.0 / 4.0) + middle + k4.scaled(-twelfth)), early); // (4)
        model.advance(early, h, &(k1.scaled(-twelfth) + middle + k4 * (1.0 / 4.0)), to); // (5)
        Ok(())
    }
}
