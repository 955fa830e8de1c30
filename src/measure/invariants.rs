//! Known invariants of tops on a pivot under uniform gravity.
//!
//! With γ = −Rᵀ g and (p, q, r) = Rᵀ Ω in principal axes, c the centre of mass:
//!
//! - L·g for every top: gravity's torque c × M g is across g.
//! - L along the axis of a symmetric top whose centre of mass is on the axis (Lagrange).
//! - K = (p² − q² − ν γ₁)² + (2 p q − ν γ₂)² with ν = M |c|/C where A = B = 2C and c lies in the plane of A and
//!   B, axis 1 along c (Kovalevskaya).

use nalgebra::Vector3;

use super::{Metric, Reading, Sight, read, scale};
use crate::model::body::Body;
use crate::model::forces::Law;
use crate::model::{Snapshot, System};
use crate::rotation;

/// Relative difference of moments that still counts as equal.
const EQUAL: f64 = 1e-12;

/// L·ĝ.
pub(super) const VERTICAL_MOMENTUM: Metric = Metric {
    name: "vertical-momentum",
    unit: "1",
    what: "change of the part of L along gravity, of a body on a pivot, over |L|",
    measure: |sight: &Sight| {
        let gravity = rotation_under_gravity(sight.system)?;
        let direction = gravity / rotation::length(&gravity);
        change(sight, |s| Some(s.angular_momentum.dot(&direction)))
    },
};

/// L along the axis of a Lagrange top.
pub(super) const AXIAL_MOMENTUM: Metric = Metric {
    name: "axial-momentum",
    unit: "1",
    what: "change of the part of L along the axis of a Lagrange top, over |L|",
    measure: |sight: &Sight| {
        rotation_under_gravity(sight.system)?;
        let axis = sight.system.body.principal * lagrange_axis(&sight.system.body)?;
        change(sight, |s| Some(s.angular_momentum.dot(&(s.orientation * axis))))
    },
};

/// Kovalevskaya's K.
pub(super) const KOVALEVSKAYA: Metric = Metric {
    name: "kovalevskaya",
    unit: "1",
    what: "relative change of Kovalevskaya's invariant",
    measure: |sight: &Sight| {
        let gravity = rotation_under_gravity(sight.system)?;
        let frame = kovalevskaya_frame(&sight.system.body)?;
        let invariant = |s: &Snapshot| kovalevskaya(sight.system, &frame, &gravity, s);
        let first = invariant(sight.reference.states.first()?);
        read(sight, |state, _| Some((invariant(state) - first) / first.abs().max(f64::MIN_POSITIVE)))
    },
};

/// Change of a part of L from its start, over the largest |L| of the reference.
fn change(sight: &Sight, part: impl Fn(&Snapshot) -> Option<f64>) -> Option<Reading> {
    let largest = scale(sight, |s| rotation::length(&s.angular_momentum))?;
    let first = part(sight.states.first()?)?;
    read(sight, |state, _| Some((part(state)? - first) / largest))
}

/// The sum of all gravity, for a body on a pivot that nothing else acts on.
fn rotation_under_gravity(system: &System) -> Option<Vector3<f64>> {
    if !system.body.pivoted || system.forces.laws().is_empty() {
        return None;
    }
    let mut sum = Vector3::zeros();
    for law in system.forces.laws() {
        match law {
            Law::Gravity(gravity) => sum += gravity.acceleration,
            _ => return None,
        }
    }
    (rotation::length(&sum) > 0.0).then_some(sum)
}

/// The axis of a symmetric body with its centre of mass on it, principal axes.
fn lagrange_axis(body: &Body) -> Option<Vector3<f64>> {
    let center = body.principal.inverse() * body.center;
    (0..3).find_map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let symmetric = (body.moments[i] - body.moments[j]).abs() <= EQUAL * body.moments.max();
        let on_axis = center[i].abs().max(center[j].abs()) <= EQUAL * rotation::length(&center);
        (symmetric && on_axis).then(|| Vector3::ith(k, 1.0))
    })
}

/// Axes 1, 2 of Kovalevskaya's formula in principal axes, and ν.
struct Kovalevskaya {
    first: Vector3<f64>,
    second: Vector3<f64>,
    strength: f64,
}

fn kovalevskaya_frame(body: &Body) -> Option<Kovalevskaya> {
    let center = body.principal.inverse() * body.center;
    let distance = rotation::length(&center);
    (0..3).find_map(|k| {
        let (a, b, c) = (body.moments[(k + 1) % 3], body.moments[(k + 2) % 3], body.moments[k]);
        let doubled = (a - 2.0 * c).abs().max((b - 2.0 * c).abs()) <= EQUAL * a.max(b);
        let equatorial = distance > 0.0 && center[k].abs() <= EQUAL * distance;
        (doubled && equatorial).then(|| {
            let first = center / distance;
            let second = Vector3::ith(k, 1.0).cross(&first);
            Kovalevskaya { first, second, strength: body.mass * distance / c }
        })
    })
}

fn kovalevskaya(system: &System, frame: &Kovalevskaya, gravity: &Vector3<f64>, s: &Snapshot) -> f64 {
    let to_principal = (s.orientation * system.body.principal).inverse();
    let (spin, up) = (to_principal * s.angular_velocity, to_principal * -gravity);
    let (p, q) = (spin.dot(&frame.first), spin.dot(&frame.second));
    let (g1, g2) = (up.dot(&frame.first) * frame.strength, up.dot(&frame.second) * frame.strength);
    (p * p - q * q - g1).powi(2) + (2.0 * p * q - g2).powi(2)
}
