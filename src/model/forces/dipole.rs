//! A dipole fixed in the body, in a uniform field: τ = m × B, energy −m·B.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

/// τ = m × B.
#[derive(Clone, Debug, PartialEq)]
pub struct Dipole<T: Real = f64> {
    /// m [A m²], body axes.
    pub moment: Vector3<T>,
    /// B [T], world axes.
    pub field: Vector3<T>,
}

/// The same law with its moment in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(Dipole<T>);

impl<T: Real> Dipole<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Dipole) -> Dipole<T> {
        Dipole { moment: law.moment.map(T::of), field: law.field.map(T::of) }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced(Dipole { moment: to_principal(body, &self.moment), field: self.field })
    }

    pub(super) fn torque(&self, axes: &Matrix3<T>) -> Vector3<T> {
        (axes * self.moment).cross(&self.field)
    }

    pub(super) fn potential(&self, axes: &Matrix3<T>) -> T {
        -(axes * self.moment).dot(&self.field)
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(&pose.axes);
    }
}
