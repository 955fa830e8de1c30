//! A torque that depends on time alone, fixed in the world or in the body.

use nalgebra::{Matrix3, Vector3};

use super::{Load, Pose, to_principal};
use crate::arithmetic::Real;
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
pub struct Torque<T: Real = f64> {
    /// Axes of the three amplitudes.
    pub axes: TorqueAxes,
    /// Constant part [N m].
    pub constant: Vector3<T>,
    /// Amplitude of the cosine [N m].
    pub cosine: Vector3<T>,
    /// Amplitude of the sine [N m].
    pub sine: Vector3<T>,
    /// ω [rad/s].
    pub frequency: T,
}

/// The same law with amplitudes in principal axes, or in world axes as they were.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(Torque<T>);

impl<T: Real> Torque<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Torque) -> Torque<T> {
        Torque {
            axes: law.axes,
            constant: law.constant.map(T::of),
            cosine: law.cosine.map(T::of),
            sine: law.sine.map(T::of),
            frequency: T::of(law.frequency),
        }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let mut law = self.clone();
        if self.axes == TorqueAxes::Body {
            law.constant = to_principal(body, &self.constant);
            law.cosine = to_principal(body, &self.cosine);
            law.sine = to_principal(body, &self.sine);
        }
        Reduced(law)
    }

    /// τ [N m], world; `axes` takes the axes that a body torque is given in to world axes.
    pub(super) fn torque(&self, t: T, axes: &Matrix3<T>) -> Vector3<T> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        let torque = self.constant + self.cosine * cosine + self.sine * sine;
        match self.axes {
            TorqueAxes::World => torque,
            TorqueAxes::Body => axes * torque,
        }
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(t, &pose.axes);
    }
}
