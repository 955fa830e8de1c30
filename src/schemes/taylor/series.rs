//! Truncated power series that grow by one coefficient at a time.
//!
//! x(s) = Σ x_k sᵏ. A coefficient of a product, of a power or of a sinusoid follows from those of the same order and below:
//!
//! ```text
//! (1)  (a b)_k = Σ a_j b_{k−j}
//! (2)  (aᵅ)_k = Σ_{j<k} (α (k − j) − j) a_{k−j} (aᵅ)_j / (k a₀)
//! (3)  (c + a cos ω(t+s) + b sin ω(t+s))_k = ωᵏ/k! times C, S, −C, −S, … and c besides at k = 0,
//!      C = a cos ωt + b sin ωt,  S = b cos ωt − a sin ωt
//! ```
//!
//! Several series of one kind stand side by side in lanes, so that a sum (1) is taken for all of them at once.
//!
//! Source: jorba2005, section 2; (2) is Knuth, The Art of Computer Programming 2, section 4.7.

/// Coefficients that a series holds: orders 0 to 23. The order at a tolerance of 1e-16 is 20.
pub const CAPACITY: usize = 24;

/// A vector.
pub type Vector = [f64; 3];
/// The coefficients of numbers side by side.
pub type Series<const L: usize> = [[f64; L]; CAPACITY];
/// Vectors side by side, component by component.
pub type Vectors<const L: usize> = [[f64; L]; 3];
/// The coefficients of a vector.
pub type Curve = [Vector; CAPACITY];
/// The coefficients of vectors side by side.
pub type Curves<const L: usize> = [Vectors<L>; CAPACITY];

/// A series of zeros.
pub const fn zeros<const L: usize>() -> Curves<L> {
    [[[0.0; L]; 3]; CAPACITY]
}

// Sums are kept in arrays of a component each, and written once: so they stay in registers, and lanes become vectors.

/// The highest coefficient of a × b, for every lane of a; both are given up to its order.
#[inline(always)]
pub fn cross<const L: usize>(a: &[Vectors<L>], b: &[Vector], into: &mut Vectors<L>) {
    let (mut x, mut y, mut z) = ([0.0; L], [0.0; L], [0.0; L]);
    for ([ax, ay, az], [bx, by, bz]) in a.iter().zip(b.iter().rev()) {
        for ((x, ay), az) in x.iter_mut().zip(ay).zip(az) {
            *x += ay * bz - az * by;
        }
        for ((y, az), ax) in y.iter_mut().zip(az).zip(ax) {
            *y += az * bx - ax * bz;
        }
        for ((z, ax), ay) in z.iter_mut().zip(ax).zip(ay) {
            *z += ax * by - ay * bx;
        }
    }
    *into = [x, y, z];
}

/// Coefficient `k` of a × b.
#[inline(always)]
pub fn cross_of_two(a: &Curve, b: &Curve, k: usize) -> Vector {
    let [mut x, mut y, mut z] = [0.0; 3];
    for (a, b) in a[..=k].iter().zip(b[..=k].iter().rev()) {
        x += a[1] * b[2] - a[2] * b[1];
        y += a[2] * b[0] - a[0] * b[2];
        z += a[0] * b[1] - a[1] * b[0];
    }
    [x, y, z]
}

/// Coefficient `k` of (a_y a_z, a_z a_x, a_x a_y).
#[inline(always)]
pub fn pairs(a: &Curve, k: usize) -> Vector {
    let [mut x, mut y, mut z] = [0.0; 3];
    for (a, b) in a[..=k].iter().zip(a[..=k].iter().rev()) {
        x += a[1] * b[2];
        y += a[2] * b[0];
        z += a[0] * b[1];
    }
    [x, y, z]
}

