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

use nalgebra::{Matrix3, Vector3};

use super::families::{KICKS, claims};
use super::multipliers::orthogonal;
use super::small::{product, scaled_columns};
use super::splitting::kick_turn_kick;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational, Turning};
use crate::rotation::{Rotation, from_matrix};

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
        kick_turn_kick(constrained_turn, model, step) // (1), (4), (5)
    }
}

/// F of a step.
fn constrained_turn<T: Real>(
    body: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    let second = Vector3::repeat(body.moments.sum() / 2.0) - body.moments;
    let d = Matrix3::from_diagonal(&second);
    let inverse = second.map(|x| T::one() / x);
    let free = d + momentum.cross_matrix() * (h / 2.0);
    let line = |multipliers: &Matrix3<T>| scaled_columns(&(free + multipliers), &inverse); // (2)
    let excess = |f: &Matrix3<T>| product(&f.transpose(), f) - Matrix3::identity(); // (3)
    orthogonal(line, excess, &inverse).map(|f| from_matrix(&f))
}

#[cfg(test)]
mod tests {
    use super::super::multipliers::tests::free_body;
    use super::*;

    /// What a turn in a second leaves of F D − D Fᵀ = h m̂, over D, for a free body with these moments and this spin.
    fn left(moments: [f64; 3], spin: &Vector3<f64>) -> f64 {
        let model = free_body(moments);
        let moments = Vector3::from(moments);
        let (momentum, second) =
            (moments.component_mul(spin), Vector3::repeat(moments.sum() / 2.0) - moments);
        let turn = constrained_turn(model.rotational(), &momentum, 1.0).expect("a turn");
        let product = turn.to_rotation_matrix().into_inner() * Matrix3::from_diagonal(&second);
        (product - product.transpose() - momentum.cross_matrix()).amax() / second.amax()
    }

    #[test]
    fn multipliers_hold_a_turn_to_its_equation_to_rounding() {
        // A solid body, a long one, and one so nearly flat that rounding leaves more than eight units in the nine entries.
        for moments in [[1.0, 1.5, 2.25], [26.0, 26.0, 1.0], [1.0, 1.0, 1.98]] {
            for k in 0..200 {
                let angle = f64::from(k) * 1.5e-3;
                let left = left(moments, &(Vector3::new(0.6, -0.48, 0.64) * angle));
                // Measured: 4.2e-16.
                assert!(left < 3.0 * f64::EPSILON, "{moments:?}, {angle} rad: {left:e}");
            }
        }
    }
}
