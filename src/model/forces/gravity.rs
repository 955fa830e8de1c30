//! Uniform gravity, F_k = M_k g: one force M g in the centre of mass.

use nalgebra::Vector3;

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

parameters! {
    /// F_k = M_k g.
    pub struct Gravity {
        /// g, world
        acceleration: Vector3<T> ["m/s²"] = World(Acceleration), REQUIRED, vector(0.0, 0.0, -9.81);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    weight: Vector3<T>,
    /// Centre of mass from the origin, principal axes; zero unless there is a pivot.
    center: Vector3<T>,
}

impl<T: Real> ForceLaw<T> for Gravity<T> {
    const NAME: &'static str = "gravity";
    const FORMULA: &'static str = "F_k = M_k g";
    const SOURCE: &'static str = "uniform weight";
    const ACTS: Acts = Acts::OnMass;
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
        Some(self.acceleration)
    }

    fn turns_rod(&self, _: &Vector3<T>, _: T) -> bool {
        false
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced { weight: self.acceleration * body.mass, center: to_principal(body, &body.center) }
    }

    /// A body without mass points still has its weight.
    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        if cloud.masses.is_empty() {
            load.push(&cloud.center, &(self.acceleration * cloud.mass));
        }
        for (k, mass) in cloud.masses.iter().enumerate() {
            load.push(&cloud.levers.at(k), &(self.acceleration * *mass));
        }
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        Some(-cloud.mass * self.acceleration.dot(&(cloud.origin + cloud.center)))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.push(&pose.in_world(&self.center), &self.weight);
    }
}

impl RandomLaw for Gravity {
    fn random(draw: &mut Draw, _around: &Surroundings) -> Option<(Self, f64)> {
        let rate = draw.logarithmic(0.2, 1.0);
        Some((Gravity { acceleration: draw.vector(rate * rate) }, rate))
    }
}
