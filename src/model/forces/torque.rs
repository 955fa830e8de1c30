//! A torque that depends on time alone, fixed in the world or in the body.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose, to_principal};
use crate::model::body::Body;

/// The axes that a torque is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorqueAxes {
    /// World axes.
    World,
    /// Body axes.
    Body,
}

/// τ = constant + cosine cos(ωt) + sine sin(ωt).
#[derive(Clone, Debug, PartialEq)]
pub struct Torque {
    /// Axes of the three amplitudes.
    pub axes: TorqueAxes,
    /// Constant part [N m].
    pub constant: Vector3<f64>,
    /// Amplitude of the cosine [N m].
    pub cosine: Vector3<f64>,
    /// Amplitude of the sine [N m].
    pub sine: Vector3<f64>,
    /// ω [rad/s].
    pub frequency: f64,
}

/// The same law with amplitudes in principal axes, or in world axes as they were.
#[derive(Clone, Debug)]
pub(super) struct Reduced(Torque);

impl Torque {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        let mut law = self.clone();
        if self.axes == TorqueAxes::Body {
            law.constant = to_principal(body, &self.constant);
            law.cosine = to_principal(body, &self.cosine);
            law.sine = to_principal(body, &self.sine);
        }
        Reduced(law)
    }

    /// τ [N m], world; `axes` takes the axes that a body torque is given in to world axes.
    pub(super) fn torque(&self, t: f64, axes: &Matrix3<f64>) -> Vector3<f64> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        let torque = self.constant + self.cosine * cosine + self.sine * sine;
        match self.axes {
            TorqueAxes::World => torque,
            TorqueAxes::Body => axes * torque,
        }
    }
}

impl Reduced {
    pub(super) fn add(&self, t: f64, pose: &Pose, load: &mut Load) {
        load.torque += self.0.torque(t, &pose.axes);
    }
}
