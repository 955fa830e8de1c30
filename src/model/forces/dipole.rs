//! A dipole fixed in the body, in a uniform field: τ = m × B, energy −m·B.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose, to_principal};
use crate::model::body::Body;

/// τ = m × B.
#[derive(Clone, Debug, PartialEq)]
pub struct Dipole {
    /// m [A m²], body axes.
    pub moment: Vector3<f64>,
    /// B [T], world axes.
    pub field: Vector3<f64>,
}

/// The same law with its moment in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced(Dipole);

impl Dipole {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        Reduced(Dipole { moment: to_principal(body, &self.moment), field: self.field })
    }

    pub(super) fn torque(&self, axes: &Matrix3<f64>) -> Vector3<f64> {
        (axes * self.moment).cross(&self.field)
    }

    pub(super) fn potential(&self, axes: &Matrix3<f64>) -> f64 {
        -(axes * self.moment).dot(&self.field)
    }
}

impl Reduced {
    pub(super) fn add(&self, pose: &Pose, load: &mut Load) {
        load.torque += self.0.torque(&pose.axes);
    }
}
