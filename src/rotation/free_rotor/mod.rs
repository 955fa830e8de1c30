//! The free rigid body in closed form: how far it turns in any time.
//!
//! Axes 1, 2, 3 are the principal axes so ordered that 2 has the middle moment and the polhode runs round 3, and so
//! directed that l₃ ≥ 0. With unit l = L/|L| in body axes, wⱼ = |L|/Iⱼ and wⱼₖ = wⱼ − wₖ:
//!
//! (1)  p = w₁₂/w₁₃,  q = w₂₃/w₁₃ = 1 − p,  a² = l₁² + q l₂²,  δ² = l₃² + p l₂² = 1 − a²,  k′² = (q l₃² − p l₁²)/(q δ²)
//! (2)  l₁ = a cn u,  l₂ = (a/√q) sn u,  l₃ = δ dn u,  u = u₀ + v,  v = w₁₃ √q δ t
//! (3)  l at u₀ and sn, cn, dn of v give l at u by the addition theorems, whose denominator is cn² v + sn² v dn² u₀
//! (4)  Q = P₀ Z(Φ) P⁻¹,  P the least turn that takes axis 3 to l:  (1 + l₃, −l₂, l₁, 0)/√(2 + 2 l₃)
//! (5)  Φ/2 = ½ ϖ t + D(u) − D(u₀),  ϖ = w₁ a²/(1 + δ) + w₃ δ + w₁₃ Σ,  since dΦ/dt = (w₁ l₁² + w₂ l₂²)/(1 + l₃) + w₃ l₃
//! (6)  D(u) − D(u₀) = D(v) + arg (M g + δ + iκ)(M + δ − iκ),
//!      M = δ² + a² sn² v/((1 + cn v)(1 + dn v)),  κ = (a²/√q) sn v/(1 + dn v),  g = dn(u₀ + v/2)/dn(v/2)
//! (7)  g = (dn u₀ (1 + dn v) − p l₁ l₂ sn v/(√q δ²))/(cn v + dn v + x sn v dn² u₀),  x = sn v/(1 + cn v),  and where its
//!      numerator cancels  g = (l₁ dn u₀ + k′² √q l₂ sn v/(cn v + dn v))/(l₁ + √q l₂ x dn u₀)
//!
//! so that an attitude R becomes R Q and the body's L becomes Qᵀ L. Σ and the odd function D of period 2 K come with sn,
//! cn and dn from one arithmetic-geometric mean ([`crate::rotation::elliptic::gauss`]) with a₀ = √q δ, b₀ = k′ a₀, R₀ = δ and τ₀ =
//! (1 − δ)/(1 + δ), at the angle a_N w₁₃ t. Only v depends on t, and only (3), (6) and (7) on where on its polhode the
//! body starts, so that neither a long u₀ near the separatrix nor its rounding enters; (6) and (7) have the period 2 K in v
//! and in u₀, which are moved to where cn ≥ 0. All sums in ϖ but Σ, all of (6), and (7) in its two forms are of one sign.
//! e^{iΦ/2} is a product: apart from the sine and cosine of two angles no transcendental function is taken. Symmetric
//! bodies have k = 0, Σ = 0 and D = 0.
//!
//! (6) is the addition theorem of e^{2iD}, a quotient of theta functions with the pole of dΦ/dt, l₃ = −1, on the periods 2 K and
//! 4 i K′: the product of its sines is dn(u₀ + v/2) less dn at half a step from the pole. On the separatrix, k′ = 0, the
//! functions are tanh and sech and
//!
//! (8)  ϖ = w₂,  2 D(v) = tan⁻¹(√(p/q) tanh v) − tan⁻¹(sinh v/√q)
//!
//! Steps of a run are often equal, and equal errors add up: no rounding may be large against a short step. So (3) gives the change
//! of l, from 1 − cn v = sn² v/(1 + cn v) and 1 − dn v, and since P₀ Z(Φ) P₀⁻¹ is the turn by Φ about l,
//!
//! (9)  Q ∝ 2 (1 + l₃) (cos Φ/2, l sin Φ/2) + P₀ Z(Φ) ΔP⁻¹,  P₀ = (1 + l₃, −l₂, l₁, 0),  ΔP⁻¹ = (Δl₃, Δl₂, −Δl₁, 0)
//!
//! Error: a few rounding units times 1 + |Ω| t, times what the motion makes of a rounding of L or of a moment.
//!
//! Source: vanzon2007 and celledoni2008 for the reduction to Jacobi's functions; the forms above are derived here.

use nalgebra::{Quaternion, Vector3};

use crate::arithmetic::Real;
use crate::rotation::elliptic::gauss::{Ladder, Passage};
use crate::rotation::{self, Rotation};

/// k′ below which the body leaves the middle axis but does not come back: sech of the quarter period is zero to f64.
const ON_SEPARATRIX: f64 = 1e-140;

