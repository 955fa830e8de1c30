//! The generalised-α method on the rotation group, with the spectral radius ρ = ½ at infinite frequency.
//!
//! In body axes, with v = Rᵀ Ω, v̇ = I⁻¹ (Rᵀ τ − v × I v) and an algorithmic acceleration a that is carried from step to step:
//!
//! (1)  R₁ = R₀ exp(h v₀ + h² ((½ − β) a₀ + β a₁))
//! (2)  v₁ = v₀ + h ((1 − γ) a₀ + γ a₁)
//! (3)  (1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀
//! (4)  α_m = (2ρ − 1)/(ρ + 1),  α_f = ρ/(ρ + 1),  γ = ½ + α_f − α_m,  β = ¼ (γ + ½)²
//! (5)  X_cm and U_cm likewise, in their own space;  a₀ = v̇₀ when a run starts
//!
//! Solved by fixed-point iteration. Source: chung1993 for (3) and (4); bruls2010 on groups. Second order; numerical damping of what
//! turns by more than a radian a step.

use super::accelerations::{Accelerations, Alphas};
use super::families::{FLIGHT, claims};
use super::iteration::until_settled;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Motion, Rates, Turning};
use crate::rotation::{renormalized, turn, turned_back, zero};

/// The generalised-α method on the rotation group.
#[derive(Clone, Copy, Debug)]
pub struct GeneralizedAlpha {
    /// ρ, the spectral radius at infinite frequency.
    radius: f64,
    name: &'static str,
    title: &'static str,
}

impl GeneralizedAlpha {
    /// ρ = ½.
    pub const HALF: GeneralizedAlpha = GeneralizedAlpha {
        radius: 0.5,
        name: "generalized-alpha",
        title: "generalized-alpha on the rotation group, spectral radius 1/2",
    };
}

impl TurningScheme for GeneralizedAlpha {
    fn card(&self) -> Card {
        Card {
            name: self.name,
            title: self.title,
            family: "Lie group",
            source: "chung1993; bruls2010",
            claims: claims![FLIGHT;
                Order(2), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
                Energy(Secular { rate_order: 3 }), Rigid, Solves(1),
            ],
        }
    }
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = false;
    const KEEPS_MOMENTUM: bool = false;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let alphas = Alphas::of(M::Real::of(self.radius)); // (4)
        let body = model.rotational();
        let (attitude0, momentum0) = (model.attitude(from), model.momentum(from));
        let v0 = body.inverse_moments.component_mul(&turned_back(&attitude0, &momentum0));
        let k0 = model.rates(t, from)?;
        let velocity0 = k0.motion().velocity;
        let true0 = Accelerations::of(model, &k0, &attitude0, &momentum0);
        let a0 = work.history.pop().map_or(true0, Accelerations::remembered); // (5)
        let [before] = work.buffers();
        let mut a1 = a0;
        to.clone_from(from);
        until_settled(model, || {
            let (mean, change) = (alphas.mean(&a0, &a1), alphas.change(&a0, &a1));
            std::mem::swap(to, before);
            let rates = M::Rates::of(Motion {
                spin: zero(),
                velocity: velocity0 + mean.velocity * h,
                acceleration: change.velocity,
                torque: zero(),
            });
            model.advance(from, h, &rates, to); // (5)
            let attitude = renormalized(attitude0 * turn(&((v0 + mean.spin * h) * h))); // (1)
            let momentum = attitude * body.moments.component_mul(&(v0 + change.spin * h)); // (2)
            model.place(to, attitude, momentum);
            let true1 = Accelerations::of(model, &model.rates(t + h, to)?, &attitude, &momentum);
            a1 = alphas.algorithmic(&a0, &true0, &true1); // (3)
            Ok(model.apart(to, before))
        })?;
        work.history.push(a1.kept());
        Ok(())
    }
}
