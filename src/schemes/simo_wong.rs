//! Simo and Wong's energy- and momentum-conserving algorithm, in the trapezoidal form.
//!
//! With W = Rᵀ Ω:
//!
//! (1)  R₁ = R₀ exp(h (W₀ + W₁)/2)
//! (2)  L₁ = L₀ + h (τ₀ + τ₁)/2,  X₁ = X₀ + h (U₀ + U₁)/2,  U₁ = U₀ + h (F₀ + F₁)/(2M)
//!
//! Solved by fixed-point iteration. Source: simo1991. Second order; L and energy of a free body constant, since
//! (W₀ + W₁) · (I W₁ − I W₀) = 0 when I W₁ is I W₀ turned about W₀ + W₁.

use super::families::{IMPLICIT, claims};
use super::iteration::until_settled;
use super::vector_form::hold;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};
use crate::rotation::{renormalized, turn, turned_back};

/// Simo and Wong’s algorithm.
#[derive(Clone, Copy, Debug)]
pub struct SimoWong;

impl TurningScheme for SimoWong {
    fn card(&self) -> Card {
        Card {
            name: "simo-wong",
            title: "Simo and Wong, energy and momentum conserving",
            family: "geometric",
            source: "simo1991",
            claims: claims![IMPLICIT;
                Order(2), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
                Energy(Constant), FlipTimes,
            ],
        }
    }
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [before] = work.buffers();
        let attitude0 = model.attitude(from);
        let k0 = model.rates(t, from)?;
        let mut k1 = k0;
        to.clone_from(from);
        until_settled(model, || {
            let body_spin1 = turned_back(&model.attitude(to), &model.spin_of(&k1));
            let mean_spin = (model.spin_of(&k0) + attitude0 * body_spin1) / M::Real::of(2.0);
            let attitude1 = renormalized(turn(&(mean_spin * h)) * attitude0); // (1)
            std::mem::swap(to, before);
            hold(model, from, h, &((k0 + k1) * 0.5), attitude1, to); // (2)
            k1 = model.rates(t + h, to)?;
            Ok(model.apart(to, before))
        })
    }
}
