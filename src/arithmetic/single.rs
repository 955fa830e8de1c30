//! Single precision, 7 digits: what games and GPUs run.

use std::cmp::Ordering;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

use super::field::field;
use super::{Number, Real, Registers, Row, Work};

/// An f32.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Single(f32);

impl Single {
    const ZERO: Single = Single(0.0);
    const ONE: Single = Single(1.0);
    const PI: Single = Single(std::f32::consts::PI);
    const LN_2: Single = Single(std::f32::consts::LN_2);

    #[inline(always)]
    fn plus(self, other: Single) -> Single {
        Single(self.0 + other.0)
    }

    #[inline(always)]
    fn negative(self) -> Single {
        Single(-self.0)
    }

    #[inline(always)]
    fn times(self, other: Single) -> Single {
        Single(self.0 * other.0)
    }

    #[inline(always)]
    fn times_f64(self, other: f64) -> Single {
        Single(self.0 * other as f32)
    }

    #[inline(always)]
    fn over(self, other: Single) -> Single {
        Single(self.0 / other.0)
    }

    #[inline(always)]
    fn root(self) -> Single {
        Single(self.0.sqrt())
    }

    fn nearest(self) -> Single {
        Single(self.0.round())
    }

    fn down(self) -> Single {
        Single(self.0.floor())
    }

    fn sine_and_cosine(self) -> (Single, Single) {
        let (sine, cosine) = self.0.sin_cos();
        (Single(sine), Single(cosine))
    }

    fn exponential_less_one(self) -> Single {
        Single(self.0.exp_m1())
    }

    fn logarithm(self) -> Single {
        Single(self.0.ln())
    }

    fn angle(self, other: Single) -> Single {
        Single(self.0.atan2(other.0))
    }
}

impl Real for Single {
    const NAME: &'static str = "f32";
    const UNIT: f64 = f32::EPSILON as f64;
    const LARGEST_EXCESS: f64 = 1.0 / (1u32 << 9) as f64;
    const PLAIN_SQUARES: [f64; 2] = [1e-26, 1e34];

    #[inline(always)]
    fn of(value: f64) -> Single {
        Single(value as f32)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }

    /// Terms up to y⁴: the next is below (1/4)⁵/10! = 3e-10.
    #[inline(always)]
    fn turn_coefficients(y: Single) -> (Single, Single) {
        let sum = |terms: [f64; 4]| {
            terms.into_iter().fold(Single::ZERO, |sum, n| (sum * y + Single::ratio(1.0, n)) * -1.0)
        };
        let cosine = sum([40_320.0, 720.0, 24.0, 2.0]);
        let sine = sum([362_880.0, 5_040.0, 120.0, 6.0]);
        (Single::ONE + y * cosine, Single::ONE + y * sine)
    }

    fn by_eight<W: Work<Single>>(_: Registers, work: W) -> W::Output {
        work.with_rows::<Single>(())
    }
}

field!(Single);