/// Coefficient `k` of a · a.
#[inline(always)]
pub fn norm_squared<const L: usize>(a: &Curves<L>, k: usize) -> [f64; L] {
    let mut sum = [0.0; L];
    for (a, b) in a[..=k].iter().zip(a[..=k].iter().rev()) {
        for (a, b) in a.iter().zip(b) {
            for ((sum, a), b) in sum.iter_mut().zip(a).zip(b) {
                *sum += a * b;
            }
        }
    }
    sum
}

/// Coefficient `k` of a vector times a number.
#[inline(always)]
pub fn times<const L: usize>(a: &Curves<L>, b: &Series<L>, k: usize) -> Vectors<L> {
    let (mut x, mut y, mut z) = ([0.0; L], [0.0; L], [0.0; L]);
    for ([ax, ay, az], b) in a[..=k].iter().zip(b[..=k].iter().rev()) {
        for ((x, ax), b) in x.iter_mut().zip(ax).zip(b) {
            *x += ax * b;
        }
        for ((y, ay), b) in y.iter_mut().zip(ay).zip(b) {
            *y += ay * b;
        }
        for ((z, az), b) in z.iter_mut().zip(az).zip(b) {
            *z += az * b;
        }
    }
    [x, y, z]
}

/// Coefficient `k` of aᵅ (2), where `power` holds those below.
#[inline(always)]
pub fn power<const L: usize>(a: &Series<L>, exponent: f64, power: &Series<L>, k: usize) -> [f64; L] {
    let mut sum = [0.0; L];
    if k == 0 {
        for (sum, a) in sum.iter_mut().zip(&a[0]) {
            *sum = a.powf(exponent);
        }
        return sum;
    }
    let mut weight = exponent * k as f64;
    for (below, a) in power[..k].iter().zip(a[1..=k].iter().rev()) {
        for ((sum, a), below) in sum.iter_mut().zip(a).zip(below) {
            *sum += weight * a * below;
        }
        weight -= exponent + 1.0; // α (k − j) − j
    }
    for (sum, a) in sum.iter_mut().zip(&a[0]) {
        *sum /= k as f64 * a;
    }
    sum
}

/// c + a cos ωt + b sin ωt.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sinusoid {
    /// c.
    pub constant: Vector,
    /// a.
    pub cosine: Vector,
    /// b.
    pub sine: Vector,
    /// ω.
    pub frequency: f64,
}

impl Sinusoid {
    /// Its coefficients (3) about a time: one where it is constant, else all.
    pub fn expand<'a>(&self, time: f64, into: &'a mut Curve) -> &'a [Vector] {
        let Sinusoid { constant, cosine, sine, frequency } = *self;
        let (sin, cos) = (frequency * time).sin_cos();
        let even: Vector = std::array::from_fn(|c| cosine[c] * cos + sine[c] * sin);
        let odd: Vector = std::array::from_fn(|c| sine[c] * cos - cosine[c] * sin);
        let length = if frequency == 0.0 { 1 } else { CAPACITY };
        let mut factor = 1.0;
        for (k, place) in into[..length].iter_mut().enumerate() {
            if k > 0 {
                factor *= frequency / k as f64;
            }
            // C, S, −C, −S: every second pair has the other sign.
            let of = if k % 2 == 0 { &even } else { &odd };
            let signed = if k % 4 < 2 { factor } else { -factor };
            *place = [of[0] * signed, of[1] * signed, of[2] * signed];
        }
        for (place, constant) in into[0].iter_mut().zip(constant) {
            *place += constant;
        }
        &into[..length]
    }
}

