//! Rules with a memory.

use nalgebra::{Matrix3, Vector4};

use super::body::{M, State, V, center, gravity, inertia, over_moments, rates, spin, start, torque};
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
/// The same on q and Rᵀ Ω; all earlier derivatives are the first.
pub fn adams_bashforth_body(steps: u64, weights: &[f64]) -> Expected {
    let (r, _) = start();
    let (mut q, mut v) = (quaternion_of(&r), r.transpose() * spin(&start()));
    let mut past: Vec<(Vector4<f64>, V)> = Vec::new();
    for _ in 0..steps {
        let r = matrix_of(&q);
        let rate = over_moments(&(r.transpose() * torque(&r) - v.cross(&(inertia() * v))));
        past.insert(0, (slope(&(r * v), &q), rate));
        if past.len() == 1 {
            past.resize(weights.len(), past[0]);
        }
        for (weight, (turning, rate)) in weights.iter().zip(&past) {
            q += turning * (STEP * weight);
            v += rate * (STEP * weight);
        }
        q /= q.norm();
    }
    let r = matrix_of(&q);
    Expected::Rigid((r, r * inertia() * v))
}

/// Mass of the top.
const MASS: f64 = 2.0;

/// (exp(v̂) − E) r by the series, which has no difference of like numbers.
fn displacement(v: &V, r: &V) -> V {
    let (mut term, mut sum) = (*r, V::zeros());
    for k in 1..30 {
        term = v.cross(&term) / f64::from(k);
        sum += term;
    }
    sum
}

/// Centre of mass and rotation under generalised-α with ρ = 0.9, held to the pivot by a force λ: the balance of moments about the
/// centre of mass is solved for the algorithmic acceleration by Newton's method on differences.
pub fn generalized_alpha_constrained(steps: u64) -> Expected {
    let (h, rho) = (STEP, 0.9);
    let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
    let gamma = 0.5 + alpha_f - alpha_m;
    let beta = 0.25 * (gamma + 0.5f64).powi(2);
    let (c, g) = (center() / MASS, gravity());
    let about_center = inertia() - (M::identity() * c.dot(&c) - c * c.transpose()) * MASS;
    let (mut r, l) = start();
    let mut w = spin(&(r, l));
    let wd = r * over_moments(&(r.transpose() * (torque(&r) - w.cross(&l))));
    let mut u = w.cross(&(r * c));
    let mut real = (wd, wd.cross(&(r * c)) + w.cross(&u));
    let mut old = real;
    for _ in 0..steps {
        let end = |a: &V| {
            let turn = (w + (old.0 * (0.5 - beta) + a * beta) * h) * h;
            let mean = (displacement(&turn, &(r * c)) / h - u) / h;
            let b = (mean - old.1 * (0.5 - beta)) / beta;
            let real_of = |new: V, old: V, real: V| {
                (new * (1.0 - alpha_m) + old * alpha_m - real * alpha_f) / (1.0 - alpha_f)
            };
            let after = (real_of(*a, old.0, real.0), real_of(b, old.1, real.1));
            (exponential(&turn) * r, w + (old.0 * (1.0 - gamma) + a * gamma) * h, b, after)
        };
        let moment = |a: &V| {
            let (r, w, _, (wd, ud)) = end(a);
            let j = r * about_center * r.transpose();
            let force = (ud - g) * MASS;
            j * wd + w.cross(&(j * w)) + (r * c).cross(&force)
        };
        let mut a = old.0;
        for _ in 0..12 {
            let here = moment(&a);
            let columns =
                [V::x(), V::y(), V::z()].map(|e| (moment(&(a + e * 1e-4)) - moment(&(a - e * 1e-4))) / 2e-4);
            a -= Matrix3::from_columns(&columns).try_inverse().expect("regular") * here;
        }
        let (turned, spun, b, after) = end(&a);
        u += (old.1 * (1.0 - gamma) + b * gamma) * h;
        (r, w, real, old) = (turned, spun, after, (a, b));
    }
    Expected::Rigid((r, r * inertia() * r.transpose() * w))
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
