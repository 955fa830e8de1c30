//! Gauss and Legendre's implicit Runge–Kutta method of two stages, on the quaternion and L as plain numbers.
//!
//! (1)  y_i = y₀ + h Σ a_ij f(t + c_j h, y_j)
//! (2)  y₁ = y₀ + h Σ b_j f(t + c_j h, y_j)
//!
//! c = ½ ∓ √3/6,  b = ½ ½
//! A = | ¼         ¼ − √3/6 |
//!     | ¼ + √3/6  ¼        |
//!
//! with q̇ = ½ Ω q. Solved by fixed-point iteration. Source: butcher1964. Fourth order; |q| is a quadratic invariant,
//! which the method keeps; L constant without torque.

use super::collocation::{self, Tableau};
use super::families::{IMPLICIT, claims};
use super::{Card, Step, TurningScheme};
use nalgebra::ComplexField;

use crate::arithmetic::Real;
use crate::model::{Broken, Turning};

/// Gauss–Legendre of order 4.
#[derive(Clone, Copy, Debug)]
pub struct GaussLegendre4;

impl TurningScheme for GaussLegendre4 {
    fn card(&self) -> Card {
        Card {
            name: "gauss-legendre-4",
            title: "Gauss-Legendre, two stages, on quaternion and L",
            family: "geometric",
            source: "butcher1964",
            claims: claims![IMPLICIT; Order(4), Energy(Bounded)],
        }
    }
    const STATES: usize = 3;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        let root = M::Real::of(3.0).sqrt();
        let part = M::Real::ratio;
        let tableau = Tableau {
            matrix: [
                [part(1.0, 4.0), part(1.0, 4.0) - root / 6.0],
                [part(1.0, 4.0) + root / 6.0, part(1.0, 4.0)],
            ],
            weights: [part(1.0, 2.0); 2],
            nodes: [part(1.0, 2.0) - root / 6.0, part(1.0, 2.0) + root / 6.0],
        };
        collocation::step(&tableau, model, step) // (1), (2)
    }
}
