//! The functions of analysis that nalgebra asks of a scalar, from a few of a type: `root`, `nearest`, `down`, `sine_and_cosine`,
//! `exponential_less_one`, `logarithm`, `angle`, and the constants `ZERO`, `ONE`, `PI`, `LN_2`.

/// The functions of analysis.
macro_rules! analysis {
    ($number:ident) => {
        impl nalgebra::ComplexField for $number {
            type RealField = $number;

            #[inline(always)]
            fn from_real(re: $number) -> $number {
                re
            }

            #[inline(always)]
            fn real(self) -> $number {
                self
            }

            fn imaginary(self) -> $number {
                $number::ZERO
            }

            #[inline(always)]
            fn modulus(self) -> $number {
                num_traits::Signed::abs(&self)
            }

            #[inline(always)]
            fn modulus_squared(self) -> $number {
                self * self
            }

            fn argument(self) -> $number {
                if self < $number::ZERO { $number::PI } else { $number::ZERO }
            }

            #[inline(always)]
            fn norm1(self) -> $number {
                num_traits::Signed::abs(&self)
            }

            #[inline(always)]
            fn scale(self, factor: $number) -> $number {
                self * factor
            }

            #[inline(always)]
            fn unscale(self, factor: $number) -> $number {
                self / factor
            }

            fn floor(self) -> $number {
                self.down()
            }

            fn ceil(self) -> $number {
                -(-self).down()
            }

            fn round(self) -> $number {
                self.nearest()
            }

            fn trunc(self) -> $number {
                if self < $number::ZERO { -(-self).down() } else { self.down() }
            }

            fn fract(self) -> $number {
                self - self.trunc()
            }

            fn mul_add(self, a: $number, b: $number) -> $number {
                self * a + b
            }

            #[inline(always)]
            fn abs(self) -> $number {
                num_traits::Signed::abs(&self)
            }

            fn hypot(self, other: $number) -> $number {
                let (a, b) = (self.abs(), other.abs());
                let (large, small) = if a > b { (a, b) } else { (b, a) };
                if large == $number::ZERO {
                    large
                } else {
                    large * ($number::ONE + (small / large).powi(2)).root()
                }
            }

            fn recip(self) -> $number {
                $number::ONE / self
            }

            fn conjugate(self) -> $number {
                self
            }

            fn sin(self) -> $number {
                self.sine_and_cosine().0
            }

            fn cos(self) -> $number {
                self.sine_and_cosine().1
            }

            fn sin_cos(self) -> ($number, $number) {
                self.sine_and_cosine()
            }

            fn tan(self) -> $number {
                let (sine, cosine) = self.sine_and_cosine();
                sine / cosine
            }

            fn asin(self) -> $number {
                self.angle((($number::ONE - self) * ($number::ONE + self)).root())
            }

            fn acos(self) -> $number {
                (($number::ONE - self) * ($number::ONE + self)).root().angle(self)
            }

            fn atan(self) -> $number {
                self.angle($number::ONE)
            }

            fn sinh(self) -> $number {
                let less_one = self.exponential_less_one();
                (less_one + less_one / (less_one + 1.0)) / 2.0
            }

            fn cosh(self) -> $number {
                let power = self.exp();
                (power + power.recip()) / 2.0
            }

            fn tanh(self) -> $number {
                if self.to_f64().abs() > 100.0 {
                    return $number::of(self.to_f64().signum());
                }
                let less_one = (self * 2.0).exponential_less_one();
                less_one / (less_one + 2.0)
            }

            fn asinh(self) -> $number {
                let size = self.abs();
                let log = (size + (size * size) / ($number::ONE + (size * size + 1.0).root())).ln_1p();
                if self < $number::ZERO { -log } else { log }
            }

            fn acosh(self) -> $number {
                (self + ((self - 1.0) * (self + 1.0)).root()).logarithm()
            }

            fn atanh(self) -> $number {
                ((self * 2.0) / ($number::ONE - self)).ln_1p() / 2.0
            }

            fn log(self, base: $number) -> $number {
                self.logarithm() / base.logarithm()
            }

            fn log2(self) -> $number {
                self.logarithm() / $number::LN_2
            }

            fn log10(self) -> $number {
                self.logarithm() / $number::of(10.0).logarithm()
            }

            fn ln(self) -> $number {
                self.logarithm()
            }

            /// ln(1 + x) = ln u + (x − (u − 1))/u with u = 1 + x rounded.
            fn ln_1p(self) -> $number {
                let sum = self + 1.0;
                sum.logarithm() + (self - (sum - 1.0)) / sum
            }

            #[inline(always)]
            fn sqrt(self) -> $number {
                self.root()
            }

            fn exp(self) -> $number {
                self.exponential_less_one() + 1.0
            }

            fn exp2(self) -> $number {
                (self * $number::LN_2).exp()
            }

            fn exp_m1(self) -> $number {
                self.exponential_less_one()
            }

            fn powi(self, n: i32) -> $number {
                let (mut power, mut square, mut left) = ($number::ONE, self, n.unsigned_abs());
                while left > 0 {
                    if left % 2 == 1 {
                        power *= square;
                    }
                    square *= square;
                    left /= 2;
                }
                if n < 0 { power.recip() } else { power }
            }

            fn powf(self, n: $number) -> $number {
                (self.logarithm() * n).exp()
            }

            fn powc(self, n: $number) -> $number {
                self.powf(n)
            }

            /// One step of Newton's method from the f64 root.
            fn cbrt(self) -> $number {
                let root = $number::of(self.to_f64().cbrt());
                if root == $number::ZERO || !root.is_finite() {
                    return root;
                }
                root - (root - self / (root * root)) / 3.0
            }

            #[inline(always)]
            fn is_finite(&self) -> bool {
                self.to_f64().is_finite()
            }

            fn try_sqrt(self) -> Option<$number> {
                if self >= $number::ZERO { Some(self.root()) } else { None }
            }
        }

        impl nalgebra::RealField for $number {
            fn is_sign_positive(&self) -> bool {
                self.to_f64().is_sign_positive()
            }

            fn is_sign_negative(&self) -> bool {
                self.to_f64().is_sign_negative()
            }

            #[inline(always)]
            fn copysign(self, sign: $number) -> $number {
                if self.to_f64().is_sign_negative() == sign.to_f64().is_sign_negative() {
                    self
                } else {
                    -self
                }
            }

            #[inline(always)]
            fn max(self, other: $number) -> $number {
                if self.to_f64().is_nan() || other > self { other } else { self }
            }

            #[inline(always)]
            fn min(self, other: $number) -> $number {
                if self.to_f64().is_nan() || other < self { other } else { self }
            }

            fn clamp(self, min: $number, max: $number) -> $number {
                if self < min {
                    min
                } else if self > max {
                    max
                } else {
                    self
                }
            }

            fn atan2(self, other: $number) -> $number {
                self.angle(other)
            }

            fn min_value() -> Option<$number> {
                None
            }

            fn max_value() -> Option<$number> {
                None
            }

            fn pi() -> $number {
                $number::PI
            }

            fn two_pi() -> $number {
                $number::PI * 2.0
            }

            fn frac_pi_2() -> $number {
                $number::PI * 0.5
            }

            fn frac_pi_3() -> $number {
                $number::PI / 3.0
            }

            fn frac_pi_4() -> $number {
                $number::PI * 0.25
            }

            fn frac_pi_6() -> $number {
                $number::PI / 6.0
            }

            fn frac_pi_8() -> $number {
                $number::PI * 0.125
            }

            fn frac_1_pi() -> $number {
                $number::ONE / $number::PI
            }

            fn frac_2_pi() -> $number {
                $number::of(2.0) / $number::PI
            }

            fn frac_2_sqrt_pi() -> $number {
                $number::of(2.0) / $number::PI.root()
            }

            fn e() -> $number {
                $number::ONE.exponential_less_one() + 1.0
            }

            fn log2_e() -> $number {
                $number::ONE / $number::LN_2
            }

            fn log10_e() -> $number {
                $number::ONE / $number::of(10.0).logarithm()
            }

            fn ln_2() -> $number {
                $number::LN_2
            }

            fn ln_10() -> $number {
                $number::of(10.0).logarithm()
            }
        }
    };
}

pub(super) use analysis;
