//! Semi-implicit Euler with an explicit gyroscopic term, whose |L| is put right after the step.
//!
//! (1)  ω₁ = ω₀ + h I⁻¹ (τ − ω₀ × I ω₀)
//! (2)  U₁ = U₀ + h F/M,  X₁ = X₀ + h U₁,  q₁ = q₀ + h/2 Ω₁ q₀ over its length,  Ω₁ = R₀ ω₁,  L̃ = I(q₁) Ω₁
//! (3)  L₁ = L̃ |L₀ + h τ| / |L̃|
//!
//! ω and τ in (1) are about the principal axes of the old attitude.
//!
//! Source: catto2015 for (1) and (2); (3) is game developers' lore without a publication that we know of. First
//! order; |L| of a free body is constant, its direction is not.

use super::families::{ENGINES, claims};
use super::semi_implicit::{explicit_spin, move_by};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};
use crate::rotation::length;

/// Semi-implicit Euler with a corrected |L|.
#[derive(Clone, Copy, Debug)]
pub struct MomentumClampedEuler;

impl TurningScheme for MomentumClampedEuler {
    fn card(&self) -> Card {
        Card {
            name: "momentum-clamped-euler",
            title: "semi-implicit Euler, explicit gyroscopic term, |L| rescaled",
            family: "engines",
            source: "catto2015",
            claims: claims![ENGINES; Order(1)],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        let spin = explicit_spin(model, h, from, &k0); // (1)
        move_by(model, h, from, &k0, &spin, to); // (2)
        let momentum = model.momentum(to);
        let implied = length(&(model.momentum(from) + model.torque_of(&k0) * h));
        let found = length(&momentum);
        if found != 0.0 {
            let attitude = model.attitude(to);
            model.place(to, attitude, momentum * (implied / found)); // (3)
        }
        Ok(())
    }
}
