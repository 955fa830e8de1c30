//! The centre of mass by itself: a parabola, or a point on linear springs with drag.
//!
//! ```text
//! (1)  X = X₀ + U₀ t + ½ g t²,  U = U₀ + g t
//! (2)  X'' + 2 β X' + κ (X − X∞) = 0,   β = c/(2M),  κ = k/M,  X∞ = Σ kᵢ aᵢ/k + g/κ
//!      y = X − X∞:  y = e^{−βt} [y₀ C + (U₀ + β y₀) S],  U = e^{−βt} [U₀ C − (β U₀ + κ y₀) S]
//!      C = cos ωt, S = sin ωt/ω, ω² = κ − β²  (cosh, sinh for ω² < 0; 1, t at ω² = 0)
//! (3)  without springs:  U = U∞ + (U₀ − U∞) e^{−γt},  X = X₀ + U∞ t + (U₀ − U∞) (1 − e^{−γt})/γ
//!      γ = c/M,  U∞ = g/γ
//! ```
//!
//! k and c are sums over springs and drag; springs of rest length zero only. Overdamped, e^{−βt} goes into the
//! hyperbolic functions, so that nothing overflows. Source: whittaker1937, chapters II and IX.

use nalgebra::Vector3;

use crate::model::System;
use crate::model::forces::{Attachment, Law, Spring};
use crate::rotation::Rotation;

/// How the centre of mass moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Translation {
    /// With the body, about a pivot.
    Held,
    /// By (1), under g [m/s²].
    Falling(Vector3<f64>),
    /// By (2).
    Springs {
        /// X∞ [m].
        rest: Vector3<f64>,
        /// κ [1/s²].
        stiffness: f64,
        /// β [1/s].
        damping: f64,
    },
    /// By (3).
    Drag {
        /// g [m/s²].
        gravity: Vector3<f64>,
        /// γ [1/s].
        rate: f64,
    },
}

/// A point under linear springs, drag and uniform gravity only.
pub(super) fn on_springs(system: &System) -> Option<Translation> {
    let (mut gravity, mut pull) = (Vector3::zeros(), Vector3::zeros());
    let (mut stiffness, mut drag) = (0.0, 0.0);
    for law in system.forces.laws() {
        match law {
            Law::Gravity(law) => gravity += law.acceleration,
            Law::Spring(spring) if spring.rest_length == 0.0 && holds_at_center(system, spring) => {
                stiffness += spring.stiffness;
                pull += spring.anchor * spring.stiffness;
                drag += spring.damping;
            }
            Law::Drag(law) => {
                drag += (0..system.body.points.len()).map(|k| law.coefficient.at(k)).sum::<f64>()
            }
            _ => return None,
        }
    }
    let mass = system.body.mass;
    if stiffness > 0.0 {
        let rest = (pull + gravity * mass) / stiffness;
        return Some(Translation::Springs {
            rest,
            stiffness: stiffness / mass,
            damping: drag / (2.0 * mass),
        });
    }
    Some(Translation::Drag { gravity, rate: drag / mass })
}

fn holds_at_center(system: &System, spring: &Spring) -> bool {
    match &spring.attachment {
        Attachment::Point(index) => {
            system.body.points.get(*index).is_some_and(|p| p.position == Vector3::zeros())
        }
        Attachment::At(position) => *position == Vector3::zeros(),
    }
}

impl Translation {
    pub(super) fn name(&self) -> &'static str {
        match self {
            Translation::Held => "",
            Translation::Falling(gravity) if *gravity == Vector3::zeros() => "straight line",
            Translation::Falling(_) => "parabola",
            Translation::Springs { .. } => "point on linear springs, by exponentials",
            Translation::Drag { .. } => "point with linear drag, by exponentials",
        }
    }

    /// X_cm [m] and U_cm [m/s] at `t` [s].
    pub(super) fn at(
        &self,
        system: &System,
        orientation: &Rotation,
        spin: &Vector3<f64>,
        t: f64,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let (x, u) = (system.start.position, system.start.velocity);
        match *self {
            Translation::Held => {
                let arm = orientation * system.body.center;
                (system.origin() + arm, spin.cross(&arm))
            }
            Translation::Falling(gravity) => (x + u * t + gravity * (0.5 * t * t), u + gravity * t), // (1)
            Translation::Springs { rest, stiffness, damping } => {
                let y = x - rest;
                let (cosine, sine) = decaying(stiffness - damping * damping, damping, t);
                let position = rest + y * cosine + (u + y * damping) * sine; // (2)
                (position, u * cosine - (u * damping + y * stiffness) * sine) // (2)
            }
            Translation::Drag { gravity, rate } => {
                // (1 − e^{−γt})/γ and (t − that)/γ, which stay good for small γ.
                let gone = if rate == 0.0 { t } else { -(-rate * t).exp_m1() / rate };
                let fall = settling(rate, t, gone);
                (x + u * gone + gravity * fall, u + (gravity - u * rate) * gone) // (3)
            }
        }
    }
}

/// (t − (1 − e^{−γt})/γ)/γ: a series for small γ t, where the difference cancels.
fn settling(rate: f64, t: f64, gone: f64) -> f64 {
    let x = rate * t;
    if x > 0.5 {
        return (t - gone) / rate;
    }
    // t² Σ (−x)ʲ/(j + 2)! by Horner's rule; 0.5¹⁶/18! < 1e-20.
    t * t * (0..16).rev().fold(0.0, |sum, j| (1.0 - sum * x) / f64::from(j + 2))
}

/// e^{−βt} C and e^{−βt} S of (2).
fn decaying(square: f64, damping: f64, t: f64) -> (f64, f64) {
    if square > 0.0 {
        let omega = square.sqrt();
        let (sine, cosine) = (omega * t).sin_cos();
        let decay = (-damping * t).exp();
        return (decay * cosine, decay * sine / omega);
    }
    let omega = (-square).sqrt();
    let slow = (-(damping - omega) * t).exp();
    // e^{−βt} sinh ωt/ω = e^{−(β−ω)t} (1 − e^{−2ωt})/(2ω).
    let half = if omega == 0.0 { t } else { -(-2.0 * omega * t).exp_m1() / (2.0 * omega) };
    (slow * (1.0 - omega * half), slow * half)
}
