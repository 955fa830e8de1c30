//! What nalgebra asks of a scalar: its operators and the traits of number crates. They are made from a few functions of a type: `plus`,
//! `negative`, `times`, `times_f64`, `over` and the constants `ZERO` and `ONE`; the functions of analysis stand in `analysis`.

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
        crate::arithmetic::analysis::analysis!($number);
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

/// The operator with an f64 on the right. `Mul<f64>` has a cheaper product, which the caller declares.
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

pub(super) use {assignments, field, number_traits, operators, subset, with_f64};
