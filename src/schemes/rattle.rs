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

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::splitting::kick_turn_kick;
use super::{Card, TurningScheme, Workspace};
use crate::claim::{Claim, EnergyOfFreeBody, Quantity, When};
use crate::model::{Broken, Rotational, Turning};
use crate::rotation::{Rotation, from_matrix};

/// RATTLE on the rotation matrix.
#[derive(Clone, Copy, Debug)]
pub struct Rattle;

/// Newton's iterations allowed.
const ITERATIONS: u32 = 30;
/// A deviation from orthogonality that is rounding.
const ORTHOGONAL: f64 = 8.0 * f64::EPSILON;
/// Entries of a symmetric matrix.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

impl TurningScheme for Rattle {
    const CARD: Card = Card {
        name: "rattle",
        title: "RATTLE: the rotation matrix under constraints",
        family: "geometric",
        source: "mclachlan1995",
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
    };
    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;
    const TAKES_PLATES: bool = false;

    fn step<M: Turning>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        kick_turn_kick(constrained_turn, model, (t, h), from, to, work) // (1), (4), (5)
    }
}

/// Solves (2) and (3).
fn constrained_turn(body: &Rotational, momentum: &Vector3<f64>, h: f64) -> Result<Rotation, Broken> {
    let second = Vector3::repeat(body.moments.sum() / 2.0) - body.moments;
    let (d, inverse) = (Matrix3::from_diagonal(&second), Matrix3::from_diagonal(&second.map(|x| 1.0 / x)));
    let free = d + momentum.cross_matrix() * (h / 2.0);
    let mut multipliers = Matrix3::zeros();
    let mut residual = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let f = (free + multipliers) * inverse; // (2)
        let excess = f.transpose() * f - Matrix3::identity(); // (3)
        let last = residual;
        residual = excess.amax();
        if residual <= ORTHOGONAL || (residual <= 1e-12 && residual >= last) {
            return Ok(from_matrix(&f));
        }
        let mut slope = Matrix6::zeros();
        for (column, (i, j)) in ENTRIES.into_iter().enumerate() {
            let mut unit = Matrix3::zeros();
            (unit[(i, j)], unit[(j, i)]) = (1.0, 1.0);
            let half = inverse * unit * f;
            slope.set_column(column, &entries(&(half + half.transpose())));
        }
        let Some(change) = slope.lu().solve(&entries(&excess)) else { return Err(Broken::Singular) };
        for (k, (i, j)) in ENTRIES.into_iter().enumerate() {
            multipliers[(i, j)] -= change[k];
            if i != j {
                multipliers[(j, i)] -= change[k];
            }
        }
    }
    Err(Broken::NoConvergence { iterations: ITERATIONS, residual, tolerance: ORTHOGONAL })
}

fn entries(symmetric: &Matrix3<f64>) -> Vector6<f64> {
    Vector6::from_iterator(ENTRIES.into_iter().map(|entry| symmetric[entry]))
}
