//! The free rigid body in closed form: how far it turns in any time.
//!
//! Axes 1, 2, 3 are the principal axes so ordered that 2 has the middle moment and the polhode runs round 3. With
//! unit l = L/|L| in body axes, wⱼ = |L|/Iⱼ and wⱼₖ = wⱼ − wₖ:
//!
//! (1)  g = l₂² w₂₁ + l₃² w₃₁,  m = l₁² w₁₂ + l₃² w₃₂,  λ² = |w₂₃ g|,  k′² = w₁₃ m / (w₂₃ g),  r = w₁₃ / w₂₃
//! (2)  l₁ = a cn u,  l₂ = a √r sn u,  u = u₀ ± λ t, the sign that of l₃ w₁₃
//! (3)  l₃ = ± √(g/w₃₁) dn u,  dn² = cn² + k′² sn², the sign that of l₃(0)
//! (4)  the angle about L:  φ = w₁ t ± (w₂₁/λ) [S(u) − S(u₀)],  S = ∫₀^u r sn² / (1 + (r − 1) sn²)
//! (5)  Q = Z(α₀) Y(θ₀) Z(φ) Y(−θ) Z(−α),  α = atan2(l₂, l₁),  θ = atan2(√(l₁² + l₂²), l₃)
//!
//! so that an attitude R becomes R Q and the body's L becomes Qᵀ L. (4) holds since φ̇ = (w₁ l₁² + w₂ l₂²)/(l₁² + l₂²),
//! in which the size of l₁ and l₂ cancels: near the axis nothing is lost. Symmetric bodies have k = 0, r = 1; on the
//! separatrix k′ = 0 and the functions are tanh and sech. Error: a few rounding units times 1 + |Ω| t, times what
//! the polhode's own period makes of a rounding of L.
//!
//! Source: vanzon2007 and celledoni2008 for the reduction to Jacobi's functions; the forms above are derived here.

use nalgebra::{Quaternion, Vector3};

use crate::elliptic::{
    Amplitude, amplitude, argument_of, complete_integral_of_the_third_kind, integral_of_the_third_kind,
    is_even,
};
use crate::rotation::{self, Rotation};

/// k′² below which sn, near 1, no longer tells u: S = u − (something bounded) is then put right by what u itself says.
const NEAR_SEPARATRIX: f64 = 0.01;

/// The turn Q, in principal axes, that a free body makes in the time `t` [s]: attitude R → R Q.
///
/// `moments` [kg m²] are all above zero; `momentum` is L [kg m²/s] in principal axes.
pub fn turn_in(moments: &Vector3<f64>, momentum: &Vector3<f64>, t: f64) -> Rotation {
    let length = rotation::length(momentum);
    if length == 0.0 {
        return Rotation::identity();
    }
    let direction = momentum / length;
    let axes = Axes::around(moments, &direction);
    let rate = |j: usize| length / moments[axes.index[j]];
    let difference = |j: usize, k: usize| {
        let (i_j, i_k) = (moments[axes.index[j]], moments[axes.index[k]]);
        length * ((i_k - i_j) / i_j / i_k)
    };
    let l = axes.to_ordered(&direction);
    if difference(0, 2) == 0.0 || (l.x == 0.0 && l.y == 0.0) {
        return rotation::turn(&(momentum.component_div(moments) * t));
    }
    let polhode = Polhode {
        rate: rate(0),
        w13: difference(0, 2),
        w21: difference(1, 0),
        w23: difference(1, 2),
        w31: difference(2, 0),
        w32: difference(2, 1),
    };
    axes.turn_in_given_order(&polhode.turn_in(&l, t))
}

/// The principal axes in the order of (1); the first may be reversed to keep them right-handed.
struct Axes {
    index: [usize; 3],
    first: f64,
}

impl Axes {
    fn around(moments: &Vector3<f64>, l: &Vector3<f64>) -> Axes {
        let mut sorted = [0, 1, 2];
        sorted.sort_by(|i, j| moments[*i].total_cmp(&moments[*j]));
        let [a, b, c] = sorted;
        let below = (moments[b] - moments[a]) / moments[a] / moments[b];
        let above = (moments[c] - moments[b]) / moments[b] / moments[c];
        let side = l[a] * l[a] * below - l[c] * l[c] * above;
        // On the separatrix both will do, unless two moments are equal: then only the third axis is run round.
        let index = if side > 0.0 || (side == 0.0 && below > above) { [c, b, a] } else { [a, b, c] };
        let even = (index[0] + 1) % 3 == index[1];
        Axes { index, first: if even { 1.0 } else { -1.0 } }
    }

    fn to_ordered(&self, v: &Vector3<f64>) -> Vector3<f64> {
        let [i, j, k] = self.index;
        Vector3::new(self.first * v[i], v[j], v[k])
    }

    fn turn_in_given_order(&self, turn: &Rotation) -> Rotation {
        let mut imaginary = Vector3::zeros();
        let [i, j, k] = self.index;
        (imaginary[i], imaginary[j], imaginary[k]) = (self.first * turn.i, turn.j, turn.k);
        Rotation::new_unchecked(Quaternion::from_parts(turn.w, imaginary))
    }
}

