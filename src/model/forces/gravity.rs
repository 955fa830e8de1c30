//! Uniform gravity, F_k = M_k g: one force M g in the centre of mass.

use nalgebra::Vector3;

use super::{Cloud, Load, Pose, to_principal};
use crate::model::body::Body;

/// F_k = M_k g.
#[derive(Clone, Debug, PartialEq)]
pub struct Gravity {
    /// g [m/s²], world.
    pub acceleration: Vector3<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct Reduced {
    weight: Vector3<f64>,
    /// Centre of mass from the origin, principal axes; zero unless there is a pivot.
    center: Vector3<f64>,
}

impl Gravity {
    pub(super) fn reduce(&self, body: &Body) -> Reduced {
        Reduced { weight: self.acceleration * body.mass, center: to_principal(body, &body.center) }
    }

    /// A body without mass points still has its weight.
    pub(super) fn add_on_points(&self, cloud: &Cloud, load: &mut Load) {
        if cloud.masses.is_empty() {
            load.push(&cloud.center, &(self.acceleration * cloud.mass));
        }
        for (k, mass) in cloud.masses.iter().enumerate() {
            load.push(&cloud.levers.at(k), &(self.acceleration * *mass));
        }
    }

    pub(super) fn potential(&self, cloud: &Cloud) -> f64 {
        -cloud.mass * self.acceleration.dot(&(cloud.origin + cloud.center))
    }
}

impl Reduced {
    pub(super) fn add(&self, pose: &Pose, load: &mut Load) {
        load.push(&(pose.axes * self.center), &self.weight);
    }
}
