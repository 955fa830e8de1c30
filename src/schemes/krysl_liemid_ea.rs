//! The midpoint Lie algorithm with the impulse of the torque at the ends of the step, once after and once before
//! half a step of free motion: explicit in the forces.
//!
//! (1)  L½ = L₀ + h/2 τ₀,  U½ = U₀ + h/2 F₀/M
//! (2)  X₁ = X₀ + h U½
//! (3)  twice:  Θ = h/2 Ω(exp(Θ/2) R, L½),  R ← exp(Θ) R
//! (4)  L₁ = L½ + h/2 τ₁,  U₁ = U½ + h/2 F₁/M
//!
//! (3) is solved by fixed-point iteration; Ω(R, L) = R I⁻¹ Rᵀ L. Second order, by composing two adjoint methods of first
//! order; L constant without torque.
//!
//! Source: krysl2004 for the idea: the midpoint rule in the Lie sense on two half steps, the impulse of the forces delivered at
//! the beginning of the first and at the end of the second. krysl2005 works it out; that its algorithm of this name is these
//! lines, formula by formula, has not been checked against its text.

use nalgebra::Vector3;

use super::families::{ROTATIONS, claims};
use super::iteration::until_settled;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};
use crate::rotation::{self, Rotation, renormalized, turn};

/// The midpoint Lie algorithm with end impulses.
#[derive(Clone, Copy, Debug)]
pub struct KryslLiemidEa;

impl TurningScheme for KryslLiemidEa {
    fn card(&self) -> Card {
        Card {
            name: "krysl-liemid-ea",
            title: "midpoint Lie algorithm, explicit in the forces, reconstructed",
            family: "Lie group",
            source: "krysl2004; krysl2005",
            claims: claims![ROTATIONS;
                Order(2), Energy(Bounded), FlipTimes, Reversible, Evaluations(2), Solves(2),
            ],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        to.clone_from(from);
        model.kick(to, h / 2.0, &k0); // (1)
        model.drift(to, h); // (2)
        let momentum = model.momentum(to);
        let first = free_midpoint(model, h / 2.0, &model.attitude(to), &momentum)?; // (3)
        let second = free_midpoint(model, h / 2.0, &first, &momentum)?;
        model.place(to, second, momentum);
        let k1 = model.rates(t + h, to)?;
        model.kick(to, h / 2.0, &k1); // (4)
        Ok(())
    }
}

/// The attitude of a free body after a time `s`, by (3).
fn free_midpoint<M: Turning>(
    model: &M,
    s: M::Real,
    q: &Rotation<M::Real>,
    l: &Vector3<M::Real>,
) -> Result<Rotation<M::Real>, Broken> {
    let body = model.rotational();
    let mut angle = body.spin(q, l) * s;
    until_settled(model, || {
        let last = angle;
        angle = body.spin(&(turn(&(last / M::Real::of(2.0))) * q), l) * s;
        Ok(rotation::length(&(angle - last)))
    })?;
    Ok(renormalized(turn(&angle) * q))
}
