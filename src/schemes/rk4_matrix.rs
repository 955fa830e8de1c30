//! The classical fourth-order Runge–Kutta method on the nine entries of the rotation matrix A and on L, with A made
//! orthonormal again after the step.
//!
//! With y = (A, X_cm, U_cm, L) and Ȧ = [Ω]× A, Ω and forces at the attitude N(A), where N is Gram and Schmidt's
//! process from the first column on:
//!
//! (1)  k₁ = f(t, y₀)
//! (2)  k₂ = f(t + h/2, y₀ + h/2 k₁)
//! (3)  k₃ = f(t + h/2, y₀ + h/2 k₂)
//! (4)  k₄ = f(t + h, y₀ + h k₃)
//! (5)  y₁ = y₀ + h (k₁ + 2 k₂ + 2 k₃ + k₄)/6, then A₁ = N(A₁)
//!
//! Source: kutta1901. Fourth order; L constant without torque; the energy of a free body drifts.

use nalgebra::Matrix3;

use super::families::{BALLISTIC, claims};
use super::small::product;
use super::vector_form::{hold, orthonormal};
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Rates, Turning};
use crate::rotation;

/// The classical Runge–Kutta method on a rotation matrix.
#[derive(Clone, Copy, Debug)]
pub struct Rk4Matrix;

impl TurningScheme for Rk4Matrix {
    fn card(&self) -> Card {
        Card {
            name: "rk4-matrix",
            title: "classical Runge-Kutta on rotation matrix and L, re-orthonormalised",
            family: "classical",
            source: "kutta1901",
            claims: claims![BALLISTIC; Order(4), Energy(Secular { rate_order: 5 }), Rigid, Evaluations(4)],
        }
    }
    const STATES: usize = 1;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [stage] = work.buffers();
        let two = M::Real::of(2.0);
        let a0 = model.attitude(from).to_rotation_matrix().into_inner();
        let turned =
            |rates: &M::Rates, a: &Matrix3<M::Real>| product(&model.spin_of(rates).cross_matrix(), a);
        let place = |s: M::Real, rates: &M::Rates, a: &Matrix3<M::Real>, into: &mut M::State| {
            hold(model, from, s, rates, rotation::from_matrix(&orthonormal(a)), into);
        };
        let k1 = model.rates(t, from)?; // (1)
        let p1 = turned(&k1, &a0);
        let a2 = a0 + p1 * (h / 2.0);
        place(h / 2.0, &k1, &a2, stage);
        let k2 = model.rates(t + h / 2.0, stage)?; // (2)
        let p2 = turned(&k2, &a2);
        let a3 = a0 + p2 * (h / 2.0);
        place(h / 2.0, &k2, &a3, stage);
        let k3 = model.rates(t + h / 2.0, stage)?; // (3)
        let p3 = turned(&k3, &a3);
        let a4 = a0 + p3 * h;
        place(h, &k3, &a4, stage);
        let k4 = model.rates(t + h, stage)?; // (4)
        let p4 = turned(&k4, &a4);
        let mean = (k1 + k2 * 2.0 + k3 * 2.0 + k4).scaled(M::Real::ratio(1.0, 6.0));
        place(h, &mean, &(a0 + (p1 + p2 * two + p3 * two + p4) * (h / 6.0)), to); // (5)
        Ok(())
    }
}
