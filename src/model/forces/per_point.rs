//! Charges, coefficients: what mass points have one value of each.

/// One value for every mass point, or one each: charges, drag coefficients.
#[derive(Clone, Debug, PartialEq)]
pub enum PerPoint {
    /// The same for all.
    Same(f64),
    /// In the order of the points.
    Each(Vec<f64>),
}

impl PerPoint {
    /// The value of point `index`.
    #[inline]
    pub fn of(&self, index: usize) -> f64 {
        match self {
            PerPoint::Same(value) => *value,
            PerPoint::Each(values) => values[index],
        }
    }

    /// All of them times `factor`.
    pub fn scaled(&self, factor: f64) -> PerPoint {
        match self {
            PerPoint::Same(value) => PerPoint::Same(value * factor),
            PerPoint::Each(values) => PerPoint::Each(values.iter().map(|value| value * factor).collect()),
        }
    }
}
