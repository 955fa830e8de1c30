//! Semi-implicit Euler without the gyroscopic term, as many engines step by default.
//!
//! (1)  ω₁ = ω₀ + h I⁻¹ τ
//! (2)  U₁ = U₀ + h F/M,  X₁ = X₀ + h U₁,  q₁ = q₀ + h/2 Ω₁ q₀ over its length,  Ω₁ = R₀ ω₁,  L₁ = I(q₁) Ω₁
//!
//! ω and τ are about the principal axes of the old attitude.
//!
//! Source: catto2015. No order: it solves I Ω̇ = τ, which is the equation of a sphere. A free body keeps its Ω,
//! whatever its shape, and so loses its L; translation alone is of first order.

use super::families::{ENGINES, claims};
use super::semi_implicit::{in_body_axes, move_by};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};

/// Semi-implicit Euler without gyroscopic term.
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEulerNoGyro;

impl TurningScheme for SemiImplicitEulerNoGyro {
    fn card(&self) -> Card {
        Card {
            name: "semi-implicit-euler-no-gyro",
            title: "semi-implicit Euler without gyroscopic term",
            family: "engines",
            source: "catto2015",
            claims: claims![ENGINES; SolvesAnotherMotion],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        let (spin, torque) = in_body_axes(model, from, &k0);
        let inverse = &model.rotational().inverse_moments;
        let spin = spin + inverse.component_mul(&torque) * h; // (1)
        move_by(model, h, from, &k0, &spin, to); // (2)
        Ok(())
    }
}
