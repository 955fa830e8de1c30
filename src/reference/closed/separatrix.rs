//! The free body exactly on the separatrix, L² = 2 E I₂: hyperbolic functions, the attitude too.
//!
//! With I₁ < I₂ < I₃, unit l = L/|L|, wⱼ = |L|/Iⱼ, r = (w₁ − w₃)/(w₂ − w₃) > 1 and λ = √((w₁ − w₂)(w₂ − w₃)):
//!
//! (1)  l₂ = tanh u,  l₁ = ± sech u/√r,  l₃ = ± √(1 − 1/r) sech u,  u = u₀ + σ λ t,  σ = sign l₁ l₃
//! (2)  the angle about L: dφ/dt = (w₁ l₁² + w₂ l₂²)/(l₁² + l₂²) = w₂ + (w₁ − w₂)/(1 + r sinh² u)
//! (3)  φ = w₂ t + σ (w₁ − w₂)/λ [atan(√(r − 1) tanh u)/√(r − 1)] between u₀ and u
//! (4)  Q = Z(α₀) Y(θ₀) Z(φ) Y(−θ) Z(−α),  α = atan2(l₂, l₁),  θ = atan2(√(l₁² + l₂²), l₃)
//!
//! (3) since ∫ du/(1 + r sinh² u) = ∫ dT/(1 + (r − 1) T²), T = tanh u. l₂ enters by u, and l₁, l₃ decay to zero without
//! cancellation. Whether a system is there is told exactly, in double-double arithmetic: l₁² I₃ (I₂ − I₁) = l₃² I₁ (I₃ − I₂).
//! The sign σ follows from Euler's equation l₂' = (w₁ − w₃) l₁ l₃.
//!
//! Source: whittaker1937, chapter VI; (2)–(4) derived here.

use nalgebra::{Quaternion, Vector3};

use super::{after, principal_momentum};
use crate::model::System;
use crate::reference::precise::DoubleDouble;
use crate::rotation::{self, Rotation};

/// Axes in the order of their moments, and where the motion is on the curve.
pub(super) struct Separatrix {
    index: [usize; 3],
    /// −1 where the order is left-handed: then the first axis is reversed.
    handed: f64,
    start: Vector3<f64>,
    u: f64,
}

impl Separatrix {
    /// A motion exactly on the separatrix, and not at its end.
    pub(super) fn of(system: &System) -> Option<Separatrix> {
        let moments = system.body.moments;
        let mut index = [0, 1, 2];
        index.sort_by(|i, j| moments[*i].total_cmp(&moments[*j]));
        let momentum = principal_momentum(system);
        let [i, j, k] = index;
        let [a, b, c] = index.map(|i| DoubleDouble::from(moments[i]));
        let square = |x: f64| DoubleDouble::from(x) * DoubleDouble::from(x);
        let side = square(momentum[i]) * c * (b - a) - square(momentum[k]) * a * (c - b);
        if side != DoubleDouble::ZERO || momentum[i] == 0.0 {
            return None;
        }
        let handed = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        let start =
            Vector3::new(handed * momentum[i], momentum[j], momentum[k]) / rotation::length(&momentum);
        // tanh u = l₂ and sech u = √(l₁² + l₃²), so that sinh u is their quotient.
        let u = (start.y / start.x.hypot(start.z)).asinh();
        Some(Separatrix { index, handed, start, u })
    }

    /// The orientation at `t` [s].
    pub(super) fn turned(&self, system: &System, t: f64) -> Rotation {
        let moments = self.index.map(|i| system.body.moments[i]);
        let length = rotation::length(&system.start.angular_momentum);
        let w = |j: usize, k: usize| length * ((moments[k] - moments[j]) / moments[j] / moments[k]);
        let (w12, w23) = (w(0, 1), w(1, 2));
        let (lambda, root) = ((w12 * w23).sqrt(), (w12 / w23).sqrt()); // √(r − 1)
        let sense = if self.start.x * self.start.z > 0.0 { 1.0 } else { -1.0 };
        let u = self.u + sense * lambda * t; // (1)
        let size = self.start.x.hypot(self.start.z).recip() / u.cosh();
        let after_l = Vector3::new(self.start.x * size, u.tanh(), self.start.z * size); // (1)
        let swept = ((root * u.tanh()).atan() - (root * self.start.y).atan()) / root;
        let phi = length / moments[1] * t + sense * w12 / lambda * swept; // (3)
        let angles = |l: &Vector3<f64>| (l.y.atan2(l.x), l.x.hypot(l.y).atan2(l.z));
        let ((alpha, theta), (alpha_after, theta_after)) = (angles(&self.start), angles(&after_l));
        let about = |axis: Vector3<f64>, angle: f64| rotation::turn(&(axis * angle));
        let (y, z) = (Vector3::y(), Vector3::z());
        let turn = about(z, alpha)
            * about(y, theta)
            * about(z, phi)
            * about(y, -theta_after)
            * about(z, -alpha_after); // (4)
        let mut imaginary = Vector3::zeros();
        let [i, j, k] = self.index;
        (imaginary[i], imaginary[j], imaginary[k]) = (self.handed * turn.i, turn.j, turn.k);
        after(system, &Rotation::new_unchecked(Quaternion::from_parts(turn.w, imaginary)))
    }
}
