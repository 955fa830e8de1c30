//! Lagrange's top: a symmetric body under uniform gravity, held at a point of its axis.
//!
//! v is up, e₃ the axis from the pivot to the centre of mass, z = v·e₃ = cos θ; moments A, A, C about the pivot. With
//! p = L·v/A and s = L·e₃/A, both constant, a = 2 M g l/A and ε = z₀ + |L⊥|²/(A² a):
//!
//! (1)  ż² = a (ε − z)(1 − z²) − (p − s z)² = a (z − z₁)(z − z₂)(z − z₃),   −1 ≤ z₁ ≤ z₂ ≤ 1 ≤ z₃
//! (2)  z = z₁ + (z₂ − z₁) sn² u,  u = u₀ + λ t,  λ² = a (z₃ − z₁)/4,  k′² = (z₃ − z₂)/(z₃ − z₁)
//! (3)  1 ± z = (1 ± z₁) (cn² u + ρ± sn² u),  ρ± = (1 ± z₂)/(1 ± z₁)
//! (4)  q = V (α, β) Rot(e₃ (1/C − 1/A) L·e₃ t) W:  w + i z = α,  x + i y = β  turn v to e₃
//! (5)  α = √((1 + z)/2) e^{iψ₊},  ψ₊' = (p + s)/(2 (1 + z));   β = √((1 − z)/2) e^{iψ₋},  ψ₋' = (p − s)/(2 (1 − z))
//! (6)  ∫ du/(cn² + ρ sn²) = u + (1 − ρ) S(u, ρ), S = ∫ sn²/(cn² + ρ sn²) du of the third kind, where ρ ≤ 1
//!                         = [u + k′² (1 − 1/ρ) S(u + K, k′²/ρ)]/ρ where ρ > 1: sums of what is above zero, so that none cancels
//! (7)  L = L·e₃ e₃ + A (θ̇ n + (p − s z)/sin θ (e₃ × n)), n the line of nodes
//!
//! Each of the Cayley–Klein parameters α and β has a phase of its own: near the vertical β is small, its phase moves
//! fast, and neither harms α. Where p = ∓ s the axis passes through the vertical: 1 + z₁ or 1 − z₂ is zero, the
//! parameter goes as sn or cn and changes sign there while its phase stands still. The roots are found by halving in
//! double-double arithmetic. A rod on a pivot, C = 0, is a spherical pendulum and is covered.
//!
//! Source: whittaker1937, chapter VI, for (1) and (2); klein1897 for the parameters; (3)–(7) derived here.

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::top_roots::{Start, roots};
use crate::model::body::{Body, Shape};
use crate::model::{Snapshot, System};
use crate::rotation::elliptic::{Amplitude, amplitude, argument_of, integral_of_the_third_kind};
use crate::rotation::{self, Rotation};

/// Difference of moments, over the largest, and of directions that is rounding.
const SYMMETRIC: f64 = 32.0 * f64::EPSILON;

/// A phase of (5) and the size that goes with it.
#[derive(Clone, Copy, Debug)]
struct Parameter {
    /// √((1 ± z₁)/2), or √((1 ± z₂)/2) where it goes as sn.
    size: f64,
    /// ρ.
    ratio: f64,
    /// Whether it goes as sn (first) or cn (second) with a sign.
    passes: [bool; 2],
    /// Phase at t = 0.
    phase: f64,
    /// (p ± s)/(2 (1 ± z₁) λ).
    rate: f64,
}

impl Parameter {
    /// By (3) from 1 ± z at z₁ and at z₂, (p ± s)/(2 λ), and the parameter at t = 0 with its derivative, which tells
    /// the phase where the parameter is zero.
    fn of(heights: [f64; 2], rate: f64, first: &Amplitude, value: [f64; 2], change: [f64; 2]) -> Parameter {
        let [lowest, highest] = heights;
        let passes = [lowest <= 0.0, lowest > 0.0 && highest <= 0.0];
        let (sign, slope) = match passes {
            [true, _] => (first.sine, first.cosine),
            [_, true] => (first.cosine, -first.sine),
            _ => (1.0, 1.0),
        };
        let [x, y] = if sign == 0.0 { change.map(|x| x * slope) } else { value.map(|x| x * sign) };
        let (size, ratio) = if passes[0] { (highest, 0.0) } else { (lowest, highest / lowest) };
        let rate = if passes.contains(&true) { 0.0 } else { rate / lowest };
        Parameter { size: (0.5 * size).sqrt(), ratio, passes, phase: y.atan2(x), rate }
    }
}

