//! Whether a ladder is one of two terms, or of a single power.

use nalgebra::{Matrix3, Vector3};

use super::{SLOPES_AGREE, fit_power};

/// What two terms may leave unexplained, over the 0.15 that tell a slope from a wrong one.
const UNEXPLAINED: f64 = 0.2;

/// How far a ladder is from a leading term of order p and the next one, as a root mean square over what may be left unexplained and
/// what else an error may be off by; below one they explain it. e = |a hᵖ + b hᵖ⁺¹| with vectors a and b, so that
///
/// ```text
/// (e/hᵖ)² = |a|² + 2 a·b h + |b|² h²
/// ```
///
/// Pairwise slopes of such a ladder come to p from above where b leads, and from anywhere where the two nearly cancel.
///
/// What is left over would bend the slope by s = δ √n / √Σ(ln h − mean)² at most, δ being its root mean square: all of it a slope.
/// Unexplained may be a fifth of the 0.15 that tell slopes apart, δ = 0.012 over four halvings of √2, 0.035 over six of 2.
///
/// `ladder` holds (step, error, relative error of that error). `None` where the term of order p would be none: |a|² ≤ 0.
pub fn misfit(ladder: &[(f64, f64, f64)], order: u32) -> Option<f64> {
    let (coarsest, ..) = ladder.first()?;
    let explained = UNEXPLAINED * SLOPES_AGREE * deviation_of_steps(ladder);
    // Least squares of the residual, relative, over what each rung may be off by: the square of an error by twice as much.
    let rows: Vec<(Vector3<f64>, f64)> = ladder
        .iter()
        .map(|(h, e, off)| {
            let (x, weight) = (h / coarsest, 0.5 / (explained + off));
            (Vector3::new(1.0, x, x * x) * (weight / (e / x.powi(order as i32)).powi(2)), weight)
        })
        .collect();
    let normal: Matrix3<f64> = rows.iter().map(|(row, _)| row * row.transpose()).sum();
    let scale = Matrix3::from_diagonal(&normal.diagonal().map(|x| 1.0 / x.sqrt()));
    let sum: Vector3<f64> = rows.iter().map(|(row, weight)| row * *weight).sum();
    let terms = scale * (scale * normal * scale).lu().solve(&(scale * sum))?;
    let residual = rows.iter().map(|(row, weight)| (row.dot(&terms) - weight).powi(2)).sum::<f64>();
    (terms.x > 0.0).then(|| (residual / rows.len() as f64).sqrt())
}

/// Standard deviation of ln h.
fn deviation_of_steps(ladder: &[(f64, f64, f64)]) -> f64 {
    let count = ladder.len() as f64;
    let mean = ladder.iter().map(|(h, ..)| h.ln()).sum::<f64>() / count;
    (ladder.iter().map(|(h, ..)| (h.ln() - mean).powi(2)).sum::<f64>() / count).sqrt()
}

/// How far a ladder is from a single power of h, in the measure of [`misfit`]. Two terms that explain no more than that are not seen.
pub fn misfit_of_a_power(ladder: &[(f64, f64, f64)]) -> Option<f64> {
    let points: Vec<(f64, f64)> = ladder.iter().map(|(h, e, _)| (*h, *e)).collect();
    let slope = fit_power(&points)?.slope;
    let explained = UNEXPLAINED * SLOPES_AGREE * deviation_of_steps(ladder);
    let count = ladder.len() as f64;
    let of_power = |(h, e): &(f64, f64)| e.ln() - slope * h.ln();
    let mean = points.iter().map(of_power).sum::<f64>() / count;
    let left = points
        .iter()
        .zip(ladder)
        .map(|(point, rung)| ((of_power(point) - mean) / (explained + rung.2)).powi(2));
    Some((left.sum::<f64>() / count).sqrt())
}
