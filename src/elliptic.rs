//! Elliptic integrals in Carlson's symmetric forms, and Jacobi's functions by the arithmetic-geometric mean.
//!
//! The modulus enters as k′² = 1 − k² everywhere, so that nothing is lost where k is near 1:
//!
//! (1)  F(φ, k) = sin φ R_F(cos² φ, cos² φ + k′² sin² φ, 1)
//! (2)  ∫₀^φ sin² / ((1 + ν sin²) √(1 − k² sin²)) = ⅓ sin³ φ R_J(cos² φ, cos² φ + k′² sin² φ, 1, 1 + ν sin² φ)
//! (3)  am u: a₀ = 1, b₀ = k′; aₙ₊₁ = (aₙ + bₙ)/2, bₙ₊₁ = √(aₙ bₙ), cₙ₊₁ = (aₙ − bₙ)/2;
//!      φ_N = 2ᴺ a_N u, φₙ₋₁ = (φₙ + arcsin(cₙ/aₙ sin φₙ))/2, am u = φ₀; K = π/(2 a_N)
//!
//! Source: carlson1995 (duplication), and Gauss's mean.

use std::f64::consts::FRAC_PI_2;

/// Halvings of the arithmetic-geometric mean, which converges quadratically: from k′ = 1e-160 in twelve.
const MEANS: usize = 16;

/// Beyond this argument sech, below 1e-130, is not told from zero.
const FARTHEST: f64 = 300.0;

/// R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)), of numbers ≥ 0 of which one at most is zero.
pub fn integral_of_the_first_kind(x: f64, y: f64, z: f64) -> f64 {
    let mean = (x + y + z) / 3.0;
    let (mut x, mut y, mut z, mut a) = (x, y, z, mean);
    let mut spread = (mean - x).abs().max((mean - y).abs()).max((mean - z).abs());
    // The first term that the series leaves out is of the eighth power: (1/150)⁸ < 1e-17.
    while spread * 150.0 > a {
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * ry + ry * rz + rz * rx;
        (x, y, z, a) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift), 0.25 * (a + shift));
        spread *= 0.25;
    }
    let (dx, dy) = ((a - x) / a, (a - y) / a);
    let dz = -dx - dy;
    let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
    let series =
        1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0 - 5.0 * e2 * e2 * e2 / 208.0
            + 3.0 * e3 * e3 / 104.0
            + e2 * e2 * e3 / 16.0;
    series / a.sqrt()
}

/// R_J(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))) for p no less than x, y and z, of which one
/// at most is zero.
pub fn integral_of_the_third_kind(x: f64, y: f64, z: f64, p: f64) -> f64 {
    let mean = (x + y + z + 2.0 * p) / 5.0;
    let delta = (p - x) * (p - y) * (p - z);
    let (mut x, mut y, mut z, mut p, mut a) = (x, y, z, p, mean);
    let mut spread = (mean - x).abs().max((mean - y).abs()).max((mean - z).abs()).max((mean - p).abs());
    let (mut quarter, mut sum) = (1.0, 0.0);
    while spread * 150.0 > a {
        let (rx, ry, rz, rp) = (x.sqrt(), y.sqrt(), z.sqrt(), p.sqrt());
        let shift = rx * ry + ry * rz + rz * rx;
        let d = (rp + rx) * (rp + ry) * (rp + rz);
        sum += quarter / d * arctangent_ratio(quarter * quarter * quarter * (delta / d) / d);
        (x, y, z, p) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift), 0.25 * (p + shift));
        a = 0.25 * (a + shift);
        spread *= 0.25;
        quarter *= 0.25;
    }
    let (dx, dy, dz) = ((a - x) / a, (a - y) / a, (a - z) / a);
    let dp = -0.5 * (dx + dy + dz);
    let product = dx * dy * dz;
    let e2 = dx * dy + dx * dz + dy * dz - 3.0 * dp * dp;
    let e3 = product + 2.0 * e2 * dp + 4.0 * dp * dp * dp;
    let e4 = (2.0 * product + e2 * dp + 3.0 * dp * dp * dp) * dp;
    let e5 = product * dp * dp;
    let series =
        1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0
            + 3.0 * e5 / 26.0
            - e2 * e2 * e2 / 16.0
            + 3.0 * e3 * e3 / 40.0
            + 3.0 * e2 * e4 / 20.0
            + 45.0 * e2 * e2 * e3 / 272.0
            - 9.0 * (e3 * e4 + e2 * e5) / 68.0;
    quarter * series / (a * a.sqrt()) + 6.0 * sum
}