/// w₁ and the differences wⱼₖ of (1) [rad/s].
struct Polhode {
    rate: f64,
    w13: f64,
    w21: f64,
    w23: f64,
    w31: f64,
    w32: f64,
}

impl Polhode {
    /// Q in the ordered axes, from the unit vector `l`.
    fn turn_in(&self, l: &Vector3<f64>, t: f64) -> Rotation {
        let squares = l.component_mul(l);
        let g = squares.y * self.w21 + squares.z * self.w31; // (1)
        let m = squares.z * self.w32 - squares.x * self.w21; // (1)
        let lambda = self.w23.abs().sqrt() * g.abs().sqrt(); // (1)
        let complementary =
            if self.w21 == 0.0 { 1.0 } else { ((self.w13 / self.w23) * (m / g)).clamp(0.0, 1.0) }; // (1)
        let ratio = self.w13 / self.w23; // (1)
        let root = ratio.sqrt();
        let a = plane_length(l.y / root, l.x); // (2): a² = l₁² + l₂²/r
        let before =
            Amplitude { half_turns: 0.0, sine: l.y / root / a, cosine: l.x / a, quarter_period: f64::NAN };
        let sense = if l.z * self.w13 < 0.0 { -1.0 } else { 1.0 };
        // The amplitude of an opposite start lies half a turn on: (2) and (4) see squares only, so it is left out.
        let flip = if before.cosine < 0.0 { -1.0 } else { 1.0 };
        let first = argument_of(flip * before.sine, before.cosine.abs(), complementary);
        if !first.is_finite() {
            // A steady spin about the middle axis: it would leave in no finite time.
            let steady =
                Vector3::new(l.x * self.rate, l.y * (self.rate + self.w21), l.z * (self.rate + self.w31));
            return rotation::turn(&(steady * t));
        }
        let u = first + sense * lambda * t;
        let found = amplitude(u, complementary); // (2)
        let after = Amplitude { sine: flip * found.sine, cosine: flip * found.cosine, ..found };
        let (x, y) = (a * after.cosine, a * root * after.sine); // (2)
        let delta = plane_length(after.cosine, complementary.sqrt() * after.sine);
        let z = ((g / self.w31).sqrt() * delta).copysign(l.z); // (3)
        let mut phi = self.rate * t; // (4)
        if self.w21 != 0.0 {
            let start = Amplitude { sine: flip * before.sine, cosine: flip * before.cosine, ..before };
            let mut swept = swept(&found, complementary, ratio) - swept(&start, complementary, ratio);
            if complementary < NEAR_SEPARATRIX {
                swept += u - found.argument(complementary);
            }
            phi += sense * (self.w21 / lambda) * swept;
        }
        let about = toward(l.x, l.y, l.z);
        let about_after = toward(x, y, z).inverse();
        let (sine, cosine) = (0.5 * phi).sin_cos();
        let phi = Rotation::new_unchecked(Quaternion::new(cosine, 0.0, 0.0, sine));
        rotation::renormalized(about * phi * about_after) // (5)
    }
}

/// Z(α) Y(θ) of (5): takes the third axis to the direction of (x, y, z), without an angle or its sine.
fn toward(x: f64, y: f64, z: f64) -> Rotation {
    let across = plane_length(x, y);
    let length = plane_length(across, z);
    let (theta, theta_sine) = half(z / length, across / length);
    let (alpha, alpha_sine) = if across == 0.0 { (1.0, 0.0) } else { half(x / across, y / across) };
    Rotation::new_unchecked(Quaternion::new(
        alpha * theta,
        -alpha_sine * theta_sine,
        alpha * theta_sine,
        alpha_sine * theta,
    ))
}

/// Cosine and sine of half an angle from those of the angle, in (−π, π].
fn half(cosine: f64, sine: f64) -> (f64, f64) {
    let larger = (0.5 * (1.0 + cosine.abs())).sqrt();
    let smaller = 0.5 * sine / larger;
    if cosine >= 0.0 { (larger, smaller) } else { (smaller.abs(), larger.copysign(sine)) }
}

/// √(x² + y²) of parts of unit vectors: what underflows in a square is below what rounding leaves of the other.
fn plane_length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// S of (4), by the third-kind integral over the amplitude: 2 m times that of a quarter turn, and the rest.
fn swept(end: &Amplitude, complementary: f64, ratio: f64) -> f64 {
    let (sine, square) = (end.sine, end.cosine * end.cosine);
    // sn and cn change sign together with every half turn of the amplitude.
    let sine = if is_even(end.half_turns) { sine } else { -sine };
    let second = square + complementary * sine * sine;
    let nu = (ratio - 1.0) * sine * sine;
    let mut sum =
        sine * sine * sine * integral_of_the_third_kind(square, second, 1.0, 1.0 + nu) * (1.0 / 3.0);
    if end.half_turns != 0.0 {
        sum += 2.0 * end.half_turns * complete_integral_of_the_third_kind(complementary, ratio);
    }
    ratio * sum
}
