//! Linear drag on every mass point, F_k = −c_k U_k.
//!
//! Reduced: with c = Σ c_k, s = Σ c_k x_k and D = Σ c_k (|x_k|² E − x_k x_kᵀ),
//!     F = −(c U + Ω × s),   τ = −(s × U + D Ω).

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::pose::each_point;
use super::{Cloud, Load, PerPoint, Pose, tensor_to_principal, to_principal};
use crate::arithmetic::Real;
use crate::model::body::{Body, second_moment_inertia};
use crate::rotation;

parameters! {
    /// F_k = −c_k U_k.
    pub struct Drag {
        /// c_k
        coefficient: PerPoint<T> ["N s/m"] = Number(Damping), REQUIRED, each(0.1);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    total: T,
    first: Vector3<T>,
    second: Matrix3<T>,
}

impl<T: Real> Drag<T> {
    /// c, s and D, in principal axes.
    pub(crate) fn sums(&self, body: &Body<T>) -> (T, Vector3<T>, Matrix3<T>) {
        let (mut total, mut first, mut second) = (T::zero(), Vector3::zeros(), Matrix3::zeros());
        for (k, point) in body.points.iter().enumerate() {
            let c = self.coefficient.at(k);
            total += c;
            first += point.position * c;
            second += second_moment_inertia(&point.position) * c;
        }
        (total, to_principal(body, &first), tensor_to_principal(body, &second))
    }
}

impl<T: Real> ForceLaw<T> for Drag<T> {
    const NAME: &'static str = "drag";
    const FORMULA: &'static str = "F_k = -c_k U_k";
    const SOURCE: &'static str = "Stokes's law, linear in the speed";
    const ACTS: Acts = Acts::OnPoints;
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
        false
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
        let (total, first, second) = self.sums(body);
        Reduced { total, first, second }
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        each_point(cloud, load, |k, _, u| u * -self.coefficient.at(k));
    }

    fn potential(&self, _cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        None
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let first = pose.in_world(&self.first);
        let spin = pose.axes.tr_mul(&pose.spin);
        load.force -= pose.velocity * self.total + pose.spin.cross(&first);
        load.torque -= first.cross(&pose.velocity) + pose.in_world(&rotation::applied(&self.second, &spin));
    }
}

impl RandomLaw for Drag {
    /// One coefficient for all points, or one each in proportion to nothing.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let rate = draw.logarithmic(0.03, 0.5);
        let points = &around.body.points;
        let lightest = points.iter().map(|p| p.mass).fold(f64::INFINITY, f64::min);
        let coefficient = if draw.chance(0.5) {
            PerPoint::Same(draw.number(rate * lightest))
        } else {
            let each = |draw: &mut Draw, mass: f64| {
                let part = draw.between(0.2, 1.0);
                draw.number(rate * mass * part)
            };
            PerPoint::Each(points.iter().map(|p| each(draw, p.mass)).collect())
        };
        Some((Drag { coefficient }, rate))
    }
}