/// The axis of a symmetric body whose centre of mass is on it, and its moments across and along, about the pivot.
fn moments(body: &Body) -> Option<(Vector3<f64>, [f64; 2])> {
    let axis = body.center / rotation::length(&body.center);
    let axial = if let Shape::Rod { .. } = body.shape { 0.0 } else { axis.dot(&(body.inertia * axis)) };
    let across = 0.5 * (body.inertia.trace() - axial);
    let symmetric = Matrix3::from_diagonal_element(across) + axis * axis.transpose() * (axial - across);
    let fits = (body.inertia - symmetric).amax() <= SYMMETRIC * body.inertia.amax();
    fits.then_some((axis, [across, axial]))
}

/// The constants of a motion.
pub(super) struct Top {
    /// Takes z to v.
    upright: Rotation,
    /// Takes e₃ to z.
    axis: Rotation,
    /// e₃, body axes.
    own_axis: Vector3<f64>,
    start: Start,
    /// (1/C − 1/A) L·e₃ [rad/s].
    own_rate: f64,
    moment: f64,
    /// z₂ − z₁.
    between: f64,
    /// k′².
    complementary: f64,
    lambda: f64,
    first: Amplitude,
    u: f64,
    alpha: Parameter,
    beta: Parameter,
}

impl Top {
    /// The constants of a system under `gravity` [m/s²], where it is such a top and not standing upright for good.
    pub(super) fn of(system: &System, gravity: &Vector3<f64>) -> Option<Top> {
        let (own_axis, [moment, axial]) = moments(&system.body)?;
        let start = Start::of(system, gravity, moment)?;
        let roots = roots(&start);
        let up = -gravity / rotation::length(gravity);
        let (upright, axis) = (rotation_to(&up), rotation_to(&own_axis).inverse());
        let lambda = 0.5 * (start.a * roots.span).sqrt();
        let first = roots.first(start.rising);
        let u = argument_of(first.sine, first.cosine, roots.complementary);
        if !u.is_finite() || lambda == 0.0 {
            return None;
        }
        let q = upright.inverse() * system.start.orientation * axis.inverse();
        let momentum = upright.inverse_transform_vector(&system.start.angular_momentum) / moment;
        let change = Quaternion::from_imag(momentum) * q.into_inner() * 0.5;
        let parameter = |heights: [f64; 2], rate: f64, value: [f64; 2], change: [f64; 2]| {
            Parameter::of(heights, rate / (2.0 * lambda), &first, value, change)
        };
        let own_rate =
            if axial == 0.0 { 0.0 } else { start.s * moment * ((moment - axial) / axial / moment) };
        Some(Top {
            alpha: parameter(roots.plus, start.sum, [q.w, q.k], [change.w, change.k]),
            beta: parameter(roots.minus, start.difference, [q.i, q.j], [change.i, change.j]),
            between: roots.between,
            complementary: roots.complementary,
            upright,
            axis,
            own_axis,
            start,
            own_rate,
            moment,
            lambda,
            first,
            u,
        })
    }

    /// The motion at `t` [s].
    pub(super) fn at(&self, system: &System, t: f64) -> Snapshot {
        let u = self.u + self.lambda * t; // (2)
        let after = amplitude(u, self.complementary);
        let (alpha, alpha_phase) = self.parameter(&self.alpha, &after, u);
        let (beta, beta_phase) = self.parameter(&self.beta, &after, u);
        let (w, z) = (alpha * alpha_phase.cos(), alpha * alpha_phase.sin());
        let (x, y) = (beta * beta_phase.cos(), beta * beta_phase.sin());
        let turned = rotation::renormalized(Rotation::new_unchecked(Quaternion::new(w, x, y, z)));
        let own = rotation::turn(&(self.own_axis * (self.own_rate * t)));
        let orientation = rotation::renormalized(self.upright * turned * self.axis * own); // (4)
        let own_axis = orientation * self.own_axis;
        let angular_momentum = own_axis * (self.start.s * self.moment)
            + self.across(alpha, beta, alpha_phase + beta_phase, &after);
        let angular_velocity = angular_momentum / self.moment + own_axis * self.own_rate;
        let arm = orientation * system.body.center;
        Snapshot {
            time: t,
            position: system.origin() + arm,
            velocity: angular_velocity.cross(&arm),
            orientation,
            angular_velocity,
            angular_momentum,
            stretch: 0.0,
        }
    }

