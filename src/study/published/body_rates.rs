//! Adams–Bashforth on Ω of a free body in its principal axes alone. The history is filled with the first rate of change.
//!
//! ω' = I⁻¹ (I ω × ω): Euler's equations in body axes. Flight simulators integrate them beside an attitude. The
//! schemes of the list step a quaternion and the world momentum instead, and make other errors.
//!
//! Source: Bashforth and Adams 1883; coefficients of orders 2 to 5 in Hairer, Nørsett, Wanner, section III.1.

use nalgebra::Vector3;

use crate::model::System;

/// Name of these rules in the figures, before the order.
const NAME: &str = "body-rates-adams-bashforth-";

/// Weights of the last rates of change, the newest first.
fn weights(order: usize) -> Option<&'static [f64]> {
    Some(match order {
        2 => &[3.0 / 2.0, -1.0 / 2.0],
        3 => &[23.0 / 12.0, -16.0 / 12.0, 5.0 / 12.0],
        4 => &[55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0],
        5 => &[1901.0 / 720.0, -2774.0 / 720.0, 2616.0 / 720.0, -1274.0 / 720.0, 251.0 / 720.0],
        _ => return None,
    })
}

/// The weights that a name asks for.
pub(super) fn order(name: &str) -> Option<&'static [f64]> {
    weights(name.strip_prefix(NAME)?.parse().ok()?)
}

/// Times [s] and Ω in body axes [rad/s] of a free body, before the first of equal steps and after each.
pub(super) fn run(system: &System, weights: &[f64], end: f64, steps: u64) -> Vec<(f64, Vector3<f64>)> {
    let moments = system.body.moments;
    let change = |w: &Vector3<f64>| moments.component_mul(w).cross(w).component_div(&moments);
    let step = end / steps as f64;
    let principal = system.body.principal;
    let axes = system.start.orientation * principal;
    let mut rate = axes.inverse_transform_vector(&system.start.angular_momentum).component_div(&moments);
    let mut history = vec![change(&rate); weights.len()];
    let mut rates = vec![(0.0, principal * rate)];
    for n in 1..=steps {
        let mean: Vector3<f64> = history.iter().zip(weights).map(|(f, weight)| f * *weight).sum();
        rate += mean * step;
        history.rotate_right(1);
        history[0] = change(&rate);
        rates.push((n as f64 * step, principal * rate));
    }
    rates
}
