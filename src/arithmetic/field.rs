//! What nalgebra asks of a scalar, from a few functions of a type: `plus`, `negative`, `times`, `times_f64`, `over`, `root`,
//! `nearest`, `down`, `sine_and_cosine`, `exponential_less_one`, `logarithm`, `angle`, and the constants `ZERO`, `ONE`, `PI`, `LN_2`.

/// Declares a type of number as a field with the functions of analysis.
macro_rules! field {
    ($number:ident) => {
        crate::arithmetic::field::operators!($number, Add add plus, Mul mul times, Div div over);
        crate::arithmetic::field::assignments!(
            $number, AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /,
            RemAssign rem_assign %
        );

        impl Sub for $number {
            type Output = $number;

            #[inline(always)]
            fn sub(self, other: $number) -> $number {
                self.plus(other.negative())
            }
        }

        impl Sub<f64> for $number {
            type Output = $number;

            #[inline(always)]
            fn sub(self, other: f64) -> $number {
                self.plus($number::of(-other))
            }
        }

        impl Mul<f64> for $number {
            type Output = $number;

            #[inline(always)]
            fn mul(self, factor: f64) -> $number {
                self.times_f64(factor)
            }
        }

        impl Rem for $number {
            type Output = $number;

            fn rem(self, other: $number) -> $number {
                self - nalgebra::ComplexField::trunc(self / other) * other
            }
        }

        impl Neg for $number {
            type Output = $number;

            #[inline(always)]
            fn neg(self) -> $number {
                self.negative()
            }
        }

        impl Sum for $number {
            fn sum<I: Iterator<Item = $number>>(numbers: I) -> $number {
                numbers.fold($number::ZERO, |sum, number| sum + number)
            }
        }

        impl PartialEq<f64> for $number {
            #[inline(always)]
            fn eq(&self, other: &f64) -> bool {
                *self == $number::of(*other)
            }
        }

        impl PartialOrd<f64> for $number {
            #[inline(always)]
            fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
                self.partial_cmp(&$number::of(*other))
            }
        }

        impl std::fmt::Display for $number {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.to_f64().fmt(f)
            }
        }

        impl Number for $number {
            #[inline(always)]
            fn like(self, value: f64) -> $number {
                $number::of(value)
            }

            #[inline(always)]
            fn larger(self, other: $number) -> $number {
                if other > self { other } else { self }
            }
        }

        /// A row of one.
        impl Row for $number {
            type Scalar = $number;
            type Proof = ();
            const COUNT: usize = 1;
            type Chunk = $number;

            #[inline(always)]
            fn splat(_: (), value: $number) -> $number {
                value
            }

            #[inline(always)]
            fn chunks(values: &[$number]) -> &[$number] {
                values
            }

            #[inline(always)]
            fn chunks_mut(values: &mut [$number]) -> &mut [$number] {
                values
            }

            #[inline(always)]
            fn load(_: (), chunk: &$number) -> $number {
                *chunk
            }

            #[inline(always)]
            fn store(self, chunk: &mut $number) {
                *chunk = self;
            }

            #[inline(always)]
            fn largest(self) -> $number {
                self
            }
        }

        crate::arithmetic::field::number_traits!($number);
        crate::arithmetic::field::analysis!($number);
    };
}

macro_rules! operators {
    ($number:ident, $($operator:ident $method:ident $function:ident),*) => {$(
        impl $operator for $number {
            type Output = $number;

            #[inline(always)]
            fn $method(self, other: $number) -> $number {
                self.$function(other)
            }
        }
        crate::arithmetic::field::with_f64!($number, $operator $method);
    )*};
}

/// `Mul<f64>` is a product of its own.
macro_rules! with_f64 {
    ($number:ident, Mul $method:ident) => {};
    ($number:ident, $operator:ident $method:ident) => {
        impl $operator<f64> for $number {
            type Output = $number;

            #[inline(always)]
            fn $method(self, other: f64) -> $number {
                self.$method($number::of(other))
            }
        }
    };
}

macro_rules! assignments {
    ($number:ident, $($operator:ident $method:ident $symbol:tt),*) => {$(
        impl $operator for $number {
            #[inline(always)]
            fn $method(&mut self, other: $number) {
                *self = *self $symbol other;
            }
        }
    )*};
}

