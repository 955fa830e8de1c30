//! Rotational damping, τ = −C Ω, with a symmetric C that is fixed in the body.

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{ALONG_ROD, Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, tensor_to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// τ = −C Ω.
    pub struct RotationalDamping {
        /// C, body axes; three numbers on the diagonal, or three rows
        coefficients: Matrix3<T> ["N m s"] = Body(AngularMomentum), REQUIRED, diagonal(0.1, 0.2, 0.3);
    }
}

/// The same law with C in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(RotationalDamping<T>);

impl<T: Real> RotationalDamping<T> {
    /// τ [N m], world; `axes` takes the axes that C is given in to world axes.
    #[inline]
    fn torque(&self, axes: &Matrix3<T>, spin: &Vector3<T>) -> Vector3<T> {
        -rotation::applied(axes, &rotation::applied(&self.coefficients, &axes.tr_mul(spin)))
    }
}

impl<T: Real> ForceLaw<T> for RotationalDamping<T> {
    const NAME: &'static str = "rotational-damping";
    const FORMULA: &'static str = "tau = -C Omega, C a symmetric matrix in body axes";
    const SOURCE: &'static str = "a viscous moment, linear in the angular velocity";
    const ACTS: Acts = Acts::AsTorque;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        true
    }

    fn clock(&self) -> T {
        T::zero()
    }

    fn conserves(&self) -> bool {
        false
    }

    fn drives(&self) -> bool {
        false
    }

    fn is_galilean(&self) -> bool {
        true
    }

    fn uniform_acceleration(&self) -> Option<Vector3<T>> {
        None
    }

    /// Unless the rod is an axis of C.
    fn turns_rod(&self, direction: &Vector3<T>, _extent: T) -> bool {
        let turned = self.coefficients * direction;
        rotation::length(&turned.cross(direction)) > self.coefficients.amax() * ALONG_ROD
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        let skew = self.coefficients - self.coefficients.transpose();
        (skew.amax() > 0.0).then_some(("coefficients", "a symmetric matrix"))
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced(RotationalDamping { coefficients: tensor_to_principal(body, &self.coefficients) })
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(&cloud.axes, &cloud.spin);
    }

    fn potential(&self, _cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        None
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(&pose.axes, &pose.spin);
    }
}

impl RandomLaw for RotationalDamping {
    /// Three coefficients about the body axes; one for a rod, which need not lie along an axis.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (_, smallest) = around.moments()?;
        let rate = draw.logarithmic(0.03, 0.5);
        let most = draw.number(rate * smallest);
        let diagonal = match around.rod() {
            Some(_) => Vector3::repeat(most),
            None => Vector3::from_fn(|_, _| draw.between(0.2, 1.0)).map(|part| draw.number(most * part)),
        };
        Some((RotationalDamping { coefficients: Matrix3::from_diagonal(&diagonal) }, rate))
    }
}
