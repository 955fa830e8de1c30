//! The classical fourth-order Runge–Kutta method on the quaternion and L as plain numbers.
//!
//! With y = (q, X_cm, U_cm, L) and q̇ = ½ Ω q, Ω and forces at q/|q|:
//!
//! (1)  k₁ = f(t, y₀)
//! (2)  k₂ = f(t + h/2, y₀ + h/2 k₁)
//! (3)  k₃ = f(t + h/2, y₀ + h/2 k₂)
//! (4)  k₄ = f(t + h, y₀ + h k₃)
//! (5)  y₁ = y₀ + h (k₁ + 2 k₂ + 2 k₃ + k₄)/6, then q₁ over its length
//!
//! The part of kᵢ that is q̇ comes as d₁ = h/2 q̇, d₂ = h/2 q̇, d₃ = h q̇, d₄ = h/6 q̇: what the next line adds to q₀.
//!
//! Source: kutta1901. Fourth order; L constant without torque; the energy of a free body drifts.

use super::families::{BALLISTIC, claims};
use super::vector_form::hold;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Rates, Shortcut, Turning};
use crate::rotation::{rate_of, unit};

/// The classical Runge–Kutta method on a quaternion.
#[derive(Clone, Copy, Debug)]
pub struct Rk4Quaternion;

impl TurningScheme for Rk4Quaternion {
    fn card(&self) -> Card {
        Card {
            name: "rk4-quaternion",
            title: "classical Runge-Kutta on quaternion and L",
            family: "classical",
            source: "kutta1901",
            claims: claims![BALLISTIC;
                Order(4), Exact(AngularVelocity, SteadySpin), Energy(Secular { rate_order: 5 }), Rigid,
                Evaluations(4),
            ],
        }
    }
    const SHORTCUT: Option<Shortcut> = Some(Shortcut::Rk4Quaternion);
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    #[inline(always)]
    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [stage] = work.buffers();
        let q0 = model.attitude(from).into_inner();
        let k1 = model.rates(t, from)?;
        let d1 = rate_of(&model.spin_of(&k1), &q0) * (h / 2.0); // (1)
        let q2 = q0 + d1;
        let (k2, d2) = model.rates_at_stage(t + h / 2.0, (from, h / 2.0, &k1), (&q2, h / 2.0), stage)?; // (2)
        let q3 = q0 + d2;
        let (k3, d3) = model.rates_at_stage(t + h / 2.0, (from, h / 2.0, &k2), (&q3, h), stage)?; // (3)
        let q4 = q0 + d3;
        let (k4, d4) = model.rates_at_stage(t + h, (from, h, &k3), (&q4, h / 6.0), stage)?; // (4)
        let mean = (k1 + k2 * 2.0 + k3 * 2.0 + k4).scaled(M::Real::ratio(1.0, 6.0));
        let q1 = (q0 + (d1 + d2 * M::Real::of(2.0) + d3) * M::Real::ratio(1.0, 3.0)) + d4;
        hold(model, from, h, &mean, unit(&q1), to); // (5)
        Ok(())
    }
}
