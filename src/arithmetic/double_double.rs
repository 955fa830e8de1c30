//! Double-double numbers: the unevaluated sum of two f64, 31 digits.
//!
//! ```text
//! (1)  a + b = s + e       s = fl(a + b),  b' = s − a,  e = (a − (s − b')) + (b − b')
//! (2)  a b = p + e         p = fl(a b),  e = ((a₁ b₁ − p) + a₁ b₂ + a₂ b₁) + a₂ b₂
//! (3)  a = a₁ + a₂         c = fl((2²⁷ + 1) a),  a₁ = c − (c − a)
//! ```
//!
//! (1) and (2) are exact. (3) is taken of a/2²⁸ from 2⁹⁹⁵ on, so that it does not overflow; (2) loses digits where a b is below 2⁻⁹⁶⁹.
//! A sum, a product and a quotient are good to 2⁻¹⁰² of their size.
//!
//! Source: dekker1971 for (2) and (3), knuth1997 section 4.2.2 for (1), hida2001 for sums, quotients and roots.

use std::cmp::Ordering;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use super::field::field;
use super::{Number, Real, Registers, Row, Work};

/// high + low with |low| ≤ ½ ulp(high).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// 2²⁷ + 1.
const SPLITTER: f64 = 134_217_729.0;
/// 2⁹⁹⁵.
const SPLIT_OVERFLOWS: f64 = f64::from_bits((995 + 1023) << 52);
/// 2²⁸.
const SCALE: f64 = 268_435_456.0;

/// (1).
#[inline(always)]
const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// (1) for |a| ≥ |b|.
#[inline(always)]
const fn ordered_sum(a: f64, b: f64) -> DoubleDouble {
    let sum = a + b;
    DoubleDouble { high: sum, low: b - (sum - a) }
}

/// (3).
#[inline(always)]
const fn split(a: f64) -> (f64, f64) {
    let scaled = SPLITTER * a;
    let upper = scaled - (scaled - a);
    (upper, a - upper)
}

/// (3) for every size.
const fn split_large(a: f64) -> (f64, f64) {
    if a.abs() > SPLIT_OVERFLOWS {
        let (upper, lower) = split(a / SCALE);
        return (upper * SCALE, lower * SCALE);
    }
    split(a)
}

/// What (2) rounds off, from the parts of the factors.
#[inline(always)]
const fn error_of_product(product: f64, (a1, a2): (f64, f64), (b1, b2): (f64, f64)) -> f64 {
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// (2); the error is no number where a factor is too large for (3).
#[inline(always)]
const fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    (product, error_of_product(product, split(a), split(b)))
}

impl DoubleDouble {
    const ZERO: DoubleDouble = DoubleDouble::exact(0.0);
    const ONE: DoubleDouble = DoubleDouble::exact(1.0);
    const PI: DoubleDouble = DoubleDouble { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };
    /// π/2 − (its first two parts), for arguments of many turns.
    const HALF_PI_REST: f64 = -1.497_384_904_859_169_8e-33;
    const LN_2: DoubleDouble =
        DoubleDouble { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };

    /// An f64.
    #[inline(always)]
    pub const fn exact(high: f64) -> DoubleDouble {
        DoubleDouble { high, low: 0.0 }
    }

    /// high + low, of any sizes.
    #[inline(always)]
    pub const fn of_sum(high: f64, low: f64) -> DoubleDouble {
        let (high, low) = two_sum(high, low);
        DoubleDouble { high, low }
    }

    /// The nearest f64, and the rest.
    pub fn parts(self) -> (f64, f64) {
        (self.high, self.low)
    }

    #[inline]
    const fn plus(self, other: DoubleDouble) -> DoubleDouble {
        let (sum, error) = two_sum(self.high, other.high);
        let (low, last) = two_sum(self.low, other.low);
        if !sum.is_finite() {
            return DoubleDouble::exact(sum);
        }
        let first = ordered_sum(sum, error + low);
        ordered_sum(first.high, first.low + last)
    }

    #[inline]
    const fn negative(self) -> DoubleDouble {
        DoubleDouble { high: -self.high, low: -self.low }
    }

