//! Buss's augmented second-order method: Taylor's expansion of the rotation vector, with the part of its third
//! order that the change of Ω's direction makes.
//!
//! (1)  α = I⁻¹ (τ₀ − Ω₀ × L₀)
//! (2)  Ω̄ = Ω₀ + h/2 α + h²/12 α × Ω₀,  R₁ = exp(h Ω̄) R₀
//! (3)  X₁ = X₀ + h U₀ + h²/2 F₀/M;  U₁, L₁ by F₀, τ₀ as a first guess
//! (4)  U₁ = U₀ + h (F₀ + F₁)/(2M),  L₁ = L₀ + h (τ₀ + τ₁)/2
//!
//! I is the inertia in world axes. Source: buss2000 for (1) and (2), with constant torque there; (3) and (4) are the
//! trapezoid that keeps the second order under a torque that changes. L constant without torque.

use super::families::{ROTATIONS, claims};
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};
use crate::rotation::{renormalized, turn};

/// Buss’s augmented method.
#[derive(Clone, Copy, Debug)]
pub struct BussAugmented;

impl TurningScheme for BussAugmented {
    fn card(&self) -> Card {
        Card {
            name: "buss-augmented",
            title: "Buss, augmented second order",
            family: "Lie group",
            source: "buss2000",
            claims: claims![ROTATIONS;
                Order(2), Energy(Secular { rate_order: 3 }), FlipTimes, Evaluations(2),
            ],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, .. }: Step<M>) -> Result<(), Broken> {
        let k0 = model.rates(t, from)?;
        let attitude = model.attitude(from);
        let (spin, torque) = (model.spin_of(&k0), model.torque_of(&k0));
        let unbalanced = torque - spin.cross(&model.momentum(from));
        let change = model.rotational().spin(&attitude, &unbalanced); // (1)
        let mean = spin + change * (h / 2.0) + change.cross(&spin) * (h * h / 12.0); // (2)
        to.clone_from(from);
        model.kick(to, h / 2.0, &k0); // (3)
        model.drift(to, h);
        model.kick(to, h / 2.0, &k0);
        let momentum = model.momentum(to);
        model.place(to, renormalized(turn(&(mean * h)) * attitude), momentum);
        let k1 = model.rates(t + h, to)?;
        model.kick(to, h / 2.0, &(k1 + k0 * -1.0)); // (4)
        Ok(())
    }
}
