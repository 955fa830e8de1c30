//! Jacobi's functions and the phase of the third-kind integral by one arithmetic-geometric mean, after Gauss.
//!
//! For k′ = b₀/a₀ and what a third-kind integral adds, R₀ and τ₀, levels n = 0, 1, … up:
//!
//! (1)  aₙ₊₁ = (aₙ + bₙ)/2,  bₙ₊₁ = √(aₙ bₙ),  hₙ = (aₙ − bₙ)/2
//! (2)  ρₙ₊₁ = √(1 + τₙ hₙ/aₙ₊₁),  eₙ₊₁ = ρₙ₊₁ − 1,  τₙ₊₁ = eₙ₊₁/(1 + ρₙ₊₁),  Rₙ₊₁ = Rₙ/ρₙ₊₁
//! (3)  Σ = 2 R₁ e₁ + 4 R₂ e₂ + … + 2ᴺ R_N e_N
//!
//! until hₙ is nothing against aₙ, and down again from s = sin φ, c = cos φ, d = 1 at φ = a_N v/a₀:
//!
//! (4)  sₙ = aₙ s/f,  cₙ = aₙ₊₁ c d/f,  dₙ = (aₙ₊₁ − hₙ s²)/f = (aₙ₊₁ c² + bₙ s²)/f,  f = aₙ₊₁ + hₙ s²,
//!      s, c and d those of the level n + 1;  s₀ = sn v,  c₀ = cn v,  d₀ = dn v
//! (5)  D = D₀ + 2 D₁ + 4 D₂ + …,  tan Dₙ = −Rₙ₊₁ aₙ₊₁ c sₙ (eₙ₊₁ + 1 − d)/(aₙ aₙ₊₁ cₙ c + Rₙ Rₙ₊₁ sₙ s),
//!      D of period 2 K
//!
//! Levels converge quadratically. Every Dₙ is small as eₙ₊₁ + 1 − d is, 2ⁿ and all, and e^{iD} is a product: no arctangent
//! is taken. (4) follows the signs of s and c, so that v is not reduced by K. Of the two forms of dₙ the first loses
//! what c has lost before, and the second is good where d is near zero, that is near the separatrix.
//!
//! With a₀ = 1, R₀² = 1 + ν, ρ₀² = 1 + k²/ν and τ₀ = (ρ₀ − 1)/(ρ₀ + 1) this is the integral of the third kind in its circular case,
//!
//! (6)  R₀ ρ₀ ∫₀^v du/(1 + ν sn² u) = (R₀ (ρ₀ − 1) + Σ) v + tan⁻¹(R₀ sn v / cn v) + 2 D
//!
//! by Gauss's transformation of Π, in which inverse tangents tan⁻¹(Rₙ tan φₙ / aₙ) enter with weights 2ⁿ: they differ less and
//! less from level to level, so that their differences Dₙ are taken instead, in closed form.
//!
//! Source: nist2010, 19.8(ii) and (iii), for the transformation of F and Π; (2), (3) and (5) derived from it here.

use crate::arithmetic::Real;

/// Levels: from k′ = 1e-140 the mean takes twelve.
const LEVELS: usize = 16;

/// hₙ/aₙ at the last level: its square is below a rounding unit.
fn close<T: Real>() -> f64 {
    5e-9 * (T::UNIT / f64::EPSILON).sqrt()
}

/// What (4) and (5) need of a level: aₙ, bₙ, Rₙ, Rₙ₊₁ and eₙ₊₁.
#[derive(Clone, Copy)]
struct Level<T> {
    a: T,
    b: T,
    radius: T,
    next_radius: T,
    excess: T,
}

/// The levels on the way up.
#[derive(Clone)]
pub struct Ladder<T> {
    levels: [Level<T>; LEVELS],
    count: usize,
    /// a_N, which an argument v/a₀ is multiplied by to give the angle that [`Ladder::down`] begins with.
    pub mean: T,
    /// Σ of (3).
    pub rate: T,
}

/// Jacobi's functions of an argument, and the phase of (5).
pub struct Passage<T> {
    /// sn v.
    pub sine: T,
    /// cn v.
    pub cosine: T,
    /// dn v.
    pub delta: T,
    /// 1 − dn v.
    pub missing: T,
    /// Real and imaginary part of e^{iD}, of any length.
    pub phase: [T; 2],
}

impl<T: Real> Ladder<T> {
    /// (1)–(3) from a₀, b₀ > 0, R₀ and τ₀.
    #[inline(always)]
    pub fn up(mut a: T, mut b: T, mut radius: T, mut tau: T) -> Ladder<T> {
        let zero = T::zero();
        let mut levels = [Level { a: zero, b: zero, radius: zero, next_radius: zero, excess: zero }; LEVELS];
        let (mut count, mut rate, mut weight) = (0, zero, 1.0);
        for level in &mut levels {
            let (mean, h) = ((a + b) * 0.5, (a - b) * 0.5); // (1)
            let more = tau * (h / mean);
            let rho = (more + 1.0).sqrt(); // (2)
            let inverse = T::one() / (rho + 1.0);
            let (excess, next_radius) = (more * inverse, radius / rho); // (2)
            *level = Level { a, b, radius, next_radius, excess };
            weight *= 2.0;
            rate += next_radius * weight * excess; // (3)
            count += 1;
            let close = h <= a * close::<T>();
            b = (a * b).sqrt(); // (1)
            (a, radius, tau) = (mean, next_radius, excess * inverse); // (2)
            if close {
                break;
            }
        }
        Ladder { levels, count, mean: a, rate }
    }

    /// (4) and (5) from sine and cosine of the angle φ = a_N v/a₀.
    #[inline(always)]
    pub fn down(&self, (mut s, mut c): (T, T)) -> Passage<T> {
        let (mut d, mut missing) = (T::one(), T::zero()); // missing: 1 − d
        let mut phase = [T::one(), T::zero()];
        for level in self.levels[..self.count].iter().rev() {
            let Level { a, b, radius, next_radius, excess } = *level;
            let (mean, h, square) = ((a + b) * 0.5, (a - b) * 0.5, s * s);
            let inverse = T::one() / (mean + h * square);
            let (sine, cosine) = (a * s * inverse, mean * inverse * (c * d)); // (4)
            let across = next_radius * mean * (c * sine) * (excess + missing);
            let along = a * mean * (cosine * c) + radius * next_radius * (sine * s);
            let [x, y] = [phase[0] * phase[0] - phase[1] * phase[1], phase[0] * 2.0 * phase[1]];
            let tangent = -across / along; // (5)
            phase = [x - y * tangent, y + x * tangent]; // (5)
            let above = if square < 0.5 { mean - h * square } else { mean * (c * c) + b * square };
            (s, c, d, missing) = (sine, cosine, above * inverse, h * 2.0 * square * inverse); // (4)
        }
        Passage { sine: s, cosine: c, delta: d, missing, phase }
    }
}
