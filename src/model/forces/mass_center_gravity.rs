//! Gravity of a fixed centre on the centre of mass alone, F = −μ M d/|d|³ with d = X_cm − center.
//!
//! The mean motion of a body that is small beside its distance, without the torque of the gradient, which is another law.

use nalgebra::Vector3;

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{CentralGravity, Cloud, Load, Pose, central_gravity, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// F = −μ M d/|d|³, d = X_cm − center.
    pub struct MassCenterGravity {
        /// μ
        mu: T ["m³/s²"] = Number(Central), REQUIRED, number(8.0);
        /// Centre of attraction, world
        center: Vector3<T> ["m"] = Place, ZEROS, vector(0.0, 0.0, 4.0);
    }
}

/// The law, with mass and centre of mass from the origin in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: MassCenterGravity<T>,
    mass: T,
    arm: Vector3<T>,
}

impl<T: Real> MassCenterGravity<T> {
    #[inline]
    fn force(&self, mass: T, position: &Vector3<T>) -> Vector3<T> {
        central_gravity::pull(self.mu, mass, &(position - self.center))
    }
}

impl<T: Real> ForceLaw<T> for MassCenterGravity<T> {
    const NAME: &'static str = "mass-center-gravity";
    const FORMULA: &'static str = "F = -mu M d/|d|^3,  d = X_cm - center";
    const SOURCE: &'static str = "Newton's law of gravitation, on the whole mass in its centre";
    const ACTS: Acts = Acts::OnCenter;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        false
    }

    fn clock(&self) -> T {
        T::zero()
    }

    fn conserves(&self) -> bool {
        true
    }

    fn drives(&self) -> bool {
        false
    }

    fn is_galilean(&self) -> bool {
        false
    }

    fn uniform_acceleration(&self) -> Option<Vector3<T>> {
        None
    }

    fn turns_rod(&self, _: &Vector3<T>, _: T) -> bool {
        false
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced { law: self.clone(), mass: body.mass, arm: to_principal(body, &body.center) }
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.push(&cloud.center, &self.force(cloud.mass, &(cloud.origin + cloud.center)));
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        let d = cloud.origin + cloud.center - self.center;
        Some(-self.mu * cloud.mass / rotation::length(&d))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let arm = pose.in_world(&self.arm);
        load.push(&arm, &self.law.force(self.mass, &(pose.origin + arm)));
    }
}

impl RandomLaw for MassCenterGravity {
    /// As strong, and as far, as the centre that attracts every point.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (CentralGravity { mu, center }, rate) = CentralGravity::random(draw, around)?;
        Some((MassCenterGravity { mu, center }, rate))
    }
}
