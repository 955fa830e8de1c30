//! Uniform gravity, F_k = M_k g: one force M g in the centre of mass.

use nalgebra::Vector3;

use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

/// F_k = M_k g.
#[derive(Clone, Debug, PartialEq)]
pub struct Gravity<T: Real = f64> {
    /// g [m/s²], world.
    pub acceleration: Vector3<T>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    weight: Vector3<T>,
    /// Centre of mass from the origin, principal axes; zero unless there is a pivot.
    center: Vector3<T>,
}

impl<T: Real> Gravity<T> {
    /// The same law in this arithmetic.
    pub(super) fn of(law: &Gravity) -> Gravity<T> {
        Gravity { acceleration: law.acceleration.map(T::of) }
    }

    pub(super) fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced { weight: self.acceleration * body.mass, center: to_principal(body, &body.center) }
    }

    /// A body without mass points still has its weight.
    pub(super) fn add_on_points(&self, cloud: &Cloud<T>, load: &mut Load<T>) {
        if cloud.masses.is_empty() {
            load.push(&cloud.center, &(self.acceleration * cloud.mass));
        }
        for (k, mass) in cloud.masses.iter().enumerate() {
            load.push(&cloud.levers.at(k), &(self.acceleration * *mass));
        }
    }

    pub(super) fn potential(&self, cloud: &Cloud<T>) -> T {
        -cloud.mass * self.acceleration.dot(&(cloud.origin + cloud.center))
    }
}

impl<T: Real> Reduced<T> {
    pub(super) fn add(&self, pose: &Pose<T>, load: &mut Load<T>) {
        load.push(&(pose.axes * self.center), &self.weight);
    }
}
