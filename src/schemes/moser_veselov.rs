//! The discrete Moser–Veselov equation in quaternions, and a kick.
//!
//! With q = (q₀, v) the turn of a step, q₀ = √(1 − |v|²), and l in principal axes:
//!
//! (1)  q₀ I v + v × I v = h l / 2             solved for v by Newton's iteration, from v = h I⁻¹ l / 2
//! (2)  q₀ I v − v × I v = h l₁ / 2            holds with l₁ = Qᵀ l, so that l·I⁻¹l and |l| are kept exactly
//!
//! (1) is F D − D Fᵀ = h l̂ for F the matrix of q and D = ½ tr I − I. There is no solution where h |l| is too large.
//!
//! Source: moser1991; mclachlan2005 as an integrator; the quaternion form after hairer2006mv. Order 2, symplectic,
//! symmetric; a free body keeps energy and |L| to rounding, and its steady spins are too fast by (hΩ)²/6.

use nalgebra::{Matrix3, Vector3};

use super::Card;
use super::splitting::splitting;
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Rotational};
use crate::rotation::Rotation;

/// Newton's iterations allowed.
const ITERATIONS: u32 = 30;
/// A correction below this one squares to less than rounding.
const CORRECTION: f64 = 1e-10;

splitting! {
    /// Discrete Moser–Veselov and a kick.
    MoserVeselov, free_turn, Card {
        name: "moser-veselov",
        title: "Discrete Moser-Veselov equation and a kick",
        family: "geometric",
        source: "moser1991; mclachlan2005",
        claims: &[
            Claim::Order(2),
            Claim::Exact(Quantity::Velocity, When::ConstantForce),
            Claim::Exact(Quantity::Position, When::ConstantForce),
            Claim::Exact(Quantity::AngularMomentum, When::NoTorque),
            Claim::VerticalMomentum,
            Claim::FlipTimes,
            Claim::Rigid,
            Claim::Evaluations(1),
            Claim::Energy(EnergyOfFreeBody::Constant),
            Claim::Reversible,
            Claim::Symplectic,
            Claim::Equivariant,
        ],
    }
}

#[inline]
fn free_turn(rotational: &Rotational, momentum: &Vector3<f64>, h: f64) -> Result<Rotation, Broken> {
    discrete_turn(&rotational.moments, momentum, h)
}

/// Solves (1).
#[inline]
pub(super) fn discrete_turn(
    moments: &Vector3<f64>,
    momentum: &Vector3<f64>,
    h: f64,
) -> Result<Rotation, Broken> {
    let scale = moments.amax();
    let inertia = Matrix3::from_diagonal(&(moments / scale));
    let right = momentum * (0.5 * h / scale);
    let mut v = right.component_div(&inertia.diagonal());
    let mut residual = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let real = (1.0 - v.norm_squared()).sqrt();
        let turned = inertia * v;
        let left = turned * real + v.cross(&turned); // (1)
        residual = (left - right).norm();
        let slope = inertia * real - turned * v.transpose() / real + v.cross_matrix() * inertia
            - turned.cross_matrix();
        let Some(inverse) = slope.try_inverse() else { break };
        let correction = inverse * (right - left);
        v += correction;
        if correction.norm() <= CORRECTION * v.norm() {
            return Ok(Rotation::new_unchecked(nalgebra::Quaternion::from_parts(
                (1.0 - v.norm_squared()).sqrt(),
                v,
            )));
        }
    }
    Err(Broken::NoConvergence { iterations: ITERATIONS, residual, tolerance: CORRECTION })
}
