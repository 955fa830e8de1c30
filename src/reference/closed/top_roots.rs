//! The constants of Lagrange's top and the roots of its cubic, in double-double arithmetic.

use nalgebra::Vector3;

use crate::model::System;
use crate::reference::precise::DoubleDouble;
use crate::rotation::elliptic::{Amplitude, amplitude};

type Triple = [DoubleDouble; 3];

/// What the cubic (1) of [`super::lagrange_top`] is made of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// s = L·e₃/A [rad/s].
    pub s: f64,
    /// p + s [rad/s].
    pub sum: f64,
    /// p − s [rad/s].
    pub difference: f64,
    /// a = 2 M g l/A [1/s²].
    pub a: f64,
    /// Sign of ż.
    pub rising: f64,
    exact: Exact,
}

#[derive(Clone, Copy, Debug)]
struct Exact {
    p: DoubleDouble,
    s: DoubleDouble,
    a: DoubleDouble,
    /// ε.
    energy: DoubleDouble,
    z: DoubleDouble,
}

/// Differences of the roots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roots {
    /// z₀ − z₁.
    pub above: f64,
    /// z₂ − z₀.
    pub below: f64,
    /// z₂ − z₁.
    pub between: f64,
    /// z₃ − z₁.
    pub span: f64,
    /// k′².
    pub complementary: f64,
    /// 1 + z₁ and 1 + z₂.
    pub plus: [f64; 2],
    /// 1 − z₁ and 1 − z₂.
    pub minus: [f64; 2],
}

impl Roots {
    /// sn u₀ with the sign of ż, and cn u₀.
    pub(super) fn first(&self, rising: f64) -> Amplitude {
        let root = |part: f64| (part / self.between).clamp(0.0, 1.0).sqrt();
        let still = self.between <= 0.0;
        let (sine, cosine) = if still { (0.0, 1.0) } else { (root(self.above), root(self.below)) };
        let quarter_period = amplitude(0.0, self.complementary).quarter_period;
        Amplitude { half_turns: 0.0, sine: sine.copysign(rising), cosine, quarter_period }
    }
}

/// Halvings of an interval, to the last bit of a double-double number.
const HALVINGS: usize = 110;

/// Part of p and s in their sum or difference that is rounding of their products.
const ROUNDING: f64 = 1e-29;

fn dot(a: &Triple, b: &Triple) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &Triple, b: &Triple) -> Triple {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn wide(v: &Vector3<f64>) -> Triple {
    [v.x, v.y, v.z].map(DoubleDouble::from)
}

fn unit(v: &Triple) -> Triple {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// The axis in the world: (0, e₃) turned by the start's quaternion, brought to length one.
fn turned(system: &System, v: &Triple) -> Triple {
    let q = system.start.orientation.quaternion();
    let (w, r) = (DoubleDouble::from(q.w), [q.i, q.j, q.k].map(DoubleDouble::from));
    let square = w * w + dot(&r, &r);
    // v + 2 (w r × v + r × (r × v)) / |q|²
    let once = cross(&r, v);
    let twice = cross(&r, &once);
    [0, 1, 2].map(|i| v[i] + (w * once[i] + twice[i]).scaled(2.0) / square)
}

impl Start {
    /// The constants of `system` under `gravity` [m/s²] with A = `moment` [kg m²]; `None` where it stands upright.
    pub(super) fn of(system: &System, gravity: &Vector3<f64>, moment: f64) -> Option<Start> {
        let body = &system.body;
        let up = unit(&wide(&-gravity));
        let axis = turned(system, &unit(&wide(&body.center)));
        let moment = DoubleDouble::from(moment);
        let spin = wide(&system.start.angular_momentum).map(|x| x / moment);
        let (p, s, z) = (dot(&spin, &up), dot(&spin, &axis), dot(&axis, &up));
        let arm = dot(&wide(&body.center), &wide(&body.center)).sqrt();
        let strength = dot(&wide(gravity), &wide(gravity)).sqrt();
        let a = (arm * strength * body.mass.into() / moment).scaled(2.0);
        let across = cross(&spin, &axis);
        let square = dot(&across, &across);
        let energy = z + square / a;
        let tilt = cross(&axis, &up);
        let negligible = |x: DoubleDouble| x.high.abs() <= ROUNDING * (p.high.abs() + s.high.abs());
        let kept = |x: DoubleDouble| if negligible(x) { 0.0 } else { x.high };
        if !a.is_finite() || (dot(&tilt, &tilt).high == 0.0 && square.high == 0.0) {
            return None;
        }
        Some(Start {
            s: s.high,
            sum: kept(p + s),
            difference: kept(p - s),
            a: a.high,
            // ż = v·(Ω × e₃)
            rising: dot(&up, &cross(&spin, &axis)).high,
            exact: Exact { p, s, a, energy, z },
        })
    }
}

/// The roots of (1), halved in from where its signs are known.
pub(super) fn roots(start: &Start) -> Roots {
    let Exact { p, s, a, energy, z } = start.exact;
    let one = DoubleDouble::ONE;
    let cubic = |z: DoubleDouble| {
        let turning = p - s * z;
        a * (energy - z) * (one - z) * (one + z) - turning * turning
    };
    let halved = |mut negative: DoubleDouble, mut positive: DoubleDouble| {
        for _ in 0..HALVINGS {
            let middle = (negative + positive).scaled(0.5);
            if cubic(middle).high < 0.0 { negative = middle } else { positive = middle }
        }
        positive
    };
    let mut far = DoubleDouble::from(2.0);
    while cubic(far).high < 0.0 && far.high < 1e300 {
        far = far.scaled(2.0);
    }
    let first = if start.sum == 0.0 { -one } else { halved(-one, z) };
    // With p = s, 1 − z is a factor, and the axis gets there where ε is not below 1.
    let second = if start.difference == 0.0 && energy >= one { one } else { halved(one, z) };
    let third = halved(one, far);
    let difference = |a: DoubleDouble, b: DoubleDouble| (a - b).high.max(0.0);
    let span = difference(third, first);
    Roots {
        above: difference(z, first),
        below: difference(second, z),
        between: difference(second, first),
        span,
        complementary: difference(third, second) / span,
        plus: [difference(first, -one), difference(second, -one)],
        minus: [difference(one, first), difference(one, second)],
    }
}