/// Beyond this argument sech, below 1e-130, is not told from zero.
const FARTHEST: f64 = 300.0;

/// The turn Q, in principal axes, that a free body makes in the time `t` [s]: attitude R → R Q.
///
/// `moments` [kg m²] are all above zero; `momentum` is L [kg m²/s] in principal axes.
pub fn turn_in<T: Real>(moments: &Vector3<T>, momentum: &Vector3<T>, t: T) -> Rotation<T> {
    let length = rotation::length(momentum);
    if length == 0.0 {
        return Rotation::identity();
    }
    let direction = momentum * (T::one() / length);
    let inverse = moments.map(|moment| T::one() / moment);
    let axes = Axes::around(moments, &inverse, &direction);
    let l = axes.to_ordered(&direction);
    let [i, j, k] = axes.index;
    let difference = |j: usize, k: usize| length * ((moments[k] - moments[j]) * inverse[j] * inverse[k]);
    let (w12, w23, w13) = (difference(i, j), difference(j, k), difference(i, k));
    let (p, q) = (w12 / w13, w23 / w13); // (1)
    let delta_square = l.z * l.z + p * (l.y * l.y); // (1)
    if w13 == 0.0 || delta_square == 0.0 || (l.x == 0.0 && l.y == 0.0) {
        return rotation::turn(&(momentum.component_mul(&inverse) * t));
    }
    let delta = delta_square.sqrt();
    let polhode = Polhode {
        l,
        p,
        q,
        root: q.sqrt(),
        across: l.x * l.x + q * (l.y * l.y), // (1)
        delta,
        inverse_delta: T::one() / delta,
    };
    let turn = polhode.turn_in(length * t, [inverse[i], inverse[j], inverse[k]], w13 * t);
    axes.turn_in_given_order(&turn)
}

/// The principal axes in the order of (1), some of them reversed.
struct Axes<T> {
    index: [usize; 3],
    signs: [T; 3],
}

impl<T: Real> Axes<T> {
    fn around(moments: &Vector3<T>, inverse: &Vector3<T>, l: &Vector3<T>) -> Axes<T> {
        let (mut a, mut b, mut c) = (0, 1, 2);
        if moments[a] > moments[b] {
            (a, b) = (b, a);
        }
        if moments[b] > moments[c] {
            (b, c) = (c, b);
        }
        if moments[a] > moments[b] {
            (a, b) = (b, a);
        }
        let below = (moments[b] - moments[a]) * inverse[a] * inverse[b];
        let above = (moments[c] - moments[b]) * inverse[b] * inverse[c];
        let side = l[a] * l[a] * below - l[c] * l[c] * above;
        // On the separatrix both will do, unless two moments are equal: then only the third axis is run round.
        let index = if side > 0.0 || (side == 0.0 && below > above) { [c, b, a] } else { [a, b, c] };
        let handed = if (index[0] + 1) % 3 == index[1] { T::one() } else { -T::one() };
        let third = T::one().copysign(l[index[2]]);
        // Half a turn about the first axis reverses the other two.
        Axes { index, signs: [handed, third, third] }
    }

    fn to_ordered(&self, v: &Vector3<T>) -> Vector3<T> {
        let ([i, j, k], [x, y, z]) = (self.index, self.signs);
        Vector3::new(x * v[i], y * v[j], z * v[k])
    }

    fn turn_in_given_order(&self, turn: &Rotation<T>) -> Rotation<T> {
        let mut imaginary = Vector3::zeros();
        let ([i, j, k], [x, y, z]) = (self.index, self.signs);
        (imaginary[i], imaginary[j], imaginary[k]) = (x * turn.i, y * turn.j, z * turn.k);
        Rotation::new_unchecked(Quaternion::from_parts(turn.w, imaginary))
    }
}

/// l in the ordered axes and the constants of (1): √q is `root`, a² is `across`.
struct Polhode<T: Real> {
    l: Vector3<T>,
    p: T,
    q: T,
    root: T,
    across: T,
    delta: T,
    inverse_delta: T,
}

