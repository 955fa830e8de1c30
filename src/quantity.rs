//! The six quantities whose errors have an order, and a value for each of them.

use std::array;
use std::iter::Zip;
use std::ops::{Index, IndexMut};

use serde::{Deserialize, Serialize};

/// A quantity whose error against the reference has an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// X_cm [m].
    Position,
    /// U_cm [m/s].
    Velocity,
    /// Angle of the relative rotation [rad]; of the axis for a rod.
    Orientation,
    /// Ω [rad/s].
    AngularVelocity,
    /// L [kg m²/s].
    AngularMomentum,
    /// Largest error of a point of the body [m]: this one exists for every body.
    BodyPoint,
}

impl Quantity {
    /// All quantities, in the order of reports.
    pub const ALL: [Quantity; 6] = [
        Quantity::Position,
        Quantity::Velocity,
        Quantity::Orientation,
        Quantity::AngularVelocity,
        Quantity::AngularMomentum,
        Quantity::BodyPoint,
    ];

    /// Name in records.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Position => "position",
            Quantity::Velocity => "velocity",
            Quantity::Orientation => "orientation",
            Quantity::AngularVelocity => "angular-velocity",
            Quantity::AngularMomentum => "angular-momentum",
            Quantity::BodyPoint => "body-point",
        }
    }

    /// Unit of its error.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::Position | Quantity::BodyPoint => "m",
            Quantity::Velocity => "m/s",
            Quantity::Orientation => "rad",
            Quantity::AngularVelocity => "rad/s",
            Quantity::AngularMomentum => "kg m²/s",
        }
    }
}

/// A value for each quantity, found by the quantity: `errors[Quantity::Orientation]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PerQuantity<T>([T; Quantity::ALL.len()]);

impl<T> PerQuantity<T> {
    /// What `value` gives for each quantity.
    pub fn of(value: impl FnMut(Quantity) -> T) -> PerQuantity<T> {
        PerQuantity(Quantity::ALL.map(value))
    }

    /// Each quantity with its value, in the order of [`Quantity::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Quantity, &T)> {
        Quantity::ALL.into_iter().zip(&self.0)
    }

    /// The values alone, in the same order.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.0.iter()
    }

    /// The same function of every value.
    pub fn map<U>(self, function: impl FnMut(T) -> U) -> PerQuantity<U> {
        PerQuantity(self.0.map(function))
    }

    /// The values of two in pairs.
    pub fn zip<U>(self, other: PerQuantity<U>) -> PerQuantity<(T, U)> {
        let mut others = other.0.into_iter();
        self.map(|value| (value, others.next().expect("as many values")))
    }
}

impl<T: Copy> PerQuantity<T> {
    /// The same value for each quantity.
    pub const fn all(value: T) -> PerQuantity<T> {
        PerQuantity([value; Quantity::ALL.len()])
    }
}

impl PerQuantity<f64> {
    /// The larger value of each quantity; the other one where one is NaN.
    pub fn max(self, other: PerQuantity<f64>) -> PerQuantity<f64> {
        self.zip(other).map(|(a, b)| a.max(b))
    }
}

/// The larger of two numbers; NaN if either is, where `f64::max` hides it.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// Values in the order of [`Quantity::ALL`].
impl<T> From<[T; Quantity::ALL.len()]> for PerQuantity<T> {
    fn from(values: [T; Quantity::ALL.len()]) -> PerQuantity<T> {
        PerQuantity(values)
    }
}

impl<T> Index<Quantity> for PerQuantity<T> {
    type Output = T;

    fn index(&self, quantity: Quantity) -> &T {
        &self.0[quantity as usize]
    }
}

impl<T> IndexMut<Quantity> for PerQuantity<T> {
    fn index_mut(&mut self, quantity: Quantity) -> &mut T {
        &mut self.0[quantity as usize]
    }
}

impl<T> IntoIterator for PerQuantity<T> {
    type Item = (Quantity, T);
    type IntoIter =
        Zip<array::IntoIter<Quantity, { Quantity::ALL.len() }>, array::IntoIter<T, { Quantity::ALL.len() }>>;

    fn into_iter(self) -> Self::IntoIter {
        Quantity::ALL.into_iter().zip(self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_found_by_its_quantity() {
        for (place, quantity) in Quantity::ALL.into_iter().enumerate() {
            assert_eq!(quantity as usize, place);
        }
        let mut values = PerQuantity::of(Quantity::unit);
        assert_eq!(values[Quantity::Orientation], "rad");
        values[Quantity::Orientation] = "degrees";
        let units: Vec<&str> = values.values().copied().collect();
        assert_eq!(units, ["m", "m/s", "degrees", "rad/s", "kg m²/s", "m"]);
        assert!(values.into_iter().all(|(quantity, unit)| quantity.unit() == unit || unit == "degrees"));
    }

    #[test]
    fn the_larger_of_two_is_no_nan() {
        let (one, other) = (PerQuantity::all(1.0), PerQuantity::from([0.0, 2.0, f64::NAN, 1.0, -1.0, 3.0]));
        assert_eq!(one.max(other), PerQuantity::from([1.0, 2.0, 1.0, 1.0, 1.0, 3.0]));
        assert_eq!(one.zip(other)[Quantity::Velocity], (1.0, 2.0));
    }
}
