//! Double-double arithmetic: a number as the unevaluated sum of two f64, good to 2⁻¹⁰⁴.
//!
//! ```text
//! (1) a + b = s + e      s = fl(a + b), b' = s − a, e = (a − (s − b')) + (b − b')         TwoSum
//! (2) a b = p + e        p = fl(a b),  e = ((a₁b₁ − p) + a₁b₂ + a₂b₁) + a₂b₂              TwoProd
//! (3) a = a₁ + a₂        c = fl((2²⁷ + 1) a), a₁ = c − (c − a), 26 bits each               split
//! ```
//!
//! (1) and (2) are exact as long as nothing over- or underflows: (3) from 2⁹⁹⁶ on, (2) below 2⁻⁹⁶⁹. The equations
//! are therefore scaled to numbers near one. No fused multiply-add is used: without one in the target it is a
//! call of a library.
//!
//! Source: dekker1971 for (2), (3); knuth1997, 4.2.2, for (1); hida2001 for the sums, quotient and square root.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// high + low with |low| ≤ ½ ulp(high).
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    /// The number rounded to f64.
    pub high: f64,
    /// The rest.
    pub low: f64,
}

/// 2²⁷ + 1 of (3).
const SPLITTER: f64 = 134_217_729.0;

/// (1)
#[inline]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let shadow = sum - a;
    (sum, (a - (sum - shadow)) + (b - shadow))
}

/// (1) for |a| ≥ |b|.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// (3)
pub(super) fn split(a: f64) -> (f64, f64) {
    let scaled = SPLITTER * a;
    let upper = scaled - (scaled - a);
    (upper, a - upper)
}

/// (2)
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    let product = a * b;
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

impl DoubleDouble {
    /// 0.
    pub const ZERO: DoubleDouble = DoubleDouble { high: 0.0, low: 0.0 };
    /// 1.
    pub const ONE: DoubleDouble = DoubleDouble { high: 1.0, low: 0.0 };
    /// Largest relative error of a sum or product, 2⁻¹⁰⁴.
    pub const ROUNDING: f64 = f64::EPSILON * f64::EPSILON;

    /// high + low, whatever their sizes.
    #[inline]
    pub fn of_sum(high: f64, low: f64) -> DoubleDouble {
        let (high, low) = two_sum(high, low);
        DoubleDouble { high, low }
    }

    /// The nearest f64.
    #[inline]
    pub fn to_f64(self) -> f64 {
        self.high
    }

    /// Whether both parts are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }

    /// |a|.
    #[inline]
    pub fn abs(self) -> DoubleDouble {
        if self.high < 0.0 { -self } else { self }
    }

    /// a times a power of two: exact.
    #[inline]
    pub fn scaled(self, power_of_two: f64) -> DoubleDouble {
        DoubleDouble { high: self.high * power_of_two, low: self.low * power_of_two }
    }

    /// √a of a ≥ 0: one step of Newton's method from the f64 value.
    pub fn sqrt(self) -> DoubleDouble {
        if self.high <= 0.0 {
            return DoubleDouble { high: self.high.sqrt(), low: 0.0 };
        }
        let root = self.high.sqrt();
        let (square, error) = two_product(root, root);
        let rest = self - DoubleDouble { high: square, low: error };
        let (high, low) = quick_two_sum(root, rest.high / (2.0 * root));
        DoubleDouble { high, low }
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(high: f64) -> DoubleDouble {
        DoubleDouble { high, low: 0.0 }
    }
}

impl Add for DoubleDouble {
    type Output = DoubleDouble;

    #[inline]
    fn add(self, other: DoubleDouble) -> DoubleDouble {
        let (sum, error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let (sum, error) = quick_two_sum(sum, error + low);
        let (high, low) = quick_two_sum(sum, error + low_error);
        DoubleDouble { high, low }
    }
}

impl AddAssign for DoubleDouble {
    #[inline]
    fn add_assign(&mut self, other: DoubleDouble) {
        *self = *self + other;
    }
}

impl Neg for DoubleDouble {
    type Output = DoubleDouble;

    #[inline]
    fn neg(self) -> DoubleDouble {
        DoubleDouble { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = DoubleDouble;

    #[inline]
    fn sub(self, other: DoubleDouble) -> DoubleDouble {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = DoubleDouble;

    #[inline]
    fn mul(self, other: DoubleDouble) -> DoubleDouble {
        let (product, error) = two_product(self.high, other.high);
        let (high, low) = quick_two_sum(product, error + (self.high * other.low + self.low * other.high));
        DoubleDouble { high, low }
    }
}

impl Div for DoubleDouble {
    type Output = DoubleDouble;

    #[inline]
    fn div(self, other: DoubleDouble) -> DoubleDouble {
        let first = self.high / other.high;
        let rest = self - other * DoubleDouble::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * DoubleDouble::from(second);
        let (high, low) = quick_two_sum(first, second);
        DoubleDouble { high, low } + DoubleDouble::from(rest.high / other.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(a: DoubleDouble) -> f64 {
        a.high.abs()
    }

    #[test]
    fn sums_and_products_keep_what_an_f64_drops() {
        let tiny = 2f64.powi(-70);
        let sum = DoubleDouble::from(1.0) + DoubleDouble::from(tiny);
        assert_eq!((sum.high, sum.low), (1.0, tiny));
        let back = sum - DoubleDouble::ONE;
        assert_eq!(back.high, tiny);
        // (1 + 2⁻⁷⁰)(1 − 2⁻⁷⁰) = 1 − 2⁻¹⁴⁰, and the square of 1 + 2⁻³⁰ needs 61 bits.
        let square = DoubleDouble::from(1.0 + 2f64.powi(-30)) * DoubleDouble::from(1.0 + 2f64.powi(-30));
        assert_eq!((square.high, square.low), (1.0 + 2f64.powi(-29), 2f64.powi(-60)));
    }

    #[test]
    fn quotients_and_roots_undo_products_to_the_last_bits() {
        for a in [3.0, 0.1, 7e20, 1.7e-9] {
            for b in [7.0, -0.3, 1.1e5] {
                let (a, b) = (DoubleDouble::from(a), DoubleDouble::from(b));
                let error = (a / b) * b - a;
                assert!(size(error) <= 4.0 * DoubleDouble::ROUNDING * size(a), "{a:?}/{b:?}: {error:?}");
            }
            let root = DoubleDouble::from(a).sqrt();
            let error = root * root - DoubleDouble::from(a);
            assert!(size(error) <= 4.0 * DoubleDouble::ROUNDING * a, "√{a}: {error:?}");
            assert!(root.low != 0.0);
        }
        assert_eq!(DoubleDouble::ZERO.sqrt(), DoubleDouble::ZERO);
    }
}
