//! Munthe-Kaas's method on the classical tableau: Runge–Kutta in the rotation vector of the step.
//!
//! (1)  K1 = k1 = rates(t, s0)
//! (2)  K2 = d(h/2 K1, rates(t + h/2, advance(s0, h/2, K1)))
//! (3)  K3 = d(h/2 K2, rates(t + h/2, advance(s0, h/2, K2)))
//! (4)  K4 = d(h K3, rates(t + h, advance(s0, h, K3)))
//! (5)  s1 = advance(s0, h, ⅙ K1 + ⅓ K2 + ⅓ K3 + ⅙ K4)
//! (6)  d(u, k): Ω becomes Ω − ½ u × Ω + 1/12 u × (u × Ω), the inverse derivative of exp at u cut off at the order
//!      of the method; the other rates stay, since positions, velocities and L add.
//!
//! Source: munthekaas1999; hairer2006, section IV.8. Signs for rotations that multiply from the left.

use nalgebra::Vector3;

use super::families::{ROTATIONS, claims};
use super::{Card, Scheme, Step};
use crate::arithmetic::Real;
use crate::model::{Broken, Model, Motion, Rates};

/// Fourth order, four evaluations and four rotations a step.
#[derive(Clone, Copy, Debug)]
pub struct Rkmk4;

impl Scheme for Rkmk4 {
    fn card(&self) -> Card {
        Card {
            name: "rkmk4",
            title: "Runge–Kutta–Munthe-Kaas of fourth order",
            family: "Lie group",
            source: "munthekaas1999; hairer2006",
            claims: claims![ROTATIONS; Order(4), Energy(Secular { rate_order: 5 }), Evaluations(4)],
        }
    }
    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [stage] = work.buffers();
        let k1 = model.rates(t, from)?; // (1)
        model.advance(from, h / 2.0, &k1, stage);
        let k2 = pulled_back(h / 2.0, &k1, &model.rates(t + h / 2.0, stage)?); // (2)
        model.advance(from, h / 2.0, &k2, stage);
        let k3 = pulled_back(h / 2.0, &k2, &model.rates(t + h / 2.0, stage)?); // (3)
        model.advance(from, h, &k3, stage);
        let k4 = pulled_back(h, &k3, &model.rates(t + h, stage)?); // (4)
        let [third, sixth] = [3.0, 6.0].map(|parts| M::Real::ratio(1.0, parts));
        model.advance(from, h, &((k1 + k4).scaled(sixth) + (k2 + k3).scaled(third)), to); // (5)
        Ok(())
    }
}

/// d(s K, k) of (6).
fn pulled_back<T: Real, R: Rates<T>>(s: T, reached_by: &R, rates: &R) -> R {
    let u: Vector3<T> = reached_by.motion().spin * s;
    let motion = rates.motion();
    let across = u.cross(&motion.spin);
    R::of(Motion { spin: motion.spin - across / T::of(2.0) + u.cross(&across) / T::of(12.0), ..motion })
}