impl<T: Real> Polhode<T> {
    /// Q in the ordered axes, from |L| t, the inverse moments and w₁₃ t.
    fn turn_in(&self, impulse: T, inverse_moments: [T; 3], w13_t: T) -> Rotation<T> {
        let Polhode { l, delta, .. } = *self;
        // √q δ k′, and √q δ.
        let complement = (self.q * (l.z * l.z) - self.p * (l.x * l.x)).max(T::zero()).sqrt(); // (1)
        let span = self.root * delta;
        let (passage, mean_angle) = if complement <= span * ON_SEPARATRIX {
            (self.on_separatrix(span * w13_t), impulse * inverse_moments[1]) // (8)
        } else {
            let steepness = self.across / ((delta + 1.0) * (delta + 1.0)); // (1 − δ)/(1 + δ)
            let ladder = Ladder::up(span, complement, delta, steepness);
            let steady = inverse_moments[0] * (self.across / (delta + 1.0)) + inverse_moments[2] * delta;
            (
                ladder.down(rotation::sine_and_cosine(ladder.mean * w13_t)),
                impulse * steady + ladder.rate * w13_t,
            ) // (5)
        };
        let [x, y] = passage.phase;
        let [across, along] = self.added(&passage, complement * self.inverse_delta);
        let (sine, cosine) = rotation::sine_and_cosine(mean_angle * 0.5);
        let (turned, aside) = (x * along - y * across, x * across + y * along); // (6)
        let half_phi = [cosine * turned - sine * aside, sine * turned + cosine * aside]; // (5)
        turn_of(&l, half_phi, &self.change(&passage)) // (9)
    }

    /// l(u) − l(u₀) by (3), for a short step in numbers that are small with it.
    fn change(&self, passage: &Passage<T>) -> Vector3<T> {
        let Polhode { l, p, root, inverse_delta, .. } = *self;
        let Passage { sine, cosine, delta, missing, .. } = *passage;
        let turning = l.z * inverse_delta * sine;
        let (squares, turned) = (sine * sine, turning * turning);
        let inverse = T::one() / (cosine * cosine + turned);
        let x = -root * l.y * (turning * delta);
        let y = l.x * turning / root;
        let z = -p * inverse_delta / root * (l.x * l.y) * (sine * cosine);
        if cosine < 0.5 {
            let plain = Vector3::new(l.x * cosine, l.y * (cosine * delta), l.z * delta);
            return (plain + Vector3::new(x, y, z)) * inverse - l;
        }
        let short = squares / (cosine + 1.0); // 1 − cn v
        let x = x + l.x * (cosine * short - turned);
        let y = y + l.y * (cosine * (short - missing) - turned);
        let z = z + l.z * (squares - missing - turned);
        Vector3::new(x, y, z) * inverse
    }

    /// Imaginary and real part of the product in (6), from √q k′.
    fn added(&self, passage: &Passage<T>, complement: T) -> [T; 2] {
        let Polhode { l, p, root, across, delta, inverse_delta, .. } = *self;
        let sine = passage.sine * T::one().copysign(passage.cosine);
        let (cosine, d) = (passage.cosine.abs(), passage.delta);
        let half = sine / (cosine + 1.0); // (7)
        let first = l.z * inverse_delta;
        let (x, y) = (l.x.abs(), root * l.y * T::one().copysign(l.x));
        let g = if x * y * sine > 0.0 {
            let squeezed = complement * complement / (root * root);
            (x * first + squeezed * y * sine / (cosine + d)) / (x + y * half * first) // (7)
        } else {
            let bent = p * (inverse_delta * inverse_delta) / root * (l.x * l.y);
            (first * (d + 1.0) - bent * sine) / (cosine + d + half * sine * (first * first)) // (7)
        };
        let rest = across / (d + 1.0) * sine;
        let (m, kappa) = (delta * delta + rest * half, rest / root); // (6)
        // Over (M + δ)², so that nothing leaves the range of f64.
        let inverse = T::one() / (m + delta);
        let kappa = kappa * inverse;
        [kappa * (m * inverse) * (T::one() - g), (m * g + delta) * inverse + kappa * kappa] // (6)
    }

    /// tanh and sech of v, and e^{iD} by (8): half the angle of (cn + √p sn²/q) + i (√(p/q) sn cn − sn/√q).
    fn on_separatrix(&self, v: T) -> Passage<T> {
        let v = v.clamp(T::of(-FARTHEST), T::of(FARTHEST));
        let (sine, cosine) = (v.tanh(), T::one() / v.cosh());
        let slope = (self.p / self.q).sqrt();
        let real = cosine + slope / self.root * (sine * sine);
        let imaginary = slope * (sine * cosine) - sine / self.root;
        let size = (real * real + imaginary * imaginary).sqrt();
        let missing = sine * sine / (cosine + 1.0);
        Passage { sine, cosine, delta: cosine, missing, phase: [size + real, imaginary] }
    }
}

/// (9) from l, e^{iΦ/2} of any length, and the change of l.
fn turn_of<T: Real>(l: &Vector3<T>, [cosine, sine]: [T; 2], change: &Vector3<T>) -> Rotation<T> {
    let w = l.z + 1.0;
    let about = Quaternion::from_parts(cosine, l * sine) * (w * 2.0);
    let carried = Quaternion::new(w * cosine, l.x * sine - l.y * cosine, l.x * cosine + l.y * sine, w * sine);
    Rotation::new_normalize(about + carried * Quaternion::new(change.z, change.y, -change.x, T::zero()))
}

#[cfg(test)]
mod tests;
