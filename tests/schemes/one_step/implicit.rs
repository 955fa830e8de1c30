//! Implicit rules, solved by plain repetition of other forms of their equations.

use nalgebra::Vector4;

use super::body::{State, V, advance, inertia, over_moments, rates, torque};
use super::rotations::{cayley, exponential, matrix_of, quaternion_of, slope};

/// Repetitions: each gains a digit at least.
const REPETITIONS: usize = 60;

fn solved<T>(first: T, mut next: impl FnMut(&T) -> T) -> T {
    (0..REPETITIONS).fold(first, |value, _| next(&value))
}

/// In (m₀, m₁); the torque of the matrix halfway, exp of half the turn.
pub fn midpoint((r0, l0): &State, h: f64) -> State {
    let m0 = r0.transpose() * l0;
    let turn = |m1: &V| {
        let spin = over_moments(&((m0 + m1) / 2.0));
        let half = spin.normalize() * (h * spin.norm() / 2.0).atan();
        (spin, exponential(&half))
    };
    let m1 = solved(m0, |m1| {
        let (spin, half) = turn(m1);
        let halfway = r0 * half;
        m0 + (((m0 + m1) / 2.0).cross(&spin) + halfway.transpose() * torque(&halfway)) * h
    });
    let (spin, half) = turn(&m1);
    let r1 = r0 * half * half;
    assert!((r1 - r0 * cayley(&(spin * h))).amax() < 1e-14);
    (r1, r1 * m1)
}

/// In body axes, the spin at the end as the unknown.
pub fn simo_wong((r0, l0): &State, h: f64) -> State {
    let w0 = over_moments(&(r0.transpose() * l0));
    let end = |w1: &V| {
        let r1 = r0 * exponential(&((w0 + w1) * (h / 2.0)));
        (r1, l0 + (torque(r0) + torque(&r1)) * (h / 2.0))
    };
    end(&solved(w0, |w1| {
        let (r1, l1) = end(w1);
        over_moments(&(r1.transpose() * l1))
    }))
}

pub fn liemid(s: &State, h: f64) -> State {
    let middle = solved(rates(s), |k| rates(&advance(s, h / 2.0, k)));
    advance(s, h, &middle)
}

/// Free turns in body axes: Ψ = s I⁻¹ π½ with π½ = exp(−Ψ/2) π₀.
pub fn liemid_explicit((r0, l0): &State, h: f64) -> State {
    let l = l0 + torque(r0) * (h / 2.0);
    let mut r = *r0;
    for _ in 0..2 {
        let p0 = r.transpose() * l;
        let turn = solved(V::zeros(), |turn| over_moments(&(exponential(&(turn / -2.0)) * p0)) * (h / 2.0));
        r *= exponential(&turn);
    }
    (r, l + torque(&r) * (h / 2.0))
}

pub fn lie_verlet((r0, l0): &State, h: f64) -> State {
    let l = l0 + torque(r0) * (h / 2.0);
    let m = r0.transpose() * l;
    let spin = solved(V::zeros(), |w| {
        let own = inertia() * w;
        over_moments(&(m - w.cross(&own) * (h / 2.0) - w * (w.dot(&own) * h * h / 4.0)))
    });
    let r1 = r0 * cayley(&(spin * h));
    (r1, l + torque(&r1) * (h / 2.0))
}

/// Cayley's turn of half the time, taken twice.
pub fn omelyan((r0, l0): &State, h: f64) -> State {
    let l = l0 + torque(r0) * (h / 2.0);
    let half = solved(nalgebra::Matrix3::identity(), |half| {
        let halfway = half * r0;
        cayley(&(halfway * over_moments(&(halfway.transpose() * l)) * (h / 2.0)))
    });
    let r1 = half * half * r0;
    (r1, l + torque(&r1) * (h / 2.0))
}

/// y = (q, L), seven numbers, with the derivatives of the stages as the unknowns.
fn gauss_legendre<const S: usize>((r0, l0): &State, h: f64, a: [[f64; S]; S], b: [f64; S]) -> State {
    let q0 = quaternion_of(r0);
    let at = |weights: &[f64; S], k: &[(Vector4<f64>, V); S]| {
        let sum = weights.iter().zip(k).map(|(weight, k)| (k.0 * (h * weight), k.1 * (h * weight)));
        sum.fold((q0, *l0), |y, part| (y.0 + part.0, y.1 + part.1))
    };
    let f = |(q, l): (Vector4<f64>, V)| {
        let (spin, torque) = rates(&(matrix_of(&q), l));
        (slope(&spin, &q), torque)
    };
    let stages = solved([f((q0, *l0)); S], |k| a.map(|row| f(at(&row, k))));
    let (q1, l1) = at(&b, &stages);
    (matrix_of(&q1), l1)
}

pub fn gauss_legendre_4(s: &State, h: f64) -> State {
    let root = 3f64.sqrt() / 6.0;
    gauss_legendre(s, h, [[0.25, 0.25 - root], [0.25 + root, 0.25]], [0.5, 0.5])
}

pub fn gauss_legendre_6(s: &State, h: f64) -> State {
    let root = 15f64.sqrt();
    let a = [
        [5.0 / 36.0, 2.0 / 9.0 - root / 15.0, 5.0 / 36.0 - root / 30.0],
        [5.0 / 36.0 + root / 24.0, 2.0 / 9.0, 5.0 / 36.0 - root / 24.0],
        [5.0 / 36.0 + root / 30.0, 2.0 / 9.0 + root / 15.0, 5.0 / 36.0],
    ];
    gauss_legendre(s, h, a, [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0])
}
