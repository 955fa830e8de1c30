//! A torque that acts for a time: a thruster that is fired once.
//!
//! The torque jumps at `start` and at `end`. A run decides by the middle of a step whether the whole step is within the pulse, so that
//! every stage of a step sees one constant torque. Where steps end at the jumps, a one-step scheme keeps its order. Where a step lies
//! across a jump, its torque is off by up to half a step of the pulse, and every order falls to one.

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{ALONG_ROD, Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, TorqueAxes, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// τ = torque from `start` until `end`, and zero else.
    pub struct TorquePulse {
        /// Axes of the torque
        axes: TorqueAxes ["\"world\" or \"body\""] = Word, REQUIRED, axes(TorqueAxes::Body);
        /// The torque while it acts
        torque: Vector3<T> ["N m"] = Stated(Torque), REQUIRED, vector(0.25, 0.5, 1.0);
        /// Time at which it sets in
        start: T ["s"] = Jump, ZERO, number(0.0);
        /// Time at which it ends
        end: T ["s"] = Jump, REQUIRED, number(1.0);
    }
}

/// The same law with its torque in principal axes, or in world axes as it was.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(TorquePulse<T>);

impl<T: Real> TorquePulse<T> {
    /// τ [N m], world; `axes` takes the axes that a body torque is given in to world axes.
    #[inline]
    fn torque(&self, t: T, axes: &Matrix3<T>) -> Vector3<T> {
        match self.axes {
            _ if !(self.start <= t && t < self.end) => Vector3::zeros(),
            TorqueAxes::World => self.torque,
            TorqueAxes::Body => rotation::applied(axes, &self.torque),
        }
    }
}

impl<T: Real> ForceLaw<T> for TorquePulse<T> {
    const NAME: &'static str = "torque-pulse";
    const FORMULA: &'static str = "tau = torque where start <= t < end, else 0, world or body axes";
    const SOURCE: &'static str = "a prescribed torque, as of a thruster";
    const ACTS: Acts = Acts::AsTorque;
    const HAS_KINK: bool = true;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        false
    }

    /// A turn in twice the time of the pulse.
    fn clock(&self) -> T {
        let time = self.end - self.start;
        if time.is_finite() { T::of(std::f64::consts::PI) / time } else { T::zero() }
    }

    fn conserves(&self) -> bool {
        false
    }

    fn drives(&self) -> bool {
        true
    }

    fn is_galilean(&self) -> bool {
        true
    }

    fn uniform_acceleration(&self) -> Option<Vector3<T>> {
        None
    }

    fn turns_rod(&self, direction: &Vector3<T>, _extent: T) -> bool {
        let along = self.torque.dot(direction).abs() > rotation::length(&self.torque) * ALONG_ROD;
        along || (self.axes == TorqueAxes::World && self.torque.amax() > 0.0)
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        (self.end <= self.start).then_some(("end", "a time after start"))
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let mut law = self.clone();
        if self.axes == TorqueAxes::Body {
            law.torque = to_principal(body, &self.torque);
        }
        Reduced(law)
    }

    fn add_on_points(&self, t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        load.torque += self.torque(t, &cloud.axes);
    }

    fn potential(&self, _cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        None
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        load.torque += self.0.torque(t, &pose.axes);
    }
}

impl RandomLaw for TorquePulse {
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (moment, smallest) = around.moments()?;
        let rate = draw.logarithmic(0.2, 1.0);
        let size = rate * rate * moment;
        let rod = around.rod();
        let in_body = rod.is_some() || draw.chance(0.5);
        let any = draw.vector(size);
        let torque = rod.map_or(any, |direction| direction.cross(&any));
        let (start, time) = (draw.between(0.0, 1.0), draw.between(0.5, 2.0));
        let axes = if in_body { TorqueAxes::Body } else { TorqueAxes::World };
        Some((TorquePulse { axes, torque, start, end: start + time }, (size / smallest).sqrt() + 1.0))
    }
}
