//! Moments of inertia with which the discrete Moser–Veselov equation moves a free body as the true moments would.
//!
//! The equation keeps l·I⁻¹l and |l|, so its modified Hamiltonian is a function of H = ½ l·I⁻¹l and C = |l|². With
//! η = H/C, x = h² C and e₁, e₂, e₃ the elementary symmetric functions of ηⱼ = 1/(2 Iⱼ):
//!
//! (1)  K(H, C) = C [η + x k₁(η) + x² k₂(η) + x³ k₃(η) + x⁴ k₄(η) + …],   kₘ a polynomial of degree m + 1
//! (2)  on a steady spin about axis j, η = ηⱼ:      sin(h ∂K/∂|l|) = h |l|/Iⱼ
//! (3)  small oscillations about it:                tan(h ν/2) = κ tan(h ω/2),  κ² = (Iⱼ − Iₖ)(Iⱼ − Iₗ)/(Iₖ Iₗ)
//!
//! (2) fixes kₘ and (3) its slope at three nodes, six conditions: enough for degree 5, m = 4. The equation with
//! other moments 1/Ĩⱼ = σ/Iⱼ + 2 δ, so with nodes σ ηⱼ + δ and η̃ = σ η + δ, moves along the same curve, as the body does
//! where
//!
//! (4)  σ ∂K̃/∂H = 1,   δ ∂K̃/∂H + ∂K̃/∂C = 0          an iteration from σ = 1, δ = 0 gains two orders in h each time
//!
//! Source: hairer2006mv, whose series (4) solves; (1)–(3) are derived here, the polynomials from (2) and (3).

use nalgebra::Vector3;

use crate::arithmetic::Real;

/// kₘ(η) and its slope, for m = 1 … 4.
fn polynomial<T: Real>(m: usize, e: T, [e1, e2, e3]: [T; 3]) -> (T, T) {
    let zero = T::zero();
    let coefficients = match m {
        1 => [e3, -e2, e1, zero, zero, zero].map(|c| c / 3.0),
        2 => [-e2 * e3, e1 * 2.0 * e3 + e2 * e2, e3 * 2.0 - e1 * 3.0 * e2, e1 * 2.0 * e1 - e2, zero, zero]
            .map(|c| c / 5.0),
        3 => [
            e1 * e3 * e3 + e2 * e2 * e3,
            e3 * 4.0 * e3 - e1 * 6.0 * e2 * e3 - e2 * e2 * e2,
            e1 * 6.0 * e1 * e3 + e1 * 6.0 * e2 * e2 - e2 * 9.0 * e3,
            e1 * 8.0 * e3 + e2 * 4.0 * e2 - e1 * 10.0 * e1 * e2,
            e1 * 5.0 * e1 * e1 - e1 * 5.0 * e2 + e3,
            zero,
        ]
        .map(|c| c / 7.0),
        _ => [
            e3 * 2.0 * e3 * e3 - e1 * 3.0 * e2 * e3 * e3 - e2 * e2 * e2 * e3,
            e1 * 6.0 * e1 * e3 * e3 + e1 * 12.0 * e2 * e2 * e3 + e2.powi(4) - e2 * 15.0 * e3 * e3,
            e1 * 24.0 * e3 * e3 + e2 * 24.0 * e2 * e3 - e1 * 30.0 * e1 * e2 * e3 - e1 * 10.0 * e2.powi(3),
            e1.powi(3) * 20.0 * e3 + e1 * 30.0 * e1 * e2 * e2 - e1 * 60.0 * e2 * e3 - e2.powi(3) * 10.0
                + e3 * 12.0 * e3,
            e1 * 30.0 * e1 * e3 + e1 * 30.0 * e2 * e2 - e1.powi(3) * 35.0 * e2 - e2 * 15.0 * e3,
            e1.powi(4) * 14.0 - e1 * 21.0 * e1 * e2 + e1 * 6.0 * e3 + e2 * 3.0 * e2,
        ]
        .map(|c| c / 9.0),
    };
    let (mut value, mut slope) = (zero, zero);
    for coefficient in coefficients.iter().rev() {
        (value, slope) = (value * e + *coefficient, slope * e + value);
    }
    (value, slope)
}

/// The largest power of two that is no larger than a positive number.
fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits(x.to_bits() & EXPONENT)
}

/// The moments Ĩ [kg m²] of (4) with the first `terms` polynomials: order 2 + 2 `terms` for a free body.
pub(super) fn preprocessed<T: Real>(
    moments: &Vector3<T>,
    momentum: &Vector3<T>,
    h: T,
    terms: usize,
) -> Vector3<T> {
    let largest = momentum.amax().to_f64();
    if largest < f64::MIN_POSITIVE || terms == 0 {
        return *moments;
    }
    // In units of a node and of the momentum, rounded to powers of two: products stay near one in every system of units.
    let (unit, size) = (power_of_two(0.5 / moments[0].to_f64()), power_of_two(largest));
    let per_unit = 1.0 / unit;
    let nodes = moments.map(|moment| T::of(0.5) / (moment * unit));
    let momentum = momentum.map(|part| part / size);
    let square = momentum.norm_squared();
    let eta = momentum.component_mul(&nodes).dot(&momentum) / square;
    let length = h * (unit * size);
    let x = length * length * square;
    let (mut sigma, mut delta) = (T::one(), T::zero());
    for _ in 0..terms {
        let (n, e) = (nodes.map(|node| sigma * node + delta), sigma * eta + delta);
        let symmetric = [n.sum(), n.x * n.y + n.y * n.z + n.z * n.x, n.product()];
        let (mut by_energy, mut by_square, mut power) = (T::one(), T::zero(), T::one());
        for m in 1..=terms {
            let (value, slope) = polynomial(m, e, symmetric);
            power *= x;
            by_energy += power * slope; // ∂K̃/∂H
            by_square += power * (value * (m + 1) as f64 - e * slope); // ∂K̃/∂C
        }
        (sigma, delta) = (T::one() / by_energy, -by_square / by_energy); // (4)
    }
    nodes.map(|node| T::of(0.5) / (sigma * node + delta) * per_unit)
}
