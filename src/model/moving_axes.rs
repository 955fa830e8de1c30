//! Steps of a free body in the axes in which it stands: the quaternion waits for the step, the step does not wait for it.
//!
//! With m = Rᵀ L, all in principal axes at the start of a step, Peskin's two stages are
//!
//! (1)  v = h/2 I⁻¹ m                                        the turn of the half step: Euler to the midpoint
//! (2)  m½ = R(v)ᵀ m = m − A v×m + B v×(v×m)                 A = sin|v|/|v|,  B = (1 − cos|v|)/|v|²
//! (3)  u = h/2 R(v) I⁻¹ m½ = v + R(v) h/2 I⁻¹ (m½ − m)      half the turn of the step, since R(v) v = v
//! (4)  q₁ = q (c, s u)                                      c = cos|u|,  s = sin|u|/|u|
//! (5)  m₁ = R(2u)ᵀ f = f + 2s (s u×(u×f) − c u×f)           f = R(q)ᵀ L
//!
//! The next step waits for m alone. (5) begins from f and not from m, so that q is the one master copy: what m is off by rounding
//! moves (1) and (2) by that much and is forgotten. The series of (2) to (5) take small turns only.
//!
//! The classical method on the quaternion takes its stages as q g, g = (w, x), with
//!
//! (6)  ġ = ½ g ω,   |g|² ω = I⁻¹ ((w² − x²) m − 2w x×m + 2 x (x·m))
//!
//! The maps are those of the pages `peskin-rk2` and `rk4-quaternion`: a test holds one to the other.

use crate::arithmetic::series::{COSINE, SINE, VERSINE, of_small_angle};
use crate::arithmetic::{Number, Real};
use crate::rotation::formulas::{cross, dot, inverse_root, minus, parts, plus, scaled, times};

/// Where a body stands.
#[derive(Clone, Copy, Debug)]
pub struct Stand<T> {
    /// q = (w, x, y, z), principal axes to world axes.
    pub attitude: [T; 4],
    /// m [kg m²/s].
    pub momentum: [T; 3],
}

/// A body that no torque acts on, at a step.
#[derive(Clone, Copy, Debug)]
pub struct Moving<T> {
    /// L [kg m²/s], world.
    momentum: [T; 3],
    /// 2 L.
    twice: [T; 3],
    /// h/2 I⁻¹ [s/(kg m²)].
    half: [T; 3],
}

impl<T: Number> Moving<T> {
    /// Of L, h/2 and I⁻¹.
    #[inline(always)]
    pub fn new(momentum: [T; 3], half_step: T, inverse_moments: [T; 3]) -> Moving<T> {
        Moving { momentum, twice: plus(momentum, momentum), half: scaled(inverse_moments, half_step) }
    }

    /// Rᵀ L = L + w t − x × t, t = 2 L × x, for q = (w, x).
    #[inline(always)]
    pub fn seen_from(&self, [w, x, y, z]: [T; 4]) -> [T; 3] {
        let t = cross(self.twice, [x, y, z]);
        minus(plus(self.momentum, scaled(t, w)), cross([x, y, z], t))
    }

    /// |v|² of (1) [rad²].
    #[inline(always)]
    pub fn square_of_half(&self, momentum: [T; 3]) -> T {
        let v = parts(self.half, momentum);
        dot(v, v)
    }

    /// A step of Peskin's scheme.
    #[inline(always)]
    pub fn peskin_rk2(&self, Stand { attitude: q, momentum: m }: Stand<T>) -> Stand<T> {
        let v = parts(self.half, m); // (1)
        let square = dot(v, v);
        let (a, b) = (of_small_angle(square, SINE), of_small_angle(square, VERSINE));
        let across = cross(v, m);
        let lost = minus(scaled(cross(v, across), b), scaled(across, a)); // (2)
        let rest = parts(self.half, lost);
        let turned = cross(v, rest);
        let u = plus(plus(plus(v, rest), scaled(turned, a)), scaled(cross(v, turned), b)); // (3)
        let square = dot(u, u);
        let (c, s) = (of_small_angle(square, COSINE), of_small_angle(square, SINE));
        let fresh = self.seen_from(q);
        let across = cross(u, fresh);
        let change = minus(scaled(cross(u, across), s), scaled(across, c));
        let momentum = plus(fresh, scaled(change, s + s)); // (5)
        let length = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
        let right = length.like(1.5) - length * 0.5;
        let (c, s) = (c * right, s * right);
        Stand { attitude: times(q, [c, s * u[0], s * u[1], s * u[2]]), momentum } // (4)
    }
}

