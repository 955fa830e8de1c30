//! The symmetric matrix of multipliers that holds nine entries to a rotation, by Newton's method: (2) and (3) of RATTLE.
//!
//! (2)  F = (D + h/2 m̂ + Σ) D⁻¹,  D = ½ tr I − I
//! (3)  Fᵀ F = E

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::iteration::tolerance;
use crate::arithmetic::Real;
use crate::model::{Broken, Rotational};
use crate::rotation::{Rotation, from_matrix};

/// Newton's iterations allowed.
const ITERATIONS: u32 = 30;
/// Entries of a symmetric matrix.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// F of the step, from m and h.
///
/// # Errors
/// [`Broken::NoConvergence`] where h |m| is too large.
pub(super) fn constrained_turn<T: Real>(
    body: &Rotational<T>,
    momentum: &Vector3<T>,
    h: T,
) -> Result<Rotation<T>, Broken> {
    let second = Vector3::repeat(body.moments.sum() / 2.0) - body.moments;
    let (d, inverse) =
        (Matrix3::from_diagonal(&second), Matrix3::from_diagonal(&second.map(|x| T::one() / x)));
    let free = d + momentum.cross_matrix() * (h / 2.0);
    let mut multipliers = Matrix3::zeros();
    let (orthogonal, tolerance) = (8.0 * T::UNIT, tolerance::<T>());
    let mut residual = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let f = (free + multipliers) * inverse; // (2)
        let excess = f.transpose() * f - Matrix3::identity(); // (3)
        let last = residual;
        residual = excess.amax().to_f64();
        if residual <= orthogonal || (residual <= tolerance && residual >= last) {
            return Ok(from_matrix(&f));
        }
        let mut slope = Matrix6::zeros();
        for (column, (i, j)) in ENTRIES.into_iter().enumerate() {
            let mut unit = Matrix3::zeros();
            (unit[(i, j)], unit[(j, i)]) = (T::one(), T::one());
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
    Err(Broken::NoConvergence { iterations: ITERATIONS, residual, tolerance: orthogonal })
}

fn entries<T: Real>(symmetric: &Matrix3<T>) -> Vector6<T> {
    Vector6::from_iterator(ENTRIES.into_iter().map(|entry| symmetric[entry]))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::model::body::Body;
    use crate::model::{AnyModel, Free, Spin, System, Turning};

    /// A free body with these moments, at rest.
    pub(in crate::schemes) fn free_body(moments: [f64; 3]) -> Free {
        let inertia = Matrix3::from_diagonal(&Vector3::from(moments));
        let body = Body::from_inertia(1.0, inertia, None, false).expect("a body");
        let zero = Vector3::zeros();
        let system = System::new(body, Vec::new(), zero, Rotation::identity(), zero, Spin::Velocity(zero))
            .expect("a system");
        match system.least() {
            AnyModel::Free(model) => model,
            other => panic!("no free body: {}", other.name()),
        }
    }

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
