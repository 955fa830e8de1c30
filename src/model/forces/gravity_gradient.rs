//! The torque of a distant attracting body on an inertia, τ = 3 μ/r³ (r̂ × I r̂): the first term of the
//! expansion of central gravity in the size of the body over the distance.

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// τ = 3 μ/r³ (r̂ × I r̂), with the unit vector r̂ turning at `rate` about `normal`.
    pub struct GravityGradient {
        /// μ/r³
        mu_over_r3: T ["1/s²"] = Number(Gradient), REQUIRED, number(1.0);
        /// r̂ at t = 0, world; a unit vector
        direction: Vector3<T> ["1"] = Direction, REQUIRED, vector(1.0, 0.0, 0.0);
        /// Axis that r̂ turns about, world; a unit vector
        normal: Vector3<T> ["1"] = Axis, Some(vector(0.0, 0.0, 1.0)), vector(0.0, 0.0, 1.0);
        /// Rate of turning
        rate: T ["rad/s"] = Number(Frequency), ZERO, number(0.5);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: GravityGradient<T>,
    moments: Vector3<T>,
}

impl<T: Real> GravityGradient<T> {
    #[inline]
    fn direction_at(&self, t: T) -> Vector3<T> {
        rotation::turn(&(self.normal * (self.rate * t))) * self.direction
    }

    #[inline]
    fn torque(&self, t: T, inertia: &Matrix3<T>) -> Vector3<T> {
        let r = self.direction_at(t);
        r.cross(&rotation::applied(inertia, &r)) * (self.mu_over_r3 * 3.0)
    }
}

impl<T: Real> ForceLaw<T> for GravityGradient<T> {
    const NAME: &'static str = "gravity-gradient";
    const FORMULA: &'static str = "tau = 3 mu/r^3 (r x I r), r a unit vector turning at a rate";
    const SOURCE: &'static str = "Hughes, Spacecraft Attitude Dynamics";
    const ACTS: Acts = Acts::AsTorque;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        false
    }

    fn clock(&self) -> T {
        self.rate
    }

    fn conserves(&self) -> bool {
        self.rate == 0.0
    }

    fn drives(&self) -> bool {
        self.rate != 0.0
    }

    fn is_galilean(&self) -> bool {
        true
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
        Reduced { law: self.clone(), moments: body.moments }
    }

    fn add_on_points(&self, t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(t, &cloud.inertia);
    }

    /// Energy of the orientation, μ/(2 r³) (3 r̂·I r̂ − tr I), up to a constant: 3 μ/(2 r³) r̂·I r̂.
    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        let along = self.direction.dot(&(cloud.inertia * self.direction));
        (self.rate == 0.0).then(|| T::of(1.5) * self.mu_over_r3 * along)
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let r = self.law.direction_at(t);
        let along = pose.axes.tr_mul(&r).component_mul(&self.moments);
        load.torque += r.cross(&pose.in_world(&along)) * (self.law.mu_over_r3 * 3.0);
    }
}

impl RandomLaw for GravityGradient {
    fn random(draw: &mut Draw, _around: &Surroundings) -> Option<(Self, f64)> {
        let rate = draw.logarithmic(0.2, 1.0);
        let direction = draw.vector(1.0);
        let mu_over_r3 = draw.number(rate * rate);
        let mut law = GravityGradient { mu_over_r3, direction, normal: Vector3::z(), rate: 0.0 };
        if draw.chance(0.7) {
            let normal = direction.cross(&draw.vector(1.0));
            if rotation::length(&normal) > 0.1 {
                law.normal = normal;
                law.rate = draw.number(rate);
            }
        }
        Some((law, 1.7 * rate))
    }
}
