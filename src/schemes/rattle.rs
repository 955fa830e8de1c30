//! RATTLE on the nine entries of the rotation matrix, held orthogonal by multipliers.
//!
//! With D = ½ tr I − I, the second moments of the mass about principal axes, F = R₀ᵀ R₁ and Σ the symmetric matrix of the
//! multipliers:
//!
//! (1)  L½ = L₀ + h/2 τ₀,  U½ = U₀ + h/2 F₀/M,  X₁ = X₀ + h U½,  m = R₀ᵀ L½
//! (2)  F = (D + h/2 m̂ + Σ) D⁻¹                           a straight line in the space of all matrices, and Σ
//! (3)  Fᵀ F = E                                          solved for Σ by Newton's method
//! (4)  R₁ = R₀ F
//! (5)  L₁ = L½ + h/2 τ₁,  U₁ = U½ + h/2 F₁/M             the multipliers of the velocities have no torque
//!
//! (2) needs three second moments that are not zero: no plates. The skew part of F D is (1) of the discrete Moser–Veselov
//! equation, F D − D Fᵀ = h m̂, whose solution by quaternions is another way to the same step.
//!
//! Source: mclachlan1995. Order 2, symplectic, symmetric; L constant without torque.

use super::families::{KICKS, claims};
use super::multipliers::constrained_turn;
use super::splitting::kick_turn_kick;
use super::{Card, Step, TurningScheme};
use crate::model::{Broken, Turning};

/// RATTLE on the rotation matrix.
#[derive(Clone, Copy, Debug)]
pub struct Rattle;

impl TurningScheme for Rattle {
    fn card(&self) -> Card {
        Card {
            name: "rattle",
            title: "RATTLE: the rotation matrix under constraints",
            family: "geometric",
            source: "mclachlan1995",
            claims: claims![KICKS; Energy(Constant), FlipTimes],
        }
    }
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;
    const TAKES_PLATES: bool = false;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        kick_turn_kick(constrained_turn, model, step) // (1)–(5)
    }
}
