//! A torque that depends on time alone, fixed in the world or in the body.

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{ALONG_ROD, Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

/// The axes that a torque is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorqueAxes {
    /// World axes.
    World,
    /// Body axes.
    Body,
}

impl TorqueAxes {
    /// Both.
    pub const ALL: [TorqueAxes; 2] = [TorqueAxes::World, TorqueAxes::Body];

    /// The word of a scene file.
    pub fn word(self) -> &'static str {
        match self {
            TorqueAxes::World => "world",
            TorqueAxes::Body => "body",
        }
    }
}

parameters! {
    /// τ = constant + cosine cos(ωt) + sine sin(ωt).
    pub struct Torque {
        /// Axes of the three amplitudes
        axes: TorqueAxes ["\"world\" or \"body\""] = Word, REQUIRED, axes(TorqueAxes::Body);
        /// Constant part
        constant: Vector3<T> ["N m"] = Stated(Torque), ZEROS, vector(0.0, 0.0, 1.0);
        /// Amplitude of the cosine
        cosine: Vector3<T> ["N m"] = Stated(Torque), ZEROS, vector(1.0, 0.0, 0.0);
        /// Amplitude of the sine
        sine: Vector3<T> ["N m"] = Stated(Torque), ZEROS, vector(0.0, 1.0, 0.0);
        /// ω
        frequency: T ["rad/s"] = Number(Frequency), ZERO, number(2.0);
    }
}

/// The same law with amplitudes in principal axes, or in world axes as they were.
#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64>(Torque<T>);

impl<T: Real> Torque<T> {
    /// τ [N m], world; `axes` takes the axes that a body torque is given in to world axes.
    #[inline]
    fn torque(&self, t: T, axes: &Matrix3<T>) -> Vector3<T> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        let torque = self.constant + self.cosine * cosine + self.sine * sine;
        match self.axes {
            TorqueAxes::World => torque,
            TorqueAxes::Body => rotation::applied(axes, &torque),
        }
    }
}

impl<T: Real> ForceLaw<T> for Torque<T> {
    const NAME: &'static str = "torque";
    const FORMULA: &'static str = "tau = constant + cosine cos(wt) + sine sin(wt), world or body axes";
    const SOURCE: &'static str = "a prescribed torque";
    const ACTS: Acts = Acts::AsTorque;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        false
    }

    fn clock(&self) -> T {
        if self.cosine.amax() != 0.0 || self.sine.amax() != 0.0 { self.frequency } else { T::zero() }
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
        [self.constant, self.cosine, self.sine].iter().any(|amplitude| {
            let along = amplitude.dot(direction).abs() > rotation::length(amplitude) * ALONG_ROD;
            along || (self.axes == TorqueAxes::World && amplitude.amax() > 0.0)
        })
    }

    fn contradiction(&self) -> Option<(&'static str, &'static str)> {
        None
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let mut law = self.clone();
        if self.axes == TorqueAxes::Body {
            law.constant = to_principal(body, &self.constant);
            law.cosine = to_principal(body, &self.cosine);
            law.sine = to_principal(body, &self.sine);
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

impl RandomLaw for Torque {
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let (moment, smallest) = around.moments()?;
        let (rate, frequency) = (draw.logarithmic(0.2, 1.0), draw.logarithmic(0.3, 3.0));
        let size = rate * rate * moment;
        let rod = around.rod();
        let in_body = rod.is_some() || draw.chance(0.5);
        let [constant, cosine, sine] = [(); 3].map(|()| {
            if !draw.chance(0.6) {
                return Vector3::zeros();
            }
            let any = draw.vector(size);
            rod.map_or(any, |direction| direction.cross(&any))
        });
        let axes = if in_body { TorqueAxes::Body } else { TorqueAxes::World };
        let law = Torque { axes, constant, cosine, sine, frequency };
        Some((law, (size / smallest).sqrt() + frequency))
    }
}
