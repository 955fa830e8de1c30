//! Rules with a memory.

use nalgebra::Vector4;

use super::body::{State, V, inertia, over_moments, rates, spin, start, torque};
use super::rotations::{exponential, matrix_of, quaternion_of, slope};
use super::runge_kutta::peskin_rk4;
use super::{Expected, STEP};

pub const THREE: [f64; 3] = [23.0 / 12.0, -16.0 / 12.0, 5.0 / 12.0];
pub const FOUR: [f64; 4] = [55.0 / 24.0, -59.0 / 24.0, 37.0 / 24.0, -9.0 / 24.0];

/// Adams and Bashforth on seven numbers; the weights from the latest derivative to the earliest.
pub fn adams_bashforth(steps: u64, weights: &[f64], cold: bool) -> Expected {
    let mut state = start();
    let mut past: Vec<(Vector4<f64>, V)> = Vec::new();
    for _ in 0..steps {
        let q = quaternion_of(&state.0);
        let (spin, torque) = rates(&state);
        past.insert(0, (slope(&spin, &q), torque));
        if cold && past.len() == 1 {
            past.resize(weights.len(), past[0]);
        }
        state = if past.len() < weights.len() {
            peskin_rk4(&state, STEP)
        } else {
            let sum = weights.iter().zip(&past).fold((q, state.1), |y, (weight, k)| {
                (y.0 + k.0 * (STEP * weight), y.1 + k.1 * (STEP * weight))
            });
            (matrix_of(&sum.0), sum.1)
        };
    }
    Expected::Rigid(state)
}

/// The generalised-α method with ρ = ½: α_m = 0, α_f = ⅓, γ = 5/6, β = 4/9, so that a₁ = ⅔ v̇₁ + ⅓ v̇₀. The unknown is
/// v₁.
pub fn generalized_alpha(steps: u64) -> Expected {
    let h = STEP;
    let own = |s: &State| s.0.transpose() * spin(s);
    let rate = |s: &State| {
        let v = own(s);
        over_moments(&(s.0.transpose() * torque(&s.0) - v.cross(&(inertia() * v))))
    };
    let mut state = start();
    let mut a0 = rate(&state);
    for _ in 0..steps {
        let (v0, rate0) = (own(&state), rate(&state));
        let end = |a1: &V| {
            let r = state.0 * exponential(&(v0 * h + (a0 / 18.0 + a1 * (4.0 / 9.0)) * (h * h)));
            let v = v0 + (a0 + a1 * 5.0) * (h / 6.0);
            (r, r * inertia() * v)
        };
        let mut a1 = a0;
        for _ in 0..60 {
            a1 = (rate(&end(&a1)) * 2.0 + rate0) / 3.0;
        }
        state = end(&a1);
        a0 = a1;
    }
    Expected::Rigid(state)
}
