//! A dipole fixed in the body, in a uniform field: τ = m × B, energy −m·B.

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{ALONG_ROD, Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// τ = m × B.
    pub struct Dipole {
        /// m, body axes
        moment: Vector3<T> ["A m²"] = Body(Torque), REQUIRED, vector(0.0, 0.0, 1.0);
        /// B, world
        field: Vector3<T> ["T"] = World(Pure), REQUIRED, vector(0.0, 0.1, 0.0);
    }
}

/// The same law with its moment in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(Dipole<T>);

impl<T: Real> Dipole<T> {
    #[inline]
    fn torque(&self, axes: &Matrix3<T>) -> Vector3<T> {
        rotation::applied(axes, &self.moment).cross(&self.field)
    }
}

impl<T: Real> ForceLaw<T> for Dipole<T> {
    const NAME: &'static str = "dipole";
    const FORMULA: &'static str = "tau = m x B";
    const SOURCE: &'static str = "a moment in a uniform field; Jackson, Classical Electrodynamics";
    const ACTS: Acts = Acts::AsTorque;
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
        true
    }

    fn uniform_acceleration(&self) -> Option<Vector3<T>> {
        None
    }

    fn turns_rod(&self, direction: &Vector3<T>, _extent: T) -> bool {
        let across = rotation::length(&self.moment.cross(direction));
        across > rotation::length(&self.moment) * ALONG_ROD
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced(Dipole { moment: to_principal(body, &self.moment), field: self.field })
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(&cloud.axes);
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        Some(-(cloud.axes * self.moment).dot(&self.field))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(&pose.axes);
    }
}

impl RandomLaw for Dipole {
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (moment, smallest) = around.moments()?;
        let rate = draw.logarithmic(0.3, 1.0);
        let size = rate * rate * moment;
        let moment = around.rod().map_or_else(|| draw.vector(size), |direction| direction * size);
        Some((Dipole { moment, field: draw.vector(1.0) }, (size / smallest).sqrt()))
    }
}