/// The traits of `num-traits`, `approx` and `simba` that the functions of analysis stand on.
macro_rules! number_traits {
    ($number:ident) => {
        impl num_traits::Zero for $number {
            #[inline(always)]
            fn zero() -> $number {
                $number::ZERO
            }

            #[inline(always)]
            fn is_zero(&self) -> bool {
                *self == $number::ZERO
            }
        }

        impl num_traits::One for $number {
            #[inline(always)]
            fn one() -> $number {
                $number::ONE
            }
        }

        impl num_traits::Num for $number {
            type FromStrRadixErr = num_traits::ParseFloatError;

            fn from_str_radix(text: &str, radix: u32) -> Result<$number, num_traits::ParseFloatError> {
                f64::from_str_radix(text, radix).map($number::of)
            }
        }

        impl num_traits::Signed for $number {
            fn abs(&self) -> $number {
                if *self < $number::ZERO { -*self } else { *self }
            }

            fn abs_sub(&self, other: &$number) -> $number {
                if *self > *other { *self - *other } else { $number::ZERO }
            }

            fn signum(&self) -> $number {
                $number::of(self.to_f64().signum())
            }

            fn is_positive(&self) -> bool {
                self.to_f64().is_sign_positive()
            }

            fn is_negative(&self) -> bool {
                self.to_f64().is_sign_negative()
            }
        }

        impl num_traits::FromPrimitive for $number {
            fn from_i64(n: i64) -> Option<$number> {
                Some($number::of(n as f64))
            }

            fn from_u64(n: u64) -> Option<$number> {
                Some($number::of(n as f64))
            }

            fn from_f64(n: f64) -> Option<$number> {
                Some($number::of(n))
            }
        }

        impl approx::AbsDiffEq for $number {
            type Epsilon = $number;

            fn default_epsilon() -> $number {
                $number::of($number::UNIT)
            }

            fn abs_diff_eq(&self, other: &$number, epsilon: $number) -> bool {
                num_traits::Signed::abs(&(*self - *other)) <= epsilon
            }
        }

        impl approx::RelativeEq for $number {
            fn default_max_relative() -> $number {
                $number::of($number::UNIT)
            }

            fn relative_eq(&self, other: &$number, epsilon: $number, relative: $number) -> bool {
                let (a, b) = (num_traits::Signed::abs(self), num_traits::Signed::abs(other));
                let bound = relative * if a > b { a } else { b };
                num_traits::Signed::abs(&(*self - *other)) <= if bound > epsilon { bound } else { epsilon }
            }
        }

        impl approx::UlpsEq for $number {
            fn default_max_ulps() -> u32 {
                4
            }

            fn ulps_eq(&self, other: &$number, epsilon: $number, ulps: u32) -> bool {
                approx::RelativeEq::relative_eq(self, other, epsilon, $number::of(f64::from(ulps) * $number::UNIT))
            }
        }

        impl simba::simd::SimdValue for $number {
            const LANES: usize = 1;
            type Element = $number;
            type SimdBool = bool;

            #[inline(always)]
            fn splat(value: $number) -> $number {
                value
            }

            #[inline(always)]
            fn extract(&self, _: usize) -> $number {
                *self
            }

            #[expect(unsafe_code, reason = "the trait declares it unsafe; nothing in it is")]
            #[inline(always)]
            unsafe fn extract_unchecked(&self, _: usize) -> $number {
                *self
            }

            #[inline(always)]
            fn replace(&mut self, _: usize, value: $number) {
                *self = value;
            }

            #[expect(unsafe_code, reason = "the trait declares it unsafe; nothing in it is")]
            #[inline(always)]
            unsafe fn replace_unchecked(&mut self, _: usize, value: $number) {
                *self = value;
            }

            #[inline(always)]
            fn select(self, condition: bool, other: $number) -> $number {
                if condition { self } else { other }
            }
        }

        impl simba::scalar::Field for $number {}

        crate::arithmetic::field::subset!($number => $number, |x| x, |x| x);
        crate::arithmetic::field::subset!(f64 => $number, $number::of, |x| x.to_f64());
        crate::arithmetic::field::subset!(f32 => $number, |x| $number::of(f64::from(x)), |x| x.to_f64() as f32);
    };
}

macro_rules! subset {
    ($small:ty => $large:ident, $up:expr, $down:expr) => {
        impl simba::scalar::SubsetOf<$large> for $small {
            #[inline(always)]
            fn to_superset(&self) -> $large {
                let up: fn($small) -> $large = $up;
                up(*self)
            }

            #[inline(always)]
            fn from_superset_unchecked(element: &$large) -> $small {
                let down: fn($large) -> $small = $down;
                down(*element)
            }

            fn is_in_subset(_: &$large) -> bool {
                true
            }
        }
    };
}

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

pub(super) use {analysis, assignments, field, number_traits, operators, subset, with_f64};
