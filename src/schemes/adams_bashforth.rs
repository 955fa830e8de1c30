//! Adams and Bashforth's methods: rates of earlier steps, weighted, in a vector space.
//!
//! (0)  the first steps by `peskin-rk4`, whose error does not cap the order; or, started cold, with all earlier rates those of t = 0
//! (1)  q(t+h) = q(t) + h Σ_j b_j q̇(t − j h),  q̇ = ½ Ω q, then scaled back to length one
//! (2)  X_cm, U_cm and L likewise from U_cm, F/M and τ
//!
//! (1) is in quaternions: weighted spins held in one exact rotation would be of second order at most, because spins
//! at different times do not commute.
//!
//! Earlier states stand behind those of the start-up scheme, the latest last, as their rates do in the history.
//!
//! Source: bashforth1883 for the weights; jsbsim for attitudes in this way and for the cold start, whose first step is Euler's. Its error,
//! ∝ h², stays in the motion: second order, whatever the weights promise. One evaluation a step.

use nalgebra::Quaternion;

use super::families::{MOMENTA, claims};
use super::{Card, PeskinRk4, Scheme, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::claim::Claim;
use crate::model::{Broken, Rates, Turning};
use crate::rotation::normalized;

/// A method of Adams and Bashforth.
#[derive(Clone, Copy, Debug)]
pub struct AdamsBashforth {
    /// b times the divisor, from the latest rates to the earliest.
    weights: &'static [f64],
    divisor: f64,
    cold: bool,
    name: &'static str,
    title: &'static str,
    claims: &'static [Claim],
}

const FAMILY: &[Claim] = claims![MOMENTA; Exact(AngularVelocity, SteadySpin)];

impl AdamsBashforth {
    /// On two rates.
    pub const TWO: AdamsBashforth = AdamsBashforth {
        weights: &[3.0, -1.0],
        divisor: 2.0,
        cold: false,
        name: "adams-bashforth-2",
        title: "Adams–Bashforth 2 in quaternions, exact start",
        claims: claims![FAMILY;
            Order(2), Exact(Position, ConstantForce), FlipTimes, Energy(Secular { rate_order: 3 }),
        ],
    };
    /// On three rates.
    pub const THREE: AdamsBashforth = AdamsBashforth {
        weights: &[23.0, -16.0, 5.0],
        divisor: 12.0,
        name: "adams-bashforth-3",
        title: "Adams–Bashforth 3 in quaternions, exact start",
        claims: claims![FAMILY;
            Order(3), Exact(Position, ConstantForce), FlipTimes, Energy(Secular { rate_order: 3 }),
        ],
        ..AdamsBashforth::TWO
    };
    /// On four rates.
    pub const FOUR: AdamsBashforth = AdamsBashforth {
        weights: &[55.0, -59.0, 37.0, -9.0],
        divisor: 24.0,
        name: "adams-bashforth-4",
        title: "Adams–Bashforth 4 in quaternions, exact start",
        claims: claims![FAMILY;
            Order(4), Exact(Position, ConstantForce), Energy(Secular { rate_order: 5 }),
        ],
        ..AdamsBashforth::TWO
    };
    /// On three rates, started cold.
    pub const THREE_COLD: AdamsBashforth = AdamsBashforth {
        cold: true,
        name: "adams-bashforth-3-cold",
        title: "Adams–Bashforth 3 in quaternions, history filled with the first rates",
        claims: claims![FAMILY;
            Order(2), Exact(Position, NoForce), FlipTimes, Evaluations(1), Energy(Secular { rate_order: 3 }),
        ],
        ..AdamsBashforth::THREE
    };
    /// On four rates, started cold.
    pub const FOUR_COLD: AdamsBashforth = AdamsBashforth {
        cold: true,
        name: "adams-bashforth-4-cold",
        title: "Adams–Bashforth 4 in quaternions, history filled with the first rates",
        claims: claims![FAMILY;
            Order(2), Exact(Position, NoForce), FlipTimes, Evaluations(1), Energy(Secular { rate_order: 5 }),
        ],
        ..AdamsBashforth::FOUR
    };

    /// b of the rates so many steps ago.
    fn weight<T: Real>(&self, ago: usize) -> T {
        T::ratio(self.weights[ago], self.divisor)
    }

    /// The earlier states in the workspace.
    fn past(&self) -> std::ops::Range<usize> {
        PeskinRk4::STATES..PeskinRk4::STATES + self.weights.len() - 1
    }
}

impl TurningScheme for AdamsBashforth {
    fn card(&self) -> Card {
        let AdamsBashforth { name, title, claims, .. } = *self;
        Card { name, title, family: "multistep", source: "bashforth1883; jsbsim", claims }
    }

    const STATES: usize = PeskinRk4::STATES + 3;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        let known = step.work.history.len();
        let k0 = model.rates(step.t, step.from)?;
        if !self.cold && known + 1 < self.weights.len() {
            step.work.history.push(k0);
            step.work.states[PeskinRk4::STATES + known].clone_from(step.from);
            return PeskinRk4.step(model, step); // (0)
        }
        let Step { h, from, to, work, .. } = step;
        let past = &mut work.states[self.past()];
        if known == 0 {
            work.history.resize(past.len(), k0); // (0)
            past.fill(from.clone());
        }
        let mut rates = k0.scaled(self.weight(0));
        let mut change = derivative(model, from, &k0) * self.weight::<M::Real>(0);
        for (ago, (k, state)) in work.history.iter().zip(past.iter()).rev().enumerate() {
            rates = rates + k.scaled(self.weight(ago + 1));
            change += derivative(model, state, k) * self.weight::<M::Real>(ago + 1);
        }
        model.advance(from, h, &rates, to); // (2)
        let attitude = normalized(model.attitude(from).into_inner() + change * h); // (1)
        let momentum = model.momentum(to);
        model.place(to, attitude, momentum);
        remember(&mut work.history, past, k0, from);
        Ok(())
    }
}

/// Puts rates and their state in the place of the earliest ones, behind all others.
pub(super) fn remember<R, S: Clone>(history: &mut [R], past: &mut [S], rates: R, from: &S) {
    past.rotate_left(1);
    history.rotate_left(1);
    if let (Some(state), Some(k)) = (past.last_mut(), history.last_mut()) {
        state.clone_from(from);
        *k = rates;
    }
}

/// q̇ = ½ Ω q [1/s].
pub(super) fn derivative<M: Turning>(model: &M, state: &M::State, rates: &M::Rates) -> Quaternion<M::Real> {
    Quaternion::from_imag(model.spin_of(rates) * M::Real::of(0.5)) * model.attitude(state).into_inner()
}
