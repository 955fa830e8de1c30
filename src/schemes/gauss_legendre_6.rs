//! Gauss and Legendre's implicit Runge–Kutta method of three stages, on the quaternion and L as plain numbers.
//!
//! (1)  y_i = y₀ + h Σ a_ij f(t + c_j h, y_j)
//! (2)  y₁ = y₀ + h Σ b_j f(t + c_j h, y_j)
//!
//! c = ½ − √15/10  ½  ½ + √15/10,  b = 5/18  4/9  5/18
//! A = | 5/36            2/9 − √15/15   5/36 − √15/30 |
//!     | 5/36 + √15/24   2/9            5/36 − √15/24 |
//!     | 5/36 + √15/30   2/9 + √15/15   5/36          |
//!
//! with q̇ = ½ Ω q. Solved by fixed-point iteration. Source: butcher1964. Sixth order; |q| is a quadratic invariant,
//! which the method keeps; L constant without torque.

use super::collocation::{self, Tableau};
use super::families::{IMPLICIT, claims};
use super::{Card, Step, TurningScheme};
use nalgebra::ComplexField;

use crate::arithmetic::Real;
use crate::model::{Broken, Turning};

/// Gauss–Legendre of order 6.
#[derive(Clone, Copy, Debug)]
pub struct GaussLegendre6;

impl TurningScheme for GaussLegendre6 {
    fn card(&self) -> Card {
        Card {
            name: "gauss-legendre-6",
            title: "Gauss-Legendre, three stages, on quaternion and L",
            family: "geometric",
            source: "butcher1964",
            claims: claims![IMPLICIT; Order(6)],
        }
    }
    const STATES: usize = 4;
    const TAKES_VELOCITY_FORCES: bool = true;
    const TAKES_RODS: bool = true;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        let root = M::Real::of(15.0).sqrt();
        let part = M::Real::ratio;
        let tableau = Tableau {
            matrix: [
                [part(5.0, 36.0), part(2.0, 9.0) - root / 15.0, part(5.0, 36.0) - root / 30.0],
                [part(5.0, 36.0) + root / 24.0, part(2.0, 9.0), part(5.0, 36.0) - root / 24.0],
                [part(5.0, 36.0) + root / 30.0, part(2.0, 9.0) + root / 15.0, part(5.0, 36.0)],
            ],
            weights: [part(5.0, 18.0), part(4.0, 9.0), part(5.0, 18.0)],
            nodes: [part(1.0, 2.0) - root / 10.0, part(1.0, 2.0), part(1.0, 2.0) + root / 10.0],
        };
        collocation::step(&tableau, model, step) // (1), (2)
    }
}
