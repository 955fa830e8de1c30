//! Omelyan's leapfrog: angular momenta at half steps, the quaternion carried by its own mean.
//!
//! (1)  L½ = L₀ + h/2 τ₀,  U½ = U₀ + h/2 F₀/M,  X₁ = X₀ + h U½
//! (2)  q½ = (q₀ + q₁)/2,  Ω½ = R½ I⁻¹ R½ᵀ L½             R½ the rotation of q½/|q½|
//! (3)  q₁ = q₀ + h/2 Ω½ q½                               with (2) solved by fixed-point iteration
//! (4)  L₁ = L½ + h/2 τ₁,  U₁ = U½ + h/2 F₁/M
//!
//! (3) leaves |q| what it is: (q₁ − q₀)·(q₁ + q₀) = h Ω½ q½ · q½ = 0. The leapfrog's half-step momenta are told at whole steps by (1)
//! and (4); from step to step it is L½(next) = L½ + h τ₁.
//!
//! Source: omelyan1998. Second order, symmetric; L constant without torque.

use nalgebra::Quaternion;

use super::families::{IMPLICIT, claims};
use super::iteration::until_settled;
use super::vector_form::quaternion_rate;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Turning};
use crate::rotation::{Rotation, normalized, renormalized};

/// Omelyan's leapfrog.
#[derive(Clone, Copy, Debug)]
pub struct OmelyanLeapfrog;

impl TurningScheme for OmelyanLeapfrog {
    fn card(&self) -> Card {
        Card {
            name: "omelyan-leapfrog",
            title: "Omelyan's leapfrog in angular momenta and quaternions",
            family: "geometric",
            source: "omelyan1998",
            claims: claims![IMPLICIT;
                Order(2), Exact(AngularVelocity, SteadySpin), Energy(Bounded), FlipTimes, Evaluations(1),
            ],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let first = match work.history.pop() {
            Some(rates) => rates,
            None => model.rates(t, from)?,
        };
        to.clone_from(from);
        model.kick(to, h / 2.0, &first); // (1)
        model.drift(to, h);
        let momentum = model.momentum(to);
        let q0 = model.attitude(from).into_inner();
        let mut q1 = q0;
        until_settled(model, || {
            let half: Quaternion<M::Real> = (q0 + q1) * M::Real::of(0.5); // (2)
            let spin = model.rotational().spin(&normalized(half), &momentum);
            let last = q1;
            q1 = q0 + quaternion_rate(&spin, &half) * h; // (3)
            Ok((q1 - last).norm())
        })?;
        model.place(to, renormalized(Rotation::new_unchecked(q1)), momentum);
        let last = model.rates(t + h, to)?;
        model.kick(to, h / 2.0, &last); // (4)
        work.history.push(last);
        Ok(())
    }
}
