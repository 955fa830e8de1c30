//! The implicit midpoint rule in body axes, with Cayley's map for the attitude.
//!
//! With m = Rᵀ L and cay Cayley’s map:
//!
//! (1)  m½ = (m₀ + m₁)/2,  ω = I⁻¹ m½
//! (2)  R₁ = R₀ cay(h ω),  R½ halfway between R₀ and R₁
//! (3)  X½ = X₀ + h/2 U½,  U½ = U₀ + h/2 F½/M,  F½ and τ½ at (t + h/2, R½, X½, U½, R½ m½)
//! (4)  m₁ = m₀ + h (m½ × ω + R½ᵀ τ½)
//! (5)  X₁ = X₀ + h U½,  U₁ = U₀ + h F½/M,  L₁ = R₁ m₁
//!
//! Solved by fixed-point iteration. Source: austin1993. Second order; L and energy of a free body constant: (2) and
//! (4) turn m by cay(−h ω), and I⁻¹ m½ · (m₁ − m₀) = 0.

use super::cayley::cayley;
use super::families::{FLIGHT, claims};
use super::iteration::until_settled;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};
use crate::rotation::{normalized, renormalized, turned_back};

/// The implicit midpoint rule with the Cayley map.
#[derive(Clone, Copy, Debug)]
pub struct ImplicitMidpoint;

impl TurningScheme for ImplicitMidpoint {
    fn card(&self) -> Card {
        Card {
            name: "implicit-midpoint",
            title: "implicit midpoint rule with the Cayley map",
            family: "geometric",
            source: "austin1993",
            claims: claims![FLIGHT;
                Order(2), Exact(AngularMomentum, NoTorque), Exact(AngularVelocity, SteadySpin), Energy(Constant),
                FlipTimes, Rigid, Reversible, Solves(1),
            ],
        }
    }
    const STATES: usize = 2;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let (first, second) = work.states.split_at_mut(1);
        let (mut half, mut before) = (&mut first[0], &mut second[0]);
        let body = model.rotational();
        let attitude0 = model.attitude(from);
        let m0 = turned_back(&attitude0, &model.momentum(from));
        let (mut m1, mut attitude1) = (m0, attitude0);
        let mut rates = model.rates(t, from)?;
        before.clone_from(from);
        until_settled(model, || {
            let middle = (m0 + m1) / M::Real::of(2.0); // (1)
            let spin = body.inverse_moments.component_mul(&middle);
            attitude1 = renormalized(attitude0 * cayley(&(spin * h))); // (2)
            let halfway = normalized(*attitude0 + *attitude1);
            model.advance(from, h / 2.0, &rates, half); // (3)
            model.place(half, halfway, halfway * middle);
            rates = model.rates(t + h / 2.0, half)?;
            let torque = turned_back(&halfway, &model.torque_of(&rates));
            m1 = m0 + (middle.cross(&spin) + torque) * h; // (4)
            let change = model.apart(half, before);
            std::mem::swap(&mut half, &mut before);
            Ok(change)
        })?;
        model.advance(from, h, &rates, to); // (5)
        model.place(to, attitude1, attitude1 * m1);
        Ok(())
    }
}
