//! Explicit one-step rules.

use super::body::{M, Rates, State, V, advance, inertia, mixed, over_moments, rates, spin, torque};
use super::rotations::{cayley, commutator, exponential, matrix_of, quaternion_of, slope};

pub fn euler(s: &State, h: f64) -> State {
    advance(s, h, &rates(s))
}

pub fn peskin_rk2(s: &State, h: f64) -> State {
    advance(s, h, &rates(&advance(s, h / 2.0, &rates(s))))
}

pub fn heun(s: &State, h: f64) -> State {
    let k0 = rates(s);
    advance(s, h, &mixed(&[(0.5, k0), (0.5, rates(&advance(s, h, &k0)))]))
}

pub fn ralston(s: &State, h: f64) -> State {
    let k0 = rates(s);
    advance(s, h, &mixed(&[(0.25, k0), (0.75, rates(&advance(s, h / 1.5, &k0)))]))
}

pub fn peskin_cayley(s: &State, h: f64) -> State {
    let by_cayley = |s: &State, h: f64, k: &Rates| (cayley(&(k.0 * h)) * s.0, s.1 + k.1 * h);
    by_cayley(s, h, &rates(&by_cayley(s, h / 2.0, &rates(s))))
}

pub fn peskin_rk3(s: &State, h: f64) -> State {
    let k1 = rates(s);
    let s2 = advance(s, h / 3.0, &k1);
    let k3 = rates(&advance(s, h / 1.5, &rates(&s2)));
    advance(&s2, h, &mixed(&[(-1.0 / 12.0, k1), (0.75, k3)]))
}

pub fn peskin_rk4(s: &State, h: f64) -> State {
    let k1 = rates(s);
    let s2 = advance(s, h / 2.0, &k1);
    let k2 = rates(&s2);
    let k3 = rates(&advance(s, h / 2.0, &k2));
    let k4 = rates(&advance(&s2, h, &mixed(&[(1.0, k3), (-0.5, k1)])));
    let (a, b, c) = (1.0 / 4.0, 1.0 / 6.0, -1.0 / 12.0);
    let half = advance(s, h, &mixed(&[(a, k1), (b, k2), (b, k3), (c, k4)]));
    advance(&half, h, &mixed(&[(c, k1), (b, k2), (b, k3), (a, k4)]))
}

pub fn course_notes(s: &State, h: f64) -> State {
    let moved = exponential(&(spin(s) * h)) * s.0;
    (moved, s.1 + torque(&moved) * h)
}

pub fn crouch_grossman_3(s: &State, h: f64) -> State {
    let k1 = rates(s);
    let k2 = rates(&advance(s, 0.75 * h, &k1));
    let k3 = rates(&advance(&advance(s, 119.0 / 216.0 * h, &k1), 17.0 / 108.0 * h, &k2));
    let two = advance(&advance(s, 13.0 / 51.0 * h, &k1), -2.0 / 3.0 * h, &k2);
    advance(&two, 24.0 / 17.0 * h, &k3)
}

/// dexp⁻¹ by commutators of matrices.
pub fn rkmk4(s: &State, h: f64) -> State {
    let back = |u: V, k: Rates| {
        let once = commutator(&u, &k.0);
        (k.0 - once / 2.0 + commutator(&u, &once) / 12.0, k.1)
    };
    let k1 = rates(s);
    let k2 = back(k1.0 * (h / 2.0), rates(&advance(s, h / 2.0, &k1)));
    let k3 = back(k2.0 * (h / 2.0), rates(&advance(s, h / 2.0, &k2)));
    let k4 = back(k3.0 * h, rates(&advance(s, h, &k3)));
    advance(s, h, &mixed(&[(1.0 / 6.0, k1), (1.0 / 3.0, k2), (1.0 / 3.0, k3), (1.0 / 6.0, k4)]))
}

/// ∫₀ᶜ of the line through (c₁, k₁) and (c₂, k₂), and the commutator.
pub fn magnus_4(s: &State, h: f64) -> State {
    let root = 3f64.sqrt();
    let (c1, c2) = (0.5 - root / 6.0, 0.5 + root / 6.0);
    let expanded = |c: f64, k1: Rates, k2: Rates| {
        let second = (c * c / 2.0 - c * c1) / (c2 - c1);
        let mean = mixed(&[(c - second, k1), (second, k2)]);
        (mean.0 + commutator(&k2.0, &k1.0) * (c.powi(3) * root / 12.0 * h), mean.1)
    };
    let (mut k1, mut k2) = (rates(s), rates(s));
    for _ in 0..3 {
        let at = |c| rates(&advance(s, h, &expanded(c, k1, k2)));
        (k1, k2) = (at(c1), at(c2));
    }
    advance(s, h, &expanded(1.0, k1, k2))
}

