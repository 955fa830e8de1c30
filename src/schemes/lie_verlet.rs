//! The variational Lie–Verlet method: half a kick, a step of free motion with Cayley's map, half a kick.
//!
//! With m = Rᵀ L, ω the spin of the step about principal axes, and cay Cayley’s map:
//!
//! (1)  L½ = L₀ + h/2 τ₀,  U½ = U₀ + h/2 F₀/M,  X₁ = X₀ + h U½
//! (2)  solve  I ω + h/2 ω × I ω + h²/4 (ω·I ω) ω = R₀ᵀ L½  by Newton's method
//! (3)  R₁ = R₀ cay(h ω)
//! (4)  L₁ = L½ + h/2 τ₁,  U₁ = U½ + h/2 F₁/M
//!
//! (2) is the left trivialised derivative of cay⁻¹; the same with −h gives R₁ᵀ L½, so that L½ is the same vector.
//! Source: bourabee2009. Second order; L constant without torque.

use super::cayley::{cayley, spin_of_step};
use super::families::{IMPLICIT, claims};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};
use crate::rotation::{renormalized, turned_back};

/// The variational Lie–Verlet method.
#[derive(Clone, Copy, Debug)]
pub struct LieVerlet;

impl TurningScheme for LieVerlet {
    fn card(&self) -> Card {
        Card {
            name: "lie-verlet",
            title: "variational Lie-Verlet with the Cayley map",
            family: "Lie group",
            source: "bourabee2009",
            claims: claims![IMPLICIT;
                Order(2), Exact(AngularVelocity, SteadySpin), Energy(Bounded), FlipTimes, Symplectic,
                Evaluations(2),
            ],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        to.clone_from(from);
        model.kick(to, h / 2.0, &k0); // (1)
        model.drift(to, h);
        let (attitude, momentum) = (model.attitude(from), model.momentum(to));
        let in_body = turned_back(&attitude, &momentum);
        let spin = spin_of_step(model, h, &in_body)?; // (2)
        model.place(to, renormalized(attitude * cayley(&(spin * h))), momentum); // (3)
        let k1 = model.rates(t + h, to)?;
        model.kick(to, h / 2.0, &k1); // (4)
        Ok(())
    }
}
