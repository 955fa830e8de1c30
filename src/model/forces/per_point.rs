//! Charges, coefficients: what mass points have one value of each.

use crate::arithmetic::Real;

/// One value for every mass point, or one each: charges, drag coefficients.
#[derive(Clone, Debug, PartialEq)]
pub enum PerPoint<T: Real = f64> {
    /// The same for all.
    Same(T),
    /// In the order of the points.
    Each(Vec<T>),
}

impl<T: Real> PerPoint<T> {
    /// The value of point `index`.
    #[inline]
    pub fn at(&self, index: usize) -> T {
        match self {
            PerPoint::Same(value) => *value,
            PerPoint::Each(values) => values[index],
        }
    }

    /// All of them times `factor`.
    pub fn scaled(&self, factor: T) -> PerPoint<T> {
        match self {
            PerPoint::Same(value) => PerPoint::Same(*value * factor),
            PerPoint::Each(values) => PerPoint::Each(values.iter().map(|value| *value * factor).collect()),
        }
    }
}