/// In body axes, R times exponentials.
pub fn cf4(s: &State, h: f64) -> State {
    let body = |s: &State| (over_moments(&(s.0.transpose() * s.1)), torque(&s.0));
    let turned = |s: &State, h: f64, k: Rates| (s.0 * exponential(&(k.0 * h)), s.1 + k.1 * h);
    let k1 = body(s);
    let s2 = turned(s, h / 2.0, k1);
    let k2 = body(&s2);
    let k3 = body(&turned(s, h / 2.0, k2));
    let k4 = body(&turned(&s2, h, mixed(&[(1.0, k3), (-0.5, k1)])));
    let half = mixed(&[(3.0, k1), (2.0, k2), (2.0, k3), (-1.0, k4)]);
    let rest = mixed(&[(-1.0, k1), (2.0, k2), (2.0, k3), (3.0, k4)]);
    turned(&turned(s, h / 12.0, half), h / 12.0, rest)
}

pub fn rk4_quaternion((r, l): &State, h: f64) -> State {
    let q0 = quaternion_of(r);
    let f = |q: &nalgebra::Vector4<f64>, l: &V| {
        let k = rates(&(matrix_of(q), *l));
        (slope(&k.0, q), k.1)
    };
    let k1 = f(&q0, l);
    let k2 = f(&(q0 + k1.0 * (h / 2.0)), &(l + k1.1 * (h / 2.0)));
    let k3 = f(&(q0 + k2.0 * (h / 2.0)), &(l + k2.1 * (h / 2.0)));
    let k4 = f(&(q0 + k3.0 * h), &(l + k3.1 * h));
    let q1 = q0 + (k1.0 + (k2.0 + k3.0) * 2.0 + k4.0) * (h / 6.0);
    (matrix_of(&q1), l + (k1.1 + (k2.1 + k3.1) * 2.0 + k4.1) * (h / 6.0))
}

/// In body axes; the tableau as it is printed with the other sign of the root.
pub fn cooper_verner_8((r, l): &State, h: f64) -> State {
    let s = -21f64.sqrt();
    let a: [Vec<f64>; 11] = [
        vec![],
        vec![0.5],
        vec![0.25, 0.25],
        vec![1.0 / 7.0, (-7.0 + 3.0 * s) / 98.0, (21.0 - 5.0 * s) / 49.0],
        vec![(11.0 - s) / 84.0, 0.0, (18.0 - 4.0 * s) / 63.0, (21.0 + s) / 252.0],
        vec![(5.0 - s) / 48.0, 0.0, (9.0 - s) / 36.0, (-231.0 - 14.0 * s) / 360.0, (63.0 + 7.0 * s) / 80.0],
        vec![
            (10.0 + s) / 42.0,
            0.0,
            (-432.0 - 92.0 * s) / 315.0,
            (633.0 + 145.0 * s) / 90.0,
            (-504.0 - 115.0 * s) / 70.0,
            (63.0 + 13.0 * s) / 35.0,
        ],
        vec![1.0 / 14.0, 0.0, 0.0, 0.0, (14.0 + 3.0 * s) / 126.0, (13.0 + 3.0 * s) / 63.0, 1.0 / 9.0],
        vec![
            1.0 / 32.0,
            0.0,
            0.0,
            0.0,
            (91.0 + 21.0 * s) / 576.0,
            11.0 / 72.0,
            (-385.0 + 75.0 * s) / 1152.0,
            (63.0 - 13.0 * s) / 128.0,
        ],
        vec![
            1.0 / 14.0,
            0.0,
            0.0,
            0.0,
            1.0 / 9.0,
            (-733.0 + 147.0 * s) / 2205.0,
            (515.0 - 111.0 * s) / 504.0,
            (-51.0 + 11.0 * s) / 56.0,
            (132.0 - 28.0 * s) / 245.0,
        ],
        vec![
            0.0,
            0.0,
            0.0,
            0.0,
            (-42.0 - 7.0 * s) / 18.0,
            (-18.0 - 28.0 * s) / 45.0,
            (-273.0 + 53.0 * s) / 72.0,
            (301.0 - 53.0 * s) / 72.0,
            (28.0 + 28.0 * s) / 45.0,
            (49.0 + 7.0 * s) / 18.0,
        ],
    ];
    let (q0, l0) = (quaternion_of(r), r.transpose() * l);
    let mut k: Vec<(nalgebra::Vector4<f64>, V)> = Vec::new();
    let moved = |weights: &[f64], k: &[(nalgebra::Vector4<f64>, V)]| {
        weights.iter().zip(k).fold((q0, l0), |(q, l), (w, k)| (q + k.0 * (w * h), l + k.1 * (w * h)))
    };
    for row in &a {
        let (q, l) = moved(row, &k);
        let r = matrix_of(&q);
        let (spin, torque) = rates(&(r, r * l));
        k.push((slope(&spin, &q), l.cross(&(r.transpose() * spin)) + r.transpose() * torque));
    }
    let (side, middle) = (49.0 / 180.0, 16.0 / 45.0);
    let (q1, l1) = moved(&[0.05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, side, middle, side, 0.05], &k);
    let r1 = matrix_of(&q1);
    (r1, r1 * l1)
}

