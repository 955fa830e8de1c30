//! The numbers that a scheme runs in: f64, single precision, double-double.

use std::iter::Sum;
use std::ops::{Add, Div, Sub};

use nalgebra::RealField;

use super::{Number, Registers, Work};

/// A real number in some arithmetic.
///
/// Products with an f64 factor are exact in that factor. A fraction that f64 does not hold is a [`ratio`](Real::ratio).
pub trait Real:
    Number
    + RealField
    + Default
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Div<f64, Output = Self>
    + PartialEq<f64>
    + PartialOrd<f64>
    + Sum
{
    /// The name of the arithmetic, as in `run --precision`.
    const NAME: &'static str;
    /// Twice the largest relative error of a sum, a product or a quotient: in f64 the distance from 1 to the next larger number.
    const UNIT: f64;
    /// Largest |e| for which the series of 1/√(1 + e) may end with its second power:
    /// 5/16 e³ is below a quarter of the unit.
    const LARGEST_EXCESS: f64;

    /// Squares between these two are taken as they are, with all their digits; a longer or a shorter vector is scaled first.
    const PLAIN_SQUARES: [f64; 2];

    /// The number nearest to an f64.
    fn of(value: f64) -> Self;

    /// The nearest f64.
    fn to_f64(self) -> f64;

    /// numerator/denominator, rounded once.
    #[inline(always)]
    fn ratio(numerator: f64, denominator: f64) -> Self {
        Self::of(numerator) / denominator
    }

    /// The number nearest to high + low. A constant of 31 digits is given by the f64 nearest to it and what remains.
    #[inline(always)]
    fn constant(high: f64, low: f64) -> Self {
        Self::of(high) + low
    }

    /// cos x and sin x / x for y = x² ≤ [`LARGEST_SQUARE`](super::series::LARGEST_SQUARE), by their power series
    /// in y.
    fn turn_coefficients(y: Self) -> (Self, Self);

    #[doc(hidden)]
    /// Does work on rows: of eight numbers in the registers given, or of one where the arithmetic has no registers.
    fn by_eight<W: Work<Self>>(registers: Registers, work: W) -> W::Output;
}

impl Real for f64 {
    const NAME: &'static str = "f64";
    const UNIT: f64 = f64::EPSILON;
    const LARGEST_EXCESS: f64 = 1.0 / (1u32 << 20) as f64;
    const PLAIN_SQUARES: [f64; 2] = [1e-280, 1e280];

    #[inline(always)]
    fn of(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline(always)]
    fn turn_coefficients(y: f64) -> (f64, f64) {
        super::series::coefficients(y)
    }

    #[inline(always)]
    fn by_eight<W: Work<f64>>(registers: Registers, work: W) -> W::Output {
        registers.by_eight(work)
    }
}
