//! Wheels at a fixed speed: a constant angular momentum h inside the body, as of a gyrostat.
//!
//! The whole angular momentum I Ω + R h changes by the torques of the other laws alone. The L of a state is I Ω, that of the body
//! with its wheels locked, and d(R h)/dt = Ω × R h acts on it from the other side:
//!
//! ```text
//! Ω = I⁻¹ (L_whole − R h),   dL/dt = τ − Ω × R h
//! ```
//!
//! The power of this torque is Ω·(Ω × R h) = 0: a free gyrostat keeps ½ Ω·L.

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
    /// τ = −Ω × R h.
    pub struct Wheels {
        /// h, body axes; of the wheels relative to the body
        momentum: Vector3<T> ["kg m²/s"] = Body(AngularMomentum), REQUIRED, vector(0.5, 0.0, 1.0);
    }
}

/// The same law with h in principal axes.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(Wheels<T>);

impl<T: Real> Wheels<T> {
    #[inline]
    fn torque(&self, axes: &Matrix3<T>, spin: &Vector3<T>) -> Vector3<T> {
        rotation::applied(axes, &self.momentum).cross(spin)
    }
}

impl<T: Real> ForceLaw<T> for Wheels<T> {
    const NAME: &'static str = "wheels";
    const FORMULA: &'static str = "tau = -Omega x R h: I Omega + R h is conserved";
    const SOURCE: &'static str = "a gyrostat; Hughes, Spacecraft Attitude Dynamics";
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
        rotation::length(&self.momentum.cross(direction)) > rotation::length(&self.momentum) * ALONG_ROD
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        Reduced(Wheels { momentum: to_principal(body, &self.momentum) })
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(&cloud.axes, &cloud.spin);
    }

    fn potential(&self, _cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        Some(T::zero())
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(&pose.axes, &pose.spin);
    }
}

impl RandomLaw for Wheels {
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (_, smallest) = around.moments()?;
        let rate = draw.logarithmic(0.2, 2.0);
        let size = rate * smallest;
        let momentum = around.rod().map_or_else(|| draw.vector(size), |direction| direction * size);
        Some((Wheels { momentum }, rate))
    }
}