    /// L without its part along the axis [kg m²/s], world, by (7).
    fn across(&self, alpha: f64, beta: f64, phi: f64, after: &Amplitude) -> Vector3<f64> {
        let (sine, cosine) = (2.0 * alpha * beta, (alpha - beta) * (alpha + beta));
        let delta = after.cosine.hypot(self.complementary.sqrt() * after.sine);
        let between = self.between;
        let slope = 2.0 * between * self.lambda * after.sine * after.cosine * delta;
        // p − s z = (p − s) + s (1 − z) and (p + s) − s (1 + z): the one that cancels less.
        let turning = if cosine > 0.0 {
            self.start.difference + self.start.s * 2.0 * beta * beta
        } else {
            self.start.sum - self.start.s * 2.0 * alpha * alpha
        };
        let (nodding, turning) = if sine == 0.0 { (0.0, 0.0) } else { (-slope / sine, turning / sine) };
        let (s, c) = phi.sin_cos();
        let (nodes, ahead) = (Vector3::new(c, s, 0.0), Vector3::new(-cosine * s, cosine * c, sine));
        self.upright * (nodes * nodding + ahead * turning) * self.moment
    }

    /// Size, with its sign, and phase of a parameter.
    fn parameter(&self, parameter: &Parameter, after: &Amplitude, u: f64) -> (f64, f64) {
        match parameter.passes {
            [true, _] => return (parameter.size * after.sine, parameter.phase),
            [_, true] => return (parameter.size * after.cosine, parameter.phase),
            _ => {}
        }
        let size = after.cosine.hypot(parameter.ratio.sqrt() * after.sine); // (3)
        let passed = self.passed(parameter.ratio, after, u);
        (parameter.size * size, parameter.phase + parameter.rate * passed)
    }

    /// (6) from the start to u. Where sn no longer tells u, S still tells the rest.
    fn passed(&self, ratio: f64, after: &Amplitude, u: f64) -> f64 {
        let swept = |end: &Amplitude, ratio| self.swept(end, ratio);
        if ratio <= 1.0 || self.complementary == 0.0 {
            return (u - self.u) + (1.0 - ratio) * (swept(after, ratio) - swept(&self.first, ratio));
        }
        let shifted = |end: &Amplitude| swept(&self.a_quarter_later(end), self.complementary / ratio);
        let part = self.complementary * (1.0 - 1.0 / ratio);
        ((u - self.u) + part * (shifted(after) - shifted(&self.first))) / ratio
    }

    /// sn (u + K) = cn/dn, cn (u + K) = −k′ sn/dn.
    fn a_quarter_later(&self, end: &Amplitude) -> Amplitude {
        let Amplitude { half_turns, sine, cosine, .. } = *end;
        let delta = (cosine * cosine + self.complementary * sine * sine).sqrt();
        // The amplitude is past a half turn where it was past a quarter before.
        let past = if (half_turns % 2.0 == 0.0) == (sine > 0.0) { 1.0 } else { 0.0 };
        let past = if sine == 0.0 { 0.0 } else { past };
        Amplitude {
            half_turns: half_turns + past,
            sine: cosine / delta,
            cosine: -self.complementary.sqrt() * sine / delta,
            ..*end
        }
    }

    /// S of (6), by the integral over the amplitude: 2 m times that of a quarter turn, and the rest.
    fn swept(&self, end: &Amplitude, ratio: f64) -> f64 {
        let square = end.cosine * end.cosine;
        // sn and cn change sign together with every half turn of the amplitude.
        let sine = if end.half_turns % 2.0 == 0.0 { end.sine } else { -end.sine };
        let second = square + self.complementary * sine * sine;
        let third = square + ratio * sine * sine;
        let mut sum = sine * sine * sine * integral_of_the_third_kind(square, second, 1.0, third);
        if end.half_turns != 0.0 {
            sum += 2.0 * end.half_turns * integral_of_the_third_kind(0.0, self.complementary, 1.0, ratio);
        }
        sum / 3.0
    }
}

/// A rotation that takes z to a unit vector: the least one, or upside down first where that is far.
fn rotation_to(direction: &Vector3<f64>) -> Rotation {
    let from = |z: Vector3<f64>| {
        let half = Quaternion::from_parts(1.0 + z.dot(direction), z.cross(direction));
        Rotation::new_normalize(half)
    };
    if direction.z < 0.0 {
        return from(-Vector3::z()) * Rotation::new_unchecked(Quaternion::new(0.0, 1.0, 0.0, 0.0));
    }
    from(Vector3::z())
}
