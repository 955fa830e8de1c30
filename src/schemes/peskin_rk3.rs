//! The note's ingredients at third order: exact rotations composed without commutators.
//!
//! (1)  s⅓ = advance(s0, h/3, k1),  k1 = rates(t, s0)
//! (2)  s⅔ = advance(s0, 2h/3, k2),  k2 = rates(t + h/3, s⅓)
//! (3)  s1 = advance(s⅓, h, −1/12 k1 + 3/4 k3),  k3 = rates(t + 2h/3, s⅔)
//!
//! (3) goes on from s⅓, whose rotation R(k1/3, h) is the first factor of the step's: Heun's weights (¼, 0, ¾) are
//! split as (⅓, 0, 0) and (−1/12, 0, ¾) because rotations do not commute; in one exponential they are second order.
//!
//! Source: celledoni2003, third order with the abscissas 0, 1/3, 2/3; peskin2021.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Rates};

/// Third order, three evaluations and three rotations a step.
#[derive(Clone, Copy, Debug)]
pub struct PeskinRk3;

impl Scheme for PeskinRk3 {
    fn card(&self) -> Card {
        Card {
            name: "peskin-rk3",
            title: "The note's ingredients at third order",
            family: "the note, varied",
            source: "celledoni2003; peskin2021",
            claims: claims![ROTATIONS;
                Order(3), Energy(Secular { rate_order: 3 }), FlipTimes, Evaluations(3),
            ],
        }
    }
    const STATES: usize = 2;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [third, two_thirds] = work.buffers();
        let twelfth = M::Real::ratio(1.0, 12.0);
        let k1 = model.rates(t, from)?;
        model.advance(from, h / 3.0, &k1, third); // (1)
        let k2 = model.rates(t + h / 3.0, third)?;
        model.advance(from, h * 2.0 / 3.0, &k2, two_thirds); // (2)
        let k3 = model.rates(t + h * 2.0 / 3.0, two_thirds)?;
        model.advance(third, h, &(k1.scaled(-twelfth) + k3 * (3.0 / 4.0)), to); // (3)
        Ok(())
    }
}
