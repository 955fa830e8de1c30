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
//! Source: kutta1901. Fourth order; L constant without torque; the energy of a free body drifts.

use nalgebra::Quaternion;

use super::vector_form::{hold, quaternion_rate};
use super::{Card, TurningScheme, Workspace};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Turning};
use crate::rotation::Rotation;

/// The classical Runge–Kutta method on a quaternion.
#[derive(Clone, Copy, Debug)]
pub struct Rk4Quaternion;

impl TurningScheme for Rk4Quaternion {
    const CARD: Card = Card {
        name: "rk4-quaternion",
        title: "classical Runge-Kutta on quaternion and L",
        family: "classical",
        source: "kutta1901",
        claims: &[
            Claim::Order(4),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::Exact(Quantity::AngularVelocity, When::SteadySpin),
            Claim::VerticalMomentum,
            Claim::Rigid,
            Claim::Evaluations(4),
            Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 5 }),
            Claim::Equivariant,
        ],
    };
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        let stage = &mut work.states[0];
        let q0 = model.attitude(from).into_inner();
        let place = |s: f64, rates: &M::Rates, q: Quaternion<f64>, into: &mut M::State| {
            hold(model, from, s, rates, Rotation::new_normalize(q), into);
        };
        let k1 = model.rates(t, from)?; // (1)
        let p1 = quaternion_rate(&model.spin_of(&k1), &q0);
        let q2 = q0 + p1 * (h / 2.0);
        place(h / 2.0, &k1, q2, stage);
        let k2 = model.rates(t + h / 2.0, stage)?; // (2)
        let p2 = quaternion_rate(&model.spin_of(&k2), &q2);
        let q3 = q0 + p2 * (h / 2.0);
        place(h / 2.0, &k2, q3, stage);
        let k3 = model.rates(t + h / 2.0, stage)?; // (3)
        let p3 = quaternion_rate(&model.spin_of(&k3), &q3);
        let q4 = q0 + p3 * h;
        place(h, &k3, q4, stage);
        let k4 = model.rates(t + h, stage)?; // (4)
        let p4 = quaternion_rate(&model.spin_of(&k4), &q4);
        let mean = (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (1.0 / 6.0);
        place(h, &mean, q0 + (p1 + p2 * 2.0 + p3 * 2.0 + p4) * (h / 6.0), to); // (5)
        Ok(())
    }
}