/// a × b.
#[inline(always)]
pub fn cross_product(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The sum of a polynomial at `s`, by Horner's rule.
#[inline(always)]
pub fn sum<const L: usize>(curves: &[Vectors<L>], s: f64) -> Vectors<L> {
    let mut value = [[0.0; L]; 3];
    for coefficient in curves.iter().rev() {
        for (value, coefficient) in value.iter_mut().zip(coefficient) {
            for (value, coefficient) in value.iter_mut().zip(coefficient) {
                *value = *value * s + coefficient;
            }
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of eˢ, e²ˢ and e³ˢ: products and powers of each other.
    fn exponential(rate: f64) -> [f64; CAPACITY] {
        let mut coefficient = 1.0;
        std::array::from_fn(|k| {
            if k > 0 {
                coefficient *= rate / k as f64;
            }
            coefficient
        })
    }

    fn near(value: f64, expected: f64) -> bool {
        // Up to 24 terms of one size.
        (value - expected).abs() <= 24.0 * f64::EPSILON * expected.abs().max(1e-30)
    }

    #[test]
    fn products_of_exponentials_are_exponentials() {
        let [one, two, three] = [1.0, 2.0, 3.0].map(exponential);
        let vectors: Curves<1> = std::array::from_fn(|k| [[one[k]], [2.0 * one[k]], [3.0 * one[k]]]);
        let other: Curve = std::array::from_fn(|k| [two[k], -two[k], 0.5 * two[k]]);
        let plain: Curve = std::array::from_fn(|k| vectors[k].map(|[x]| x));
        let doubles: Series<1> = two.map(|x| [x]);
        for (k, (two, three)) in two.into_iter().zip(three).enumerate() {
            let expected = [4.0, 2.5, -3.0].map(|x| x * three);
            let (mut lanes, alone) = ([[0.0; 1]; 3], cross_of_two(&plain, &other, k));
            cross(&vectors[..=k], &other[..=k], &mut lanes);
            let product = times(&vectors, &doubles, k);
            let (pairs, of_pairs) = (pairs(&plain, k), [6.0, 3.0, 2.0].map(|x| x * two));
            for (value, expected) in [(lanes.map(|[x]| x), expected), (alone, expected), (pairs, of_pairs)] {
                assert!(
                    value.iter().zip(expected).all(|(value, expected)| near(*value, expected)),
                    "order {k}"
                );
            }
            for (c, [value]) in product.into_iter().enumerate() {
                assert!(near(value, (c as f64 + 1.0) * three), "order {k}");
            }
            assert!(near(norm_squared(&vectors, k)[0], 14.0 * two), "order {k}");
        }
    }

    #[test]
    fn powers_of_a_geometric_series_are_binomial() {
        let geometric: Series<3> = [[1.0; 3]; CAPACITY];
        for exponent in [1.5, -0.5, -1.5] {
            let mut found: Series<3> = [[0.0; 3]; CAPACITY];
            let mut expected = 1.0;
            for k in 0..CAPACITY {
                found[k] = power(&geometric, exponent, &found, k);
                if k > 0 {
                    expected *= (exponent + k as f64 - 1.0) / k as f64;
                }
                for value in found[k] {
                    // Up to 24 terms of size one.
                    assert!(
                        (value - expected).abs() <= 24.0 * f64::EPSILON,
                        "{exponent}, order {k}: {value}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_sinusoid_sums_to_itself() {
        let wave = Sinusoid {
            constant: [0.5, 0.0, -1.0],
            cosine: [1.0, -2.0, 0.25],
            sine: [0.125, 3.0, 1.0],
            frequency: 1.7,
        };
        let (time, s) = (2.3, 0.4);
        let mut curve = [[0.0; 3]; CAPACITY];
        let curves: Vec<Vectors<1>> = wave.expand(time, &mut curve).iter().map(|v| v.map(|x| [x])).collect();
        let (sin, cos) = (1.7f64 * (time + s)).sin_cos();
        for (c, [value]) in sum(&curves, s).into_iter().enumerate() {
            let expected = wave.constant[c] + wave.cosine[c] * cos + wave.sine[c] * sin;
            assert!((value - expected).abs() < 8.0 * f64::EPSILON * 4.0, "{value} {expected}");
        }
        let constant = Sinusoid { frequency: 0.0, ..wave };
        let mut curve = [[0.0; 3]; CAPACITY];
        assert_eq!(constant.expand(time, &mut curve), [[1.5, -2.0, -0.75]]);
    }
}
