//! A dipole fixed in the body, in a field that changes along an orbit: τ = m × B(t).
//!
//! Along a circular orbit of rate n about a unit vector a, from r̂₀:
//!
//! - a field that turns with the orbit has B₀ = a (a·B(0)), B_c = B(0) − B₀, B_s = a × B(0), ω = n;
//! - the field 3 (b·r̂) r̂ − b of a central dipole has, with d = a × r̂₀, ω = 2n,
//!   B₀ = (3/2) ((b·r̂₀) r̂₀ + (b·d) d) − b,
//!   B_c = (3/2) ((b·r̂₀) r̂₀ − (b·d) d),
//!   B_s = (3/2) ((b·d) r̂₀ + (b·r̂₀) d).

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
    /// τ = m × B(t), B = B₀ + B_c cos ωt + B_s sin ωt.
    pub struct OrbitingDipole {
        /// m, body axes
        moment: Vector3<T> ["A m²"] = Body(Torque), REQUIRED, vector(0.0, 0.0, 1.0);
        /// B₀, constant part, world
        field: Vector3<T> ["T"] = World(Pure), ZEROS, vector(0.05, 0.0, 0.0);
        /// B_c, amplitude of the cosine, world
        field_cosine: Vector3<T> ["T"] = World(Pure), ZEROS, vector(0.0, 0.1, 0.0);
        /// B_s, amplitude of the sine, world
        field_sine: Vector3<T> ["T"] = World(Pure), ZEROS, vector(0.0, 0.0, 0.1);
        /// ω
        frequency: T ["rad/s"] = Number(Frequency), REQUIRED, number(2.0);
    }
}

/// The same law with its moment in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(OrbitingDipole<T>);

impl<T: Real> OrbitingDipole<T> {
    #[inline]
    fn torque(&self, t: T, axes: &Matrix3<T>) -> Vector3<T> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        rotation::applied(axes, &self.moment)
            .cross(&(self.field + self.field_cosine * cosine + self.field_sine * sine))
    }

    fn is_static(&self) -> bool {
        self.field_cosine.amax() == 0.0 && self.field_sine.amax() == 0.0 || self.frequency == 0.0
    }
}

impl<T: Real> ForceLaw<T> for OrbitingDipole<T> {
    const NAME: &'static str = "orbiting-dipole";
    const FORMULA: &'static str = "tau = m x B(t),  B = field + field_cosine cos(wt) + field_sine sin(wt)";
    const SOURCE: &'static str = "a moment in a uniform field that changes with the place on an orbit; Hughes, Spacecraft Attitude Dynamics";
    const ACTS: Acts = Acts::AsTorque;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        false
    }

    fn clock(&self) -> T {
        if self.is_static() { T::zero() } else { self.frequency }
    }

    fn conserves(&self) -> bool {
        self.is_static()
    }

    fn drives(&self) -> bool {
        !self.is_static()
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
        Reduced(OrbitingDipole { moment: to_principal(body, &self.moment), ..self.clone() })
    }

    fn add_on_points(&self, t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(t, &cloud.axes);
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        let moment = cloud.axes * self.moment;
        self.is_static().then(|| -moment.dot(&(self.field + self.field_cosine)))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(t, &pose.axes);
    }
}

impl RandomLaw for OrbitingDipole {
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (moment, smallest) = around.moments()?;
        let (rate, frequency) = (draw.logarithmic(0.3, 1.0), draw.logarithmic(0.3, 3.0));
        let size = rate * rate * moment;
        let moment = around.rod().map_or_else(|| draw.vector(size), |direction| direction * size);
        let [field, field_cosine, field_sine] = [(); 3].map(|()| draw.vector(0.6));
        let law = OrbitingDipole { moment, field, field_cosine, field_sine, frequency };
        Some((law, (size / smallest).sqrt() + frequency))
    }
}