    #[inline]
    const fn times(self, other: DoubleDouble) -> DoubleDouble {
        let (product, error) = two_product(self.high, other.high);
        if !error.is_finite() {
            return self.times_large(other);
        }
        ordered_sum(product, error + (self.high * other.low + self.low * other.high))
    }

    #[inline]
    const fn times_f64(self, other: f64) -> DoubleDouble {
        let (product, error) = two_product(self.high, other);
        if !error.is_finite() {
            return self.times_large(DoubleDouble::exact(other));
        }
        ordered_sum(product, error + self.low * other)
    }

    /// The product where a factor or the product is large. Few products are: their code stands apart from the others.
    #[cold]
    #[inline(never)]
    const fn times_large(self, other: DoubleDouble) -> DoubleDouble {
        let product = self.high * other.high;
        let error = error_of_product(product, split_large(self.high), split_large(other.high));
        if !error.is_finite() {
            return DoubleDouble::exact(product);
        }
        ordered_sum(product, error + (self.high * other.low + self.low * other.high))
    }

    #[inline]
    const fn over(self, other: DoubleDouble) -> DoubleDouble {
        let first = self.high / other.high;
        if !first.is_finite() || !other.high.is_finite() {
            return DoubleDouble::exact(first);
        }
        let rest = self.plus(other.times_f64(first).negative());
        let second = rest.high / other.high;
        let rest = rest.plus(other.times_f64(second).negative());
        let third = rest.high / other.high;
        let sum = ordered_sum(first, second);
        sum.plus(DoubleDouble::exact(third))
    }

    /// a times a power of two: exact.
    #[inline]
    const fn scaled(self, power: f64) -> DoubleDouble {
        DoubleDouble { high: self.high * power, low: self.low * power }
    }

    /// √a by one step of Newton's method from the f64 root.
    pub(super) fn root(self) -> DoubleDouble {
        if self.high <= 0.0 || !self.high.is_finite() {
            return DoubleDouble::exact(self.high.sqrt());
        }
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = self.plus(DoubleDouble { high: -square, low: -error });
        ordered_sum(root, rest.high / (2.0 * root))
    }

    /// The nearest whole number; halves go away from zero.
    pub(super) fn nearest(self) -> DoubleDouble {
        let high = self.high.round();
        if high == self.high {
            return ordered_sum(high, self.low.round());
        }
        // A half that the low part takes away.
        let half = (self.high - self.high.trunc()).abs() == 0.5;
        if half && self.low != 0.0 && (self.low < 0.0) == (self.high > 0.0) {
            return DoubleDouble::exact(self.high.trunc());
        }
        DoubleDouble::exact(high)
    }

    pub(super) fn down(self) -> DoubleDouble {
        let high = self.high.floor();
        if high == self.high { ordered_sum(high, self.low.floor()) } else { DoubleDouble::exact(high) }
    }

