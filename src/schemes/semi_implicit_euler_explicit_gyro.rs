//! Semi-implicit Euler with the gyroscopic term of the old spin.
//!
//! (1)  ω₁ = ω₀ + h I⁻¹ (τ − ω₀ × I ω₀)
//! (2)  U₁ = U₀ + h F/M,  X₁ = X₀ + h U₁,  q₁ = q₀ + h/2 Ω₁ q₀ over its length,  Ω₁ = R₀ ω₁,  L₁ = I(q₁) Ω₁
//!
//! ω and τ are about the principal axes of the old attitude.
//!
//! Source: catto2015. First order; neither L nor energy is kept without torque: both grow.

use super::families::{ENGINES, claims};
use super::semi_implicit::{explicit_spin, move_by};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};

/// Semi-implicit Euler with explicit gyroscopic term.
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEulerExplicitGyro;

impl TurningScheme for SemiImplicitEulerExplicitGyro {
    fn card(&self) -> Card {
        Card {
            name: "semi-implicit-euler-explicit-gyro",
            title: "semi-implicit Euler, explicit gyroscopic term",
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
        Ok(())
    }
}
