//! The symmetric matrix of multipliers that holds nine entries to a rotation, by Newton's method.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use super::iteration::tolerance;
use super::small::solved;
use crate::arithmetic::Real;
use crate::model::Broken;

/// Newton's iterations allowed.
const ITERATIONS: u32 = 30;
/// Entries of a symmetric matrix.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// F = `line`(Σ) whose `excess`, Fᵀ F − E, is zero. `inverse` is the diagonal that ∂F/∂Σ multiplies by from the right.
///
/// # Errors
/// [`Broken::NoConvergence`] where the line does not come near a rotation.
pub(super) fn orthogonal<T: Real>(
    line: impl Fn(&Matrix3<T>) -> Matrix3<T>,
    excess: impl Fn(&Matrix3<T>) -> Matrix3<T>,
    inverse: &Vector3<T>,
) -> Result<Matrix3<T>, Broken> {
    let mut multipliers = Matrix3::zeros();
    let (orthogonal, tolerance) = (8.0 * T::UNIT, tolerance::<T>());
    let mut residual = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let f = line(&multipliers);
        let excess = excess(&f);
        let last = residual;
        residual = excess.amax().to_f64();
        if residual <= orthogonal || (residual <= tolerance && residual >= last) {
            return Ok(f);
        }
        let mut slope = Matrix6::zeros();
        for (column, (i, j)) in ENTRIES.into_iter().enumerate() {
            // D⁻¹ E F, where E is one in these two entries.
            let mut half = Matrix3::zeros();
            for k in 0..3 {
                (half[(i, k)], half[(j, k)]) = (inverse[i] * f[(j, k)], inverse[j] * f[(i, k)]);
            }
            slope.set_column(column, &entries(&(half + half.transpose())));
        }
        let Some(change) = solved(slope, entries(&excess)) else { return Err(Broken::Singular) };
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
    use nalgebra::{Matrix3, Vector3};

    use crate::model::body::Body;
    use crate::model::{AnyModel, Free, Spin, System};
    use crate::rotation::Rotation;

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
}
