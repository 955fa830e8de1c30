//! Semi-implicit Euler with an implicit gyroscopic term, solved by one Newton step in body axes.
//!
//! (1)  ω̃ = ω₀ + h I⁻¹ τ
//! (2)  f = h ω̃ × I ω̃,  J = I + h ([ω̃]× I − [I ω̃]×)
//! (3)  ω₁ = ω̃ − J⁻¹ f
//! (4)  U₁ = U₀ + h F/M,  X₁ = X₀ + h U₁,  q₁ = q₀ + h/2 Ω₁ q₀ over its length,  Ω₁ = R₀ ω₁,  L₁ = I(q₁) Ω₁
//!
//! ω and τ are about the principal axes of the old attitude; f is what is left of I (ω − ω̃) + h ω × I ω = 0 at ω̃.
//!
//! Source: catto2015. First order; stable, since it takes energy from a free body and, with it, L.

use nalgebra::Matrix3;

use super::families::{ENGINES, claims};
use super::semi_implicit::{in_body_axes, move_by};
use super::small::{gyroscopic_slope, solved};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};

/// Semi-implicit Euler with implicit gyroscopic term.
#[derive(Clone, Copy, Debug)]
pub struct SemiImplicitEulerImplicitGyro;

impl TurningScheme for SemiImplicitEulerImplicitGyro {
    fn card(&self) -> Card {
        Card {
            name: "semi-implicit-euler-implicit-gyro",
            title: "semi-implicit Euler, implicit gyroscopic term",
            family: "engines",
            source: "catto2015",
            claims: claims![ENGINES; Order(1), Energy(Falls)],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = false;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        let (spin, torque) = in_body_axes(model, from, &k0);
        let body = model.rotational();
        let spin = spin + body.inverse_moments.component_mul(&torque) * h; // (1)
        let momentum = body.moments.component_mul(&spin);
        let left = spin.cross(&momentum) * h; // (2)
        let slope = Matrix3::from_diagonal(&body.moments) + gyroscopic_slope(&spin, &body.moments) * h;
        let change = solved(slope, left).ok_or(Broken::Singular)?;
        move_by(model, h, from, &k0, &(spin - change), to); // (3), (4)
        Ok(())
    }
}
