//! Crouch and Grossman's method of third order: every stage is a product of exact rotations, one a rate.
//!
//! (1)  s2 = advance(s0, ¾ h, k1),  k1 = rates(t, s0)
//! (2)  s3 = advance(advance(s0, 119/216 h, k1), 17/108 h, k2),  k2 = rates(t + ¾ h, s2)
//! (3)  s1 = advance(advance(advance(s0, 13/51 h, k1), −⅔ h, k2), 24/17 h, k3),  k3 = rates(t + 17/24 h, s3)
//!
//! In the world frame a later factor stands to the left, so the first rate turns the body first; in the other
//! order the method is of second order only.
//!
//! Source: crouch1993, with the coefficients printed in hairer2006, section IV.8.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model};

/// Third order, three evaluations and six rotations a step.
#[derive(Clone, Copy, Debug)]
pub struct CrouchGrossman3;

impl Scheme for CrouchGrossman3 {
    fn card(&self) -> Card {
        Card {
            name: "crouch-grossman-3",
            title: "Crouch and Grossman's method of third order",
            family: "Lie group",
            source: "crouch1993; hairer2006",
            claims: claims![ROTATIONS;
                Order(3), Energy(Secular { rate_order: 3 }), FlipTimes, Evaluations(3),
            ],
        }
    }
    const STATES: usize = 2;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [first, second] = work.buffers();
        let k1 = model.rates(t, from)?;
        model.advance(from, h * M::Real::ratio(3.0, 4.0), &k1, second); // (1)
        let k2 = model.rates(t + h * M::Real::ratio(3.0, 4.0), second)?;
        model.advance(from, h * M::Real::ratio(119.0, 216.0), &k1, first);
        model.advance(first, h * M::Real::ratio(17.0, 108.0), &k2, second); // (2)
        let k3 = model.rates(t + h * M::Real::ratio(17.0, 24.0), second)?;
        model.advance(from, h * M::Real::ratio(13.0, 51.0), &k1, first);
        model.advance(first, h * M::Real::ratio(-2.0, 3.0), &k2, second);
        model.advance(second, h * M::Real::ratio(24.0, 17.0), &k3, to); // (3)
        Ok(())
    }
}
