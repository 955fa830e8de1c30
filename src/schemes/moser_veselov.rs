//! The discrete Moser–Veselov equation in quaternions, and a kick.
//!
//! With q = (q₀, v) the turn of a step, q₀ = √(1 − |v|²), and l in principal axes:
//!
//! (1)  q₀ I v + v × I v = h l / 2             solved for v by Newton's iteration, from v = h I⁻¹ l / 2
//! (2)  q₀ I v − v × I v = h l₁ / 2            holds with l₁ = Qᵀ l, so that l·I⁻¹l and |l| are kept exactly
//!
//! Preprocessed, the equation is solved with the moments Ĩ of [`preprocessing`](super::preprocessing) in place of I: for a free body of order
//! 2 + 2 m, with m polynomials of the series.
//!
//! (1) is F D − D Fᵀ = h l̂ for F the matrix of q and D = ½ tr I − I. There is no solution where h |l| is too large.
//!
//! Source: moser1991; mclachlan2005 as an integrator; the quaternion form and the preprocessing after hairer2006mv. Order 2, symplectic,
//! symmetric; a free body keeps energy and |L| to rounding, and its steady spins are too fast by (hΩ)²/6.

use nalgebra::{Matrix3, Vector3};

use super::families::{BALLISTIC, KICKS, claims};
use super::preprocessing::preprocessed;
use super::small::{outer, scaled_columns};
use super::splitting::kick_turn_kick;
use super::{Card, Step, TurningScheme};
use crate::arithmetic::Real;
use crate::claim::Claim;
use crate::model::{Broken, Turning};
use crate::rotation::{Rotation, applied};

/// Newton's iterations allowed.
const ITERATIONS: u32 = 30;

/// A correction below this one squares to less than rounding.
fn correction<T: Real>() -> f64 {
    1e-10 * (T::UNIT / f64::EPSILON).sqrt()
}

/// Discrete Moser–Veselov and a kick.
#[derive(Clone, Copy, Debug)]
pub struct MoserVeselov {
    /// Polynomials of the preprocessing.
    terms: usize,
    name: &'static str,
    title: &'static str,
    source: &'static str,
    claims: &'static [Claim],
}

/// What the preprocessed equation promises, whatever the number of polynomials.
const PREPROCESSED: &[Claim] = claims![BALLISTIC; Order(2), Rigid, Evaluations(1)];

impl MoserVeselov {
    /// The equation as it stands.
    pub const PLAIN: MoserVeselov = MoserVeselov {
        terms: 0,
        name: "moser-veselov",
        title: "Discrete Moser-Veselov equation and a kick",
        source: "moser1991; mclachlan2005",
        claims: claims![KICKS; Energy(Constant), FlipTimes],
    };
    /// Preprocessed to order 4.
    pub const FOUR: MoserVeselov = MoserVeselov::preprocessed(
        1,
        "moser-veselov-4",
        "Moser-Veselov preprocessed to order 4, and a kick",
        claims![PREPROCESSED; OrderWithoutTorque(4)],
    );
    /// Preprocessed to order 6.
    pub const SIX: MoserVeselov = MoserVeselov::preprocessed(
        2,
        "moser-veselov-6",
        "Moser-Veselov preprocessed to order 6, and a kick",
        claims![PREPROCESSED; OrderWithoutTorque(6)],
    );
    /// Preprocessed to order 8.
    pub const EIGHT: MoserVeselov = MoserVeselov::preprocessed(
        3,
        "moser-veselov-8",
        "Moser-Veselov preprocessed to order 8, and a kick",
        claims![PREPROCESSED; OrderWithoutTorque(8)],
    );
    /// Preprocessed to order 10.
    pub const TEN: MoserVeselov = MoserVeselov::preprocessed(
        4,
        "moser-veselov-10",
        "Moser-Veselov preprocessed to order 10, and a kick",
        claims![PREPROCESSED; OrderWithoutTorque(10)],
    );

    const fn preprocessed(
        terms: usize,
        name: &'static str,
        title: &'static str,
        claims: &'static [Claim],
    ) -> MoserVeselov {
        MoserVeselov { terms, name, title, source: "hairer2006mv", claims }
    }
}

impl TurningScheme for MoserVeselov {
    fn card(&self) -> Card {
        let MoserVeselov { name, title, source, claims, .. } = *self;
        Card { name, title, family: "geometric", source, claims }
    }

    const STATES: usize = 0;
    const TAKES_VELOCITY_FORCES: bool = false;
    const TAKES_RODS: bool = false;

    fn step<M: Turning>(&self, model: &M, step: Step<M>) -> Result<(), Broken> {
        kick_turn_kick(
            |body, momentum, h| {
                let moments = preprocessed(&body.moments, momentum, h, self.terms);
                discrete_turn(&moments, momentum, h)
            },
            model,
            step,
        )
    }
}

/// Solves (1).
#[inline]
fn discrete_turn<T: Real>(moments: &Vector3<T>, momentum: &Vector3<T>, h: T) -> Result<Rotation<T>, Broken> {
    let scale = moments.amax();
    let moments = moments / scale;
    let right = momentum * (h * 0.5 / scale);
    let mut v = right.component_div(&moments);
    let mut residual = T::of(f64::INFINITY);
    let smallest = correction::<T>();
    for _ in 0..ITERATIONS {
        let real = (T::one() - v.norm_squared()).sqrt();
        let turned = moments.component_mul(&v);
        let left = turned * real + v.cross(&turned); // (1)
        residual = (left - right).norm();
        let slope = Matrix3::from_diagonal(&(moments * real)) - outer(&turned, &v) / real
            + scaled_columns(&v.cross_matrix(), &moments)
            - turned.cross_matrix();
        let Some(inverse) = slope.try_inverse() else { break };
        let correction = applied(&inverse, &(right - left));
        v += correction;
        if correction.norm() <= v.norm() * smallest {
            return Ok(Rotation::new_unchecked(nalgebra::Quaternion::from_parts(
                (T::one() - v.norm_squared()).sqrt(),
                v,
            )));
        }
    }
    Err(Broken::NoConvergence { iterations: ITERATIONS, residual: residual.to_f64(), tolerance: smallest })
}
