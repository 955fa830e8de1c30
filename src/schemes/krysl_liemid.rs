//! The midpoint Lie algorithm: Peskin's second stage with a midpoint that is its own.
//!
//! (1)  s½ = advance(s₀, h/2, k½)
//! (2)  k½ = rates(t + h/2, s½)
//! (3)  s₁ = advance(s₀, h, k½)
//!
//! (1) and (2) are solved by fixed-point iteration. In body axes this is exp(Ψ/2) π₁ = exp(−Ψ/2) π₀ + h τ½ with
//! Ψ = h I⁻¹ π½. Source: krysl2005. Second order; L constant without torque.

use super::families::{IMPLICIT, claims};
use super::iteration::until_settled;
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};

/// The midpoint Lie algorithm.
#[derive(Clone, Copy, Debug)]
pub struct KryslLiemid;

impl TurningScheme for KryslLiemid {
    fn card(&self) -> Card {
        Card {
            name: "krysl-liemid",
            title: "midpoint Lie algorithm (LIEMID)",
            family: "Lie group",
            source: "krysl2005",
            claims: claims![IMPLICIT;
                Order(2), Exact(Orientation, SteadySpin), Exact(AngularVelocity, SteadySpin),
                Energy(Bounded), FlipTimes,
            ],
        }
    }
    const STATES: usize = 2;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let (first, second) = work.states.split_at_mut(1);
        let (mut half, mut before) = (&mut first[0], &mut second[0]);
        let mut middle = model.rates(t, from)?;
        before.clone_from(from);
        until_settled(model, || {
            model.advance(from, h / 2.0, &middle, half); // (1)
            middle = model.rates(t + h / 2.0, half)?; // (2)
            let change = model.apart(half, before);
            std::mem::swap(&mut half, &mut before);
            Ok(change)
        })?;
        model.advance(from, h, &middle, to); // (3)
        Ok(())
    }
}
