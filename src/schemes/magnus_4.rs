//! Magnus's expansion to fourth order on two Gauss points, made explicit by three sweeps.
//!
//! (0)  K1 = K2 = rates(t, s0)
//! (1)  s(c) = advance(s0, h, ∫_0^c K + c³ √3/12 h K2 × K1) for c = c1, c2 = ½ ∓ √3/6, K the straight line through K1
//!      at c1 and K2 at c2; the second term, of Ω alone, is the commutator of Magnus's expansion
//! (2)  K1, K2 = rates(t + c1 h, s(c1)), rates(t + c2 h, s(c2)); (1) and (2) three times in all
//! (3)  s1 = s(1) = advance(s0, h, ½ (K1 + K2) + √3/12 h K2 × K1)
//!
//! The equations (1), (2) are implicit; every sweep of the fixed-point iteration gains an order in h, and after three
//! the error of a step is O(h⁵), whether they have converged or not. No tolerance, no Newton iteration.
//!
//! Source: iserles1999 for the expansion; hairer2006, section IV.7.

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Motion, Rates};

/// Fourth order, seven evaluations a step.
#[derive(Clone, Copy, Debug)]
pub struct Magnus4;

const SWEEPS: usize = 3;

impl Scheme for Magnus4 {
    fn card(&self) -> Card {
        Card {
            name: "magnus-4",
            title: "Magnus's expansion on two Gauss points, three sweeps",
            family: "Lie group",
            source: "iserles1999; hairer2006",
            claims: claims![ROTATIONS; Order(4), Energy(Secular { rate_order: 5 }), Evaluations(7)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [stage] = work.buffers();
        let [c1, c2] = gauss_points::<M::Real>();
        let k0 = model.rates(t, from)?; // (0)
        let (mut k1, mut k2) = (k0, k0);
        for _ in 0..SWEEPS {
            model.advance(from, h, &expanded(c1, h, &k1, &k2), stage); // (1)
            let first = model.rates(t + c1 * h, stage)?;
            model.advance(from, h, &expanded(c2, h, &k1, &k2), stage);
            k2 = model.rates(t + c2 * h, stage)?; // (2)
            k1 = first;
        }
        model.advance(from, h, &expanded(M::Real::of(1.0), h, &k1, &k2), to); // (3)
        Ok(())
    }
}

fn gauss_points<T: Real>() -> [T; 2] {
    let part = T::of(3.0).sqrt() / 6.0;
    [T::of(0.5) - part, part + 0.5]
}

/// The rates of (1), to be held for h.
fn expanded<T: Real, R: Rates<T>>(c: T, h: T, k1: &R, k2: &R) -> R {
    let [c1, c2] = gauss_points::<T>();
    let root = T::of(3.0).sqrt();
    let mean = (k1.scaled(root * c * (c2 - c / 2.0)) + k2.scaled(root * c * (c / 2.0 - c1))).motion();
    let commutator = k2.motion().spin.cross(&k1.motion().spin) * (c * c * c * root / 12.0 * h);
    R::of(Motion { spin: mean.spin + commutator, ..mean })
}