    /// sin x and cos x: x less a multiple of π/2, then the power series.
    pub(super) fn sine_and_cosine(self) -> (DoubleDouble, DoubleDouble) {
        if !self.high.is_finite() {
            return (DoubleDouble::exact(f64::NAN), DoubleDouble::exact(f64::NAN));
        }
        let quarters = (self.high / std::f64::consts::FRAC_PI_2).round();
        let rest = self
            .plus(DoubleDouble::PI.scaled(0.5).times_f64(quarters).negative())
            .plus(DoubleDouble::exact(-quarters * DoubleDouble::HALF_PI_REST));
        let (cosine, sine) = series(rest.times(rest));
        let (sine, cosine) = (rest.times(sine), cosine);
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, sine.negative()),
            2 => (sine.negative(), cosine.negative()),
            _ => (cosine.negative(), sine),
        }
    }

    /// eˣ − 1: the power series of x/2ᵏ less whole multiples of ln 2.
    pub(super) fn exponential_less_one(self) -> DoubleDouble {
        if !self.high.is_finite() || self.high.abs() > 700.0 {
            return DoubleDouble::exact(self.high.exp_m1());
        }
        let doublings = (self.high / std::f64::consts::LN_2).round();
        // |r| ≤ ln 2/2/16.
        let r = self.plus(DoubleDouble::LN_2.times_f64(doublings).negative()).scaled(1.0 / 16.0);
        let (mut sum, mut n) = (DoubleDouble::ZERO, 18u32);
        while n > 0 {
            sum = r.times(DoubleDouble::ONE.plus(sum)).over(DoubleDouble::exact(n as f64));
            n -= 1;
        }
        for _ in 0..4 {
            sum = sum.times(sum.plus(DoubleDouble::exact(2.0)));
        }
        let power = 2f64.powi(doublings as i32);
        sum.scaled(power).plus(DoubleDouble::exact(power - 1.0))
    }

    /// ln x: two steps of Newton's method from the f64 logarithm.
    pub(super) fn logarithm(self) -> DoubleDouble {
        let mut y = DoubleDouble::exact(self.high.ln());
        if !y.high.is_finite() {
            return y;
        }
        for _ in 0..2 {
            let power = y.negative().exponential_less_one().plus(DoubleDouble::ONE);
            y = y.plus(self.times(power)).plus(DoubleDouble::exact(-1.0));
        }
        y
    }

    /// The angle of (x, y) = (`other`, `self`): one step of Newton's method from the f64 angle, in the sine of what it is off by.
    pub(super) fn angle(self, other: DoubleDouble) -> DoubleDouble {
        let guess = DoubleDouble::exact(self.high.atan2(other.high));
        let largest = self.high.abs().max(other.high.abs());
        if largest == 0.0 || !largest.is_finite() {
            return guess;
        }
        let (y, x) = (self.over(DoubleDouble::exact(largest)), other.over(DoubleDouble::exact(largest)));
        let length = x.times(x).plus(y.times(y)).root();
        let (sine, cosine) = guess.sine_and_cosine();
        let off = y.times(cosine).plus(x.times(sine).negative()).over(length);
        guess.plus(off)
    }
}

/// Terms of [`series`]: (π/4)²⁸/28! is below 2⁻¹⁰⁶.
const TERMS: usize = 14;

/// (−1)ᵏ/(2k + `offset`)!.
const fn inverse_factorials(offset: usize) -> [DoubleDouble; TERMS] {
    let mut result = [DoubleDouble::ONE; TERMS];
    let (mut k, mut factorial) = (1, DoubleDouble::ONE);
    while k < TERMS {
        let n = 2 * k + offset;
        factorial = factorial.times_f64(((n - 1) * n) as f64).negative();
        result[k] = DoubleDouble::ONE.over(factorial);
        k += 1;
    }
    result
}

const COSINE: [DoubleDouble; TERMS] = inverse_factorials(0);
const SINE: [DoubleDouble; TERMS] = inverse_factorials(1);

/// How many terms of [`series`] need two f64, for y below a bound: those after them are below 2⁻⁵³ of the sum.
const IN_TWO: [(f64, usize); 3] = [(1.0 / 32_768.0, 3), (1.0 / 1024.0, 4), (f64::INFINITY, 9)];

/// cos x and sin x / x for y = x² ≤ (π/4)².
fn series(y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let in_two = IN_TWO.iter().find(|(below, _)| y.high < *below).map_or(9, |(_, terms)| *terms);
    // As many again end below 2⁻¹⁰⁶.
    let last = TERMS.min(2 * in_two + 1);
    let sum = |terms: &[DoubleDouble; TERMS]| {
        let small = terms[in_two..last].iter().rev().fold(0.0, |sum, term| sum * y.high + term.high);
        let start = DoubleDouble::exact(small);
        terms[..in_two].iter().rev().fold(start, |sum, term| sum.times(y).plus(*term))
    };
    (sum(&COSINE), sum(&SINE))
}

impl PartialOrd for DoubleDouble {
    #[inline]
    fn partial_cmp(&self, other: &DoubleDouble) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            unequal => unequal,
        }
    }
}

impl Real for DoubleDouble {
    const NAME: &'static str = "double-double";
    const UNIT: f64 = 4.0 * f64::EPSILON * f64::EPSILON;
    const LARGEST_EXCESS: f64 = 1.0 / (1u64 << 36) as f64;
    const PLAIN_SQUARES: [f64; 2] = [1e-250, 1e280];

