//! Gravity of a fixed centre on every mass point, F_k = −μ M_k d/|d|³ with d = X_k − center.
//!
//! Not polynomial in X̃_k: the reduced form visits the points too.

use nalgebra::Vector3;

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::pose::{each_point, sum_points};
use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::{Body, MassPoint};
use crate::rotation;

parameters! {
    /// F_k = −μ M_k d/|d|³, d = X_k − center.
    pub struct CentralGravity {
        /// μ
        mu: T ["m³/s²"] = Number(Central), REQUIRED, number(8.0);
        /// Centre, world
        center: Vector3<T> ["m"] = Place, ZEROS, vector(0.0, 0.0, 4.0);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: CentralGravity<T>,
    points: Vec<MassPoint<T>>,
}

/// −μ M d/|d|³ for d from the centre.
#[inline(always)]
pub(super) fn pull<T: Real>(mu: T, mass: T, d: &Vector3<T>) -> Vector3<T> {
    let distance = rotation::length(d);
    d * (-mu * mass / (distance * distance * distance))
}

impl<T: Real> CentralGravity<T> {
    #[inline]
    fn force(&self, mass: T, position: &Vector3<T>) -> Vector3<T> {
        pull(self.mu, mass, &(position - self.center))
    }
}

impl<T: Real> ForceLaw<T> for CentralGravity<T> {
    const NAME: &'static str = "central-gravity";
    const FORMULA: &'static str = "F_k = -mu M_k d/|d|^3,  d = X_k - center";
    const SOURCE: &'static str = "Newton's law of gravitation";
    const ACTS: Acts = Acts::OnPoints;
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
        let to_principal_axes =
            |p: &MassPoint<T>| MassPoint { mass: p.mass, position: to_principal(body, &p.position) };
        Reduced { law: self.clone(), points: body.points.iter().map(to_principal_axes).collect() }
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        each_point(cloud, load, |k, x, _| self.force(cloud.masses[k], x));
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        let potential =
            |k: usize, x: &Vector3<T>| -self.mu * cloud.masses[k] / rotation::length(&(x - self.center));
        Some(sum_points(cloud, potential))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        for point in &self.points {
            let arm = pose.in_world(&point.position);
            load.push(&arm, &self.law.force(point.mass, &(pose.origin + arm)));
        }
    }
}

impl RandomLaw for CentralGravity {
    /// From so far, with a velocity across, or for so short that the body does not fall into the centre within the run: from
    /// rest it takes 1.1 over the rate.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let distance = draw.between(5.0, 9.0);
        let any = draw.vector(distance);
        let (rate, center, longest) = match around.velocity {
            Some(velocity) => {
                let across = velocity.cross(&any).normalize() * distance;
                let circular = rotation::length(&velocity) / distance;
                (circular * draw.between(0.8, 1.2), across, 10.0)
            }
            None => (draw.logarithmic(0.1, 0.5), any, 0.8),
        };
        let center = (around.position + center).map(|x| draw.number(x));
        let mu = draw.number(rate * rate * distance.powi(3));
        Some((CentralGravity { mu, center }, rate * around.radians / longest))
    }
}
