//! Adams and Bashforth's methods on body rates, started cold, as JSBSim has them.
//!
//! In principal axes, with v = Rᵀ Ω and v̇ = I⁻¹ (Rᵀ τ − v × I v):
//!
//! (0)  all earlier rates are those of t = 0
//! (1)  v(t+h) = v(t) + h Σ_j b_j v̇(t − j h)
//! (2)  q(t+h) = q(t) + h Σ_j b_j q̇(t − j h),  q̇ = ½ Ω q, then scaled back to length one
//! (3)  X_cm and U_cm likewise from U_cm and F/M
//! (4)  L = R I v
//!
//! [`AdamsBashforth`](super::AdamsBashforth) steps L in the world in place of (1). Its orientation turns the constant L into a spin, and
//! makes other errors: 10 to 800 times larger ones where a body flips.
//!
//! Source: bashforth1883 for the weights; jsbsim for (0) to (3). The error of (0) is ∝ h² and stays in the motion: second order, whatever
//! the weights promise. L is not constant without torque. One evaluation a step.

use nalgebra::Vector3;

use super::accelerations::Accelerations;
use super::adams_bashforth::{derivative, remember};
use super::families::claims;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::claim::Claim;
use crate::model::{Broken, Rates, Turning};
use crate::rotation::{normalized, turned_back};

/// A method of Adams and Bashforth on body rates.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforthBody {
    /// b times the divisor, from the latest rates to the earliest.
    weights: &'static [f64],
    divisor: f64,
    name: &'static str,
    title: &'static str,
    claims: &'static [Claim],
}

const FAMILY: &[Claim] = claims![;
    Order(2), Exact(Velocity, ConstantForce), Exact(Position, NoForce), Exact(AngularVelocity, SteadySpin), FlipTimes, Equivariant,
    Evaluations(1),
];

impl AdamsBashforthBody {
    /// On two rates.
    pub const TWO: AdamsBashforthBody = AdamsBashforthBody {
        weights: &[3.0, -1.0],
        divisor: 2.0,
        name: "adams-bashforth-2-body",
        title: "Adams–Bashforth 2 on body rates, started cold (JSBSim)",
        claims: claims![FAMILY; Energy(Secular { rate_order: 3 })],
    };
    /// On three rates.
    pub const THREE: AdamsBashforthBody = AdamsBashforthBody {
        weights: &[23.0, -16.0, 5.0],
        divisor: 12.0,
        name: "adams-bashforth-3-body",
        title: "Adams–Bashforth 3 on body rates, started cold (JSBSim)",
        claims: claims![FAMILY; Energy(Secular { rate_order: 3 })],
    };
    /// On four rates.
    pub const FOUR: AdamsBashforthBody = AdamsBashforthBody {
        weights: &[55.0, -59.0, 37.0, -9.0],
        divisor: 24.0,
        name: "adams-bashforth-4-body",
        title: "Adams–Bashforth 4 on body rates, started cold (JSBSim)",
        claims: FAMILY,
    };
    /// On five rates. Not in the list: at 0.8 radians a step it amplifies roundings of the attitude, and L with them.
    pub const FIVE: AdamsBashforthBody = AdamsBashforthBody {
        weights: &[1901.0, -2774.0, 2616.0, -1274.0, 251.0],
        divisor: 720.0,
        name: "adams-bashforth-5-body",
        title: "Adams–Bashforth 5 on body rates, started cold (JSBSim)",
        claims: FAMILY,
    };
}

impl TurningScheme for AdamsBashforthBody {
    fn card(&self) -> Card {
        let AdamsBashforthBody { name, title, claims, .. } = *self;
        Card { name, title, family: "multistep", source: "bashforth1883; jsbsim", claims }
    }

    const STATES: usize = 4;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        let past = &mut work.states[..self.weights.len() - 1];
        if work.history.is_empty() {
            work.history.resize(past.len(), k0); // (0)
            past.fill(from.clone());
        }
        let weight = |ago: usize| M::Real::ratio(self.weights[ago], self.divisor);
        let mut rates = k0.scaled(weight(0));
        let mut turning = derivative(model, from, &k0) * weight(0);
        let mut gain = acceleration(model, from, &k0) * weight(0);
        for (ago, (k, state)) in work.history.iter().zip(past.iter()).rev().enumerate() {
            rates = rates + k.scaled(weight(ago + 1));
            turning += derivative(model, state, k) * weight(ago + 1);
            gain += acceleration(model, state, k) * weight(ago + 1);
        }
        let body = model.rotational();
        let old = model.attitude(from);
        let spin = body.inverse_moments.component_mul(&turned_back(&old, &model.momentum(from)));
        model.advance(from, h, &rates, to); // (3)
        let attitude = normalized(old.into_inner() + turning * h); // (2)
        let momentum = attitude * body.moments.component_mul(&(spin + gain * h)); // (1), (4)
        model.place(to, attitude, momentum);
        remember(&mut work.history, past, k0, from);
        Ok(())
    }
}

/// v̇ [rad/s²].
fn acceleration<M: Turning>(model: &M, state: &M::State, rates: &M::Rates) -> Vector3<M::Real> {
    Accelerations::of(model, rates, &model.attitude(state), &model.momentum(state)).spin
}
