//! The commutator-free method of fourth order in body axes: rotations multiply from the right.
//!
//! (0)  ω = Rᵀ Ω;  turn(s, ω) = R exp(s ω), and everything but the attitude as in `advance`
//! (1)  s2 = s0 turned by (h/2, ω1),  ω1 at t
//! (2)  s3 = s0 turned by (h/2, ω2),  ω2 at t + h/2
//! (3)  s4 = s2 turned by (h, ω3 − ½ ω1),  ω3 at t + h/2
//! (4)  s½ = s0 turned by (h, ¼ ω1 + ⅙ ω2 + ⅙ ω3 − 1/12 ω4),  ω4 at t + h
//! (5)  s1 = s½ turned by (h, −1/12 ω1 + ⅙ ω2 + ⅙ ω3 + ¼ ω4)
//!
//! The same method on spins in world axes is `peskin-rk4`: the weights agree, the errors do not, because a sum of
//! spins in body axes is not the sum in world axes. L stays in world axes, so that it is exact without torque.
//!
//! Source: celledoni2003.

use super::families::{BALLISTIC, claims};
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Motion, Rates, Turning};
use crate::rotation;

/// Fourth order in body axes, four evaluations a step.
#[derive(Clone, Copy, Debug)]
pub struct Cf4;

impl TurningScheme for Cf4 {
    fn card(&self) -> Card {
        Card {
            name: "cf4",
            title: "Commutator-free method of fourth order, body axes",
            family: "Lie group",
            source: "celledoni2003",
            claims: claims![BALLISTIC;
                Order(4), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
                Energy(Secular { rate_order: 5 }), Evaluations(4),
            ],
        }
    }
    const STATES: usize = 2;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [early, stage] = work.buffers();
        let k1 = body_rates(model, t, from)?;
        turn(model, from, h / 2.0, &k1, early); // (1)
        let k2 = body_rates(model, t + h / 2.0, early)?;
        turn(model, from, h / 2.0, &k2, stage); // (2)
        let k3 = body_rates(model, t + h / 2.0, stage)?;
        turn(model, early, h, &(k3 + k1 * (-1.0 / 2.0)), stage); // (3)
        let k4 = body_rates(model, t + h, stage)?;
        let [sixth, twelfth] = [6.0, 12.0].map(|parts| M::Real::ratio(1.0, parts));
        let middle = (k2 + k3).scaled(sixth);
        turn(model, from, h, &(k1 * (1.0 / 4.0) + middle + k4.scaled(-twelfth)), early); // (4)
        turn(model, early, h, &(k1.scaled(-twelfth) + middle + k4 * (1.0 / 4.0)), to); // (5)
        Ok(())
    }
}

/// Rates with the spin in body axes.
fn body_rates<M: Turning>(model: &M, t: M::Real, state: &M::State) -> Result<M::Rates, Broken> {
    let motion = model.rates(t, state)?.motion();
    let spin = rotation::turned_back(&model.attitude(state), &motion.spin);
    Ok(M::Rates::of(Motion { spin, ..motion }))
}

/// `advance` with a spin in body axes.
fn turn<M: Turning>(model: &M, from: &M::State, s: M::Real, rates: &M::Rates, into: &mut M::State) {
    model.advance(from, s, rates, into);
    let turn = rotation::turn(&(rates.motion().spin * s));
    let momentum = model.momentum(into);
    model.place(into, rotation::renormalized(model.attitude(from) * turn), momentum); // (0)
}