    #[inline(always)]
    fn of(value: f64) -> DoubleDouble {
        DoubleDouble::exact(value)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.high
    }

    fn turn_coefficients(y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
        series(y)
    }

    fn by_eight<W: Work<DoubleDouble>>(_: Registers, work: W) -> W::Output {
        work.with_rows::<DoubleDouble>(())
    }
}

field!(DoubleDouble);

#[cfg(test)]
mod tests {
    use super::*;

    fn of(x: f64) -> DoubleDouble {
        DoubleDouble::exact(x)
    }

    /// Computed with decimal numbers of 60 digits; each is the f64 nearest to it and the rest.
    #[test]
    fn functions_have_their_values_to_31_digits() {
        use nalgebra::{ComplexField, RealField};
        let values = [
            ("sin 1", of(1.0).sin(), [0.8414709848078965, 1.776845092935536e-18]),
            ("cos 1", of(1.0).cos(), [0.5403023058681398, -4.760954612604417e-17]),
            ("e", of(1.0).exp(), [std::f64::consts::E, 1.4456468917292502e-16]),
            ("ln 10", of(10.0).ln(), [std::f64::consts::LN_10, -2.1707562233822494e-16]),
            ("arctan 1/2", of(1.0).atan2(of(2.0)), [0.4636476090008061, 2.2698777452961687e-17]),
            ("√2", of(2.0).sqrt(), [std::f64::consts::SQRT_2, -9.667293313452913e-17]),
            ("∛2", of(2.0).cbrt(), [1.2599210498948732, -2.589933375300507e-17]),
            ("tanh 1/4", of(0.25).tanh(), [0.24491866240370913, -1.6036228849882693e-18]),
            ("cosh 1/4", of(0.25).cosh(), [1.0314130998795732, -1.5782222089554954e-17]),
            ("1/3", of(1.0) / 3.0, [0.3333333333333333, 1.850371707708594e-17]),
        ];
        for (name, found, [high, low]) in values {
            let off = ((found - DoubleDouble::of_sum(high, low)) / found).to_f64().abs();
            // Measured: up to 1.3e-32.
            assert!(off < DoubleDouble::UNIT, "{name}: {off:e}");
        }
    }

    #[test]
    fn sines_and_cosines_of_many_turns_are_those_of_a_circle() {
        for x in [0.1, 0.7, 3.0, -50.3, 1e3, -1e6] {
            let (sine, cosine) = of(x).sine_and_cosine();
            let (twice, _) = of(2.0 * x).sine_and_cosine();
            let unit = DoubleDouble::UNIT * (1.0 + x.abs());
            assert!((sine * sine + cosine * cosine - 1.0).to_f64().abs() < 4.0 * DoubleDouble::UNIT, "{x}");
            assert!((twice - sine * cosine * 2.0).to_f64().abs() < unit, "{x}");
        }
    }

    #[test]
    fn numbers_at_both_ends_of_the_range_are_multiplied_and_divided() {
        for (a, b) in [(1e300, 3.0), (7e-200, 1e-80), (1.5e160, 2e140)] {
            let product = of(a) * of(b);
            assert!(((product / of(b) - of(a)) / of(a)).to_f64().abs() < DoubleDouble::UNIT, "{a} {b}");
        }
        assert_eq!((of(1e300) * of(1e300)).to_f64(), f64::INFINITY);
        assert!((of(0.0) / of(0.0)).to_f64().is_nan());
        assert_eq!((of(1.0) / of(0.0)).to_f64(), f64::INFINITY);
    }

    #[test]
    fn whole_numbers_are_found_beyond_the_digits_of_f64() {
        use nalgebra::ComplexField;
        let large = DoubleDouble::of_sum(2f64.powi(60), -0.25);
        assert_eq!(large.round(), of(2f64.powi(60)));
        assert_eq!(large.floor(), DoubleDouble::of_sum(2f64.powi(60), -1.0));
        assert_eq!(DoubleDouble::of_sum(2.5, -1e-20).round(), of(2.0));
        assert_eq!(of(-2.5).trunc(), of(-2.0));
    }
}