impl<T: Real> Moving<T> {
    /// A step of the classical Runge–Kutta method on the quaternion.
    #[inline(always)]
    pub fn rk4_quaternion(&self, Stand { attitude: q, momentum: m }: Stand<T>) -> Stand<T> {
        let stage = Stage::new(self.half, m);
        let one = T::one();
        let x = parts(scaled(self.half, T::of(0.5)), m);
        let d2 = stage.change([one, x[0], x[1], x[2]], T::of(0.5));
        let d3 = stage.change([one + d2[0], d2[1], d2[2], d2[3]], one);
        let d4 = stage.change([one + d3[0], d3[1], d3[2], d3[3]], T::ratio(1.0, 6.0));
        let third = T::ratio(1.0, 3.0);
        let w = one + (((d2[0] + d2[0]) + d3[0]) * third + d4[0]);
        let part = |i: usize| ((x[i - 1] + (d2[i] + d2[i])) + d3[i]) * third + d4[i];
        let x = [part(1), part(2), part(3)];
        let fresh = self.seen_from(q);
        let twice = plus(fresh, fresh);
        let (ww, xx) = (w * w, dot(x, x));
        let excess = (ww + xx) - 1.0;
        let across = scaled(cross(x, twice), w);
        let seen = plus(scaled(fresh, ww - xx), minus(scaled(x, dot(x, twice)), across));
        let (inverse, root) = if excess.abs() <= T::LARGEST_EXCESS {
            ((one - excess) + excess * excess, inverse_root(excess))
        } else {
            (one / (ww + xx), one / (ww + xx).sqrt())
        };
        let momentum = scaled(seen, inverse);
        let length = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
        let right = root * (T::of(1.5) - length * 0.5);
        Stand { attitude: times(q, [w * right, x[0] * right, x[1] * right, x[2] * right]), momentum }
    }
}

/// What the stages of a step have in common.
struct Stage<T> {
    /// m.
    momentum: [T; 3],
    /// h/2 I⁻¹ m.
    turn: [T; 3],
    /// h I⁻¹.
    twice: [T; 3],
    /// h I⁻¹ (x×m) is made of these: products of one part of h I⁻¹ with the next part of m but one, and with the next.
    products: [[T; 3]; 2],
}

impl<T: Real> Stage<T> {
    #[inline(always)]
    fn new(half: [T; 3], m: [T; 3]) -> Stage<T> {
        let twice = plus(half, half);
        let products = [parts(twice, [m[2], m[0], m[1]]), parts(twice, [m[1], m[2], m[0]])];
        Stage { momentum: m, turn: parts(half, m), twice, products }
    }

    /// A part of h g ω/2 by (6). The division by |g|² stands last, so that nothing waits for it.
    #[inline(always)]
    fn change(&self, [w, x, y, z]: [T; 4], part: T) -> [T; 4] {
        let [far, near] = self.products;
        let across = [y * far[0] - z * near[0], z * far[1] - x * near[1], x * far[2] - y * near[2]];
        let v = [x, y, z];
        let (along, ww, xx) = (dot(v, self.momentum), w * w, dot(v, v));
        let shrink = part / (ww + xx);
        let rest = minus(scaled(parts(self.twice, v), along), scaled(across, w));
        let turn = plus(scaled(self.turn, ww - xx), rest);
        let change = plus(scaled(turn, w), cross(v, turn));
        [-(dot(v, turn) * shrink), change[0] * shrink, change[1] * shrink, change[2] * shrink]
    }
}
