//! Rotations as sums and products alone, for one body or for many side by side: what the models step with.
//!
//! A rotation vector v turns by the quaternion (c, s v/2), c = cos(|v|/2), s = sin(|v|/2)/(|v|/2), which come with the arithmetic.
//!
//! (1)  R = axes of q by its products;  Ω = R I⁻¹ Rᵀ L
//! (2)  q₁ = (c, s v/2) · q (3 − |q|²)/2                          the length of q put right before it is turned
//!
//! (2) puts right what the last turn left of |q| = 1, a few rounding units, so that it does not add up; the turn
//! does not wait for it.

use crate::arithmetic::{Number, Real};

/// 1/√(1 + e) = 1 − 1/2 e + 3/8 e² for |e| ≤ [`LARGEST_EXCESS`](crate::arithmetic::Real::LARGEST_EXCESS).
#[inline(always)]
pub fn inverse_root<T: Number>(e: T) -> T {
    e.like(1.0) - (e * 0.5 - (e * e) * (3.0 / 8.0))
}

/// x s.
#[inline(always)]
pub fn scaled<T: Number>(x: [T; 3], s: T) -> [T; 3] {
    [x[0] * s, x[1] * s, x[2] * s]
}

/// a + b.
#[inline(always)]
pub fn plus<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a − b.
#[inline(always)]
pub fn minus<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a times b, part by part.
#[inline(always)]
pub fn parts<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// a × b.
#[inline(always)]
pub fn cross<T: Number>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The product of two quaternions.
#[inline(always)]
pub fn times<T: Number>(a: [T; 4], b: [T; 4]) -> [T; 4] {
    [
        a[0] * b[0] - (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]),
        a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]),
        a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]),
        a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1]),
    ]
}

/// a · b.
#[inline(always)]
pub fn dot<T: Number>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Rows of the matrix of a unit quaternion (w, x, y, z), by (1).
#[inline(always)]
pub fn axes<T: Number>(q: [T; 4]) -> [[T; 3]; 3] {
    let [w, x, y, z] = q;
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (xx, yy, zz) = (x * x2, y * y2, z * z2);
    let (xy, xz, yz) = (x * y2, x * z2, y * z2);
    let (wx, wy, wz) = (w * x2, w * y2, w * z2);
    let one = w.like(1.0);
    [
        [one - (yy + zz), xy - wz, xz + wy],
        [xy + wz, one - (xx + zz), yz - wx],
        [xz - wy, yz + wx, one - (xx + yy)],
    ]
}

/// A x.
#[inline(always)]
pub fn apply<T: Number>(a: &[[T; 3]; 3], x: [T; 3]) -> [T; 3] {
    [dot(a[0], x), dot(a[1], x), dot(a[2], x)]
}

/// First and third column of the matrix of a unit quaternion (w, x, y, z).
#[inline(always)]
pub fn outer_columns<T: Number>(q: [T; 4]) -> [[T; 3]; 2] {
    let [w, x, y, z] = q;
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (one, yy) = (y.like(1.0), y * y2);
    let (xz, wy) = (x * z2, w * y2);
    [[one - (yy + z * z2), x * y2 + w * z2, xz - wy], [xz + wy, y * z2 - w * x2, one - (x * x2 + yy)]]
}

/// Ω by (1) with the axes of q/|q|, for a quaternion of any length, and s q̇ = s/2 Ω q = s/2 q ω with ω = I⁻¹ Rᵀ L in
/// principal axes; `half` is s/2.
///
/// The division by |q|² stands last, so that nothing waits for it.
#[inline(always)]
pub fn spin_at<T: Real>(q: [T; 4], half: T, inverse_moments: [T; 3], momentum: [T; 3]) -> ([T; 3], [T; 4]) {
    let [w, x, y, z] = q;
    let length = (w * w + x * x) + (y * y + z * z);
    let shrink = half / length;
    let (x2, y2, z2) = (x + x, y + y, z + z);
    let (same, other, sum, rest) = (w * w - y * y, x * x - z * z, w * w - x * x, y * y - z * z);
    let (xy, wz, xz, wy, yz, wx) = (x * y2, w * z2, x * z2, w * y2, y * z2, w * x2);
    let i = dot([same + other, xy + wz, xz - wy], momentum) * inverse_moments[0];
    let j = dot([xy - wz, sum + rest, yz + wx], momentum) * inverse_moments[1];
    let k = dot([xz + wy, yz - wx, same - other], momentum) * inverse_moments[2];
    let rate = [
        ((x * -i) - y * j) - z * k,
        w * i + (y * k - z * j),
        w * j + (z * i - x * k),
        w * k + (x * j - y * i),
    ];
    // Ω = (Ω q) q⁻¹.
    let [p, a, b, c] = rate;
    let spin = [
        (a * w - p * x) + (c * y - b * z),
        (b * w - p * y) + (a * z - c * x),
        (c * w - p * z) + (b * x - a * y),
    ];
    let moved = [rate[0] * shrink, rate[1] * shrink, rate[2] * shrink, rate[3] * shrink];
    (scaled(spin, T::one() / (length * length)), moved)
}

/// (0, v) q.
#[inline(always)]
pub fn pure_times<T: Number>(v: [T; 3], q: [T; 4]) -> [T; 4] {
    let ([i, j, k], [w, x, y, z]) = (v, q);
    [
        w.like(0.0) - (i * x + j * y + k * z),
        i * w + (j * z - k * y),
        j * w + (k * x - i * z),
        k * w + (i * y - j * x),
    ]
}

/// Ω by (1).
#[inline(always)]
pub fn spin<T: Number>(columns: &[[T; 3]; 2], inverse_moments: [T; 3], momentum: [T; 3]) -> [T; 3] {
    let [a, b, c] = inverse_moments;
    let [x, z] = *columns;
    let p = dot(x, scaled(momentum, a - b));
    let r = dot(z, scaled(momentum, c - b));
    let l = scaled(momentum, b);
    [l[0] + (x[0] * p + z[0] * r), l[1] + (x[1] * p + z[1] * r), l[2] + (x[2] * p + z[2] * r)]
}

/// A quaternion after the turn by a rotation vector of which half is given, by (2); `coefficients` are c and s.
#[inline(always)]
pub fn turned<T: Number>((c, s): (T, T), half: [T; 3], q: [T; 4]) -> [T; 4] {
    let length = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    let right = length.like(1.5) - length * 0.5;
    let [w, x, y, z] = [q[0] * right, q[1] * right, q[2] * right, q[3] * right];
    let [i, j, k] = half;
    // The product does not wait for c and s.
    [
        c * w - s * (i * x + j * y + k * z),
        c * x + s * (i * w + j * z - k * y),
        c * y + s * (j * w + k * x - i * z),
        c * z + s * (k * w + i * y - j * x),
    ]
}