/// R_C(1, 1 + e) = arctan √e / √e for e ≥ 0.
fn arctangent_ratio(e: f64) -> f64 {
    if e < 1e-8 {
        return 1.0 - e / 3.0 + e * e / 5.0;
    }
    let root = e.sqrt();
    root.atan() / root
}

/// An argument u of Jacobi's functions reduced to 2 m K + remainder with |remainder| ≤ K, and its amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitude {
    /// m, a whole number: how many half turns the amplitude has made.
    pub half_turns: f64,
    /// sin of the amplitude: sn u.
    pub sine: f64,
    /// cos of the amplitude: cn u.
    pub cosine: f64,
}

impl Amplitude {
    /// The argument that these numbers have by (1): u, as far as they tell it.
    pub fn argument(&self, complementary: f64) -> f64 {
        if self.half_turns == 0.0 {
            return argument_of(self.sine, self.cosine, complementary);
        }
        let sine = if self.half_turns % 2.0 == 0.0 { self.sine } else { -self.sine };
        let period = 2.0 * integral_of_the_first_kind(0.0, complementary, 1.0);
        self.half_turns * period + argument_of(sine, self.cosine, complementary)
    }
}

/// The amplitude of `u`, and with it sn u and cn u, by (3). `complementary` is k′² in [0, 1]; at 0 the functions
/// are tanh and sech.
pub fn amplitude(u: f64, complementary: f64) -> Amplitude {
    if complementary == 0.0 {
        let u = u.clamp(-FARTHEST, FARTHEST);
        return Amplitude { half_turns: 0.0, sine: u.tanh(), cosine: 1.0 / u.cosh() };
    }
    let (mut a, mut b) = (1.0, complementary.sqrt());
    let (mut ratios, mut count) = ([0.0; MEANS], 0);
    while count < MEANS {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        ratios[count] = c / a;
        count += 1;
        if c.abs() <= 1e-8 * a {
            break;
        }
    }
    let quarter_period = FRAC_PI_2 / a;
    let half_turns = (u / (2.0 * quarter_period)).round();
    let mut phi = (u - 2.0 * half_turns * quarter_period) * a * f64::from(1u32 << count);
    for ratio in ratios[..count].iter().rev() {
        phi = 0.5 * (phi + (ratio * phi.sin()).asin());
    }
    let sign = if half_turns % 2.0 == 0.0 { 1.0 } else { -1.0 };
    Amplitude { half_turns, sine: sign * phi.sin(), cosine: sign * phi.cos() }
}

/// F by (1), for an amplitude within ± π/2 given by its sine and cosine.
pub fn argument_of(sine: f64, cosine: f64, complementary: f64) -> f64 {
    let square = cosine * cosine;
    sine * integral_of_the_first_kind(square, square + complementary * sine * sine, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carlsons_integrals_have_their_published_values() {
        // Carlson (1995), section 3.
        assert!((integral_of_the_first_kind(1.0, 2.0, 0.0) - 1.3110287771461).abs() < 1e-13);
        assert!((integral_of_the_first_kind(2.0, 3.0, 4.0) - 0.58408284167715).abs() < 1e-13);
        assert!((integral_of_the_third_kind(0.0, 1.0, 2.0, 3.0) - 0.77688623778582).abs() < 1e-13);
        assert!((integral_of_the_third_kind(2.0, 3.0, 4.0, 5.0) - 0.14297579667157).abs() < 1e-13);
    }

    #[test]
    fn the_amplitude_undoes_the_integral_of_the_first_kind_for_every_modulus() {
        for complementary in [1.0, 1.0 - 1e-12, 0.5, 1e-3, 1e-12, 1e-30, 0.0] {
            for phi in [-1.5f64, -0.3, 1e-9, 0.7, 1.2, 1.55] {
                let u = argument_of(phi.sin(), phi.cos(), complementary);
                let found = amplitude(u, complementary);
                let back = found.sine.atan2(found.cosine);
                // At most eight steps of the mean, a rounding each, and those of u: measured up to 1.8e-15.
                let bound = f64::EPSILON * (8.0 + u.abs());
                assert!((back - phi).abs() < bound, "k'² = {complementary}, φ = {phi}: {:e}", back - phi);
            }
        }
    }

    #[test]
    fn the_amplitude_of_a_whole_period_comes_back_after_a_million_turns() {
        let complementary = 0.3;
        let quarter = integral_of_the_first_kind(0.0, complementary, 1.0);
        let found = amplitude(0.4 + 2e6 * quarter, complementary);
        let first = amplitude(0.4, complementary);
        assert_eq!(found.half_turns, 1e6);
        assert!((found.sine - first.sine).abs() < f64::EPSILON * 2e6 * quarter);
    }
}