/// Gram and Schmidt's process as a QR factorisation with a positive diagonal.
fn orthonormal(a: &M) -> M {
    let factors = a.qr();
    factors.q() * M::from_diagonal(&factors.r().diagonal().map(f64::signum))
}

pub fn rk4_matrix((a, l): &State, h: f64) -> State {
    let f = |a: &M, l: &V| {
        let k = rates(&(orthonormal(a), *l));
        (k.0.cross_matrix() * a, k.1)
    };
    let k1 = f(a, l);
    let k2 = f(&(a + k1.0 * (h / 2.0)), &(l + k1.1 * (h / 2.0)));
    let k3 = f(&(a + k2.0 * (h / 2.0)), &(l + k2.1 * (h / 2.0)));
    let k4 = f(&(a + k3.0 * h), &(l + k3.1 * h));
    let end = a + (k1.0 + (k2.0 + k3.0) * 2.0 + k4.0) * (h / 6.0);
    (orthonormal(&end), l + (k1.1 + (k2.1 + k3.1) * 2.0 + k4.1) * (h / 6.0))
}

pub fn buss(s: &State, h: f64) -> State {
    let (spin, torque0) = rates(s);
    let inverse = s.0 * inertia().try_inverse().expect("regular") * s.0.transpose();
    let change = inverse * (torque0 - spin.cross(&s.1));
    let mean = spin + change * (h / 2.0) + commutator(&change, &spin) * (h * h / 12.0);
    let r = exponential(&(mean * h)) * s.0;
    (r, s.1 + (torque0 + torque(&r)) * (h / 2.0))
}

/// Moves by a spin about body axes of the old attitude: the linear quaternion update over its length is Cayley's map.
fn moved(s: &State, h: f64, spin: &V) -> State {
    let world = s.0 * spin;
    let r = cayley(&(world * h)) * s.0;
    (r, r * inertia() * r.transpose() * world)
}

pub fn no_gyro(s: &State, h: f64) -> State {
    let own = s.0.transpose();
    moved(s, h, &(over_moments(&(own * s.1)) + over_moments(&(own * torque(&s.0))) * h))
}

fn with_explicit_gyro(s: &State, h: f64) -> State {
    let own = s.0.transpose();
    let m = own * s.1;
    let spin = over_moments(&m);
    moved(s, h, &(spin + over_moments(&(own * torque(&s.0) - spin.cross(&m))) * h))
}

pub fn explicit_gyro(s: &State, h: f64) -> State {
    with_explicit_gyro(s, h)
}

pub fn momentum_clamped(s: &State, h: f64) -> State {
    let (r, l) = with_explicit_gyro(s, h);
    (r, l.normalize() * (s.1 + torque(&s.0) * h).norm())
}

/// One Newton step in world axes, where the scheme's is in body axes.
pub fn implicit_gyro(s: &State, h: f64) -> State {
    let world = s.0 * inertia() * s.0.transpose();
    let guess = spin(s) + world.try_inverse().expect("regular") * torque(&s.0) * h;
    let left = guess.cross(&(world * guess)) * h;
    let jacobian = world + (guess.cross_matrix() * world - (world * guess).cross_matrix()) * h;
    let spin = guess - jacobian.try_inverse().expect("regular") * left;
    moved(s, h, &(s.0.transpose() * spin))
}
