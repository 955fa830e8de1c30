//! A one-sided elastic plane with damping and regularised friction, on every mass point.
//!
//! At depth d = height − X_k·n > 0 the plane pushes with N = max(k d − c U_k·n, 0) along n and rubs with
//! −μ N s/√(s·s + v₀²), s the velocity along the plane. The force has a kink on touching: no scheme keeps its
//! order across it.

use nalgebra::Vector3;

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::pose::{each_point, sum_points};
use super::{Cloud, Load, Pose, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;

parameters! {
    /// A penalty ground.
    pub struct Ground {
        /// n, world; a unit vector
        normal: Vector3<T> ["1"] = Direction, Some(vector(0.0, 0.0, 1.0)), vector(0.0, 0.0, 1.0);
        /// Height of the plane along n
        height: T ["m"] = Height, ZERO, number(0.0);
        /// k
        stiffness: T ["N/m"] = Number(Stiffness), REQUIRED, number(100.0);
        /// c
        damping: T ["N s/m"] = Number(Damping), ZERO, number(0.5);
        /// μ
        friction: T ["1"] = Number(Pure), ZERO, number(0.3);
        /// v₀
        slip_velocity: T ["m/s"] = Number(Velocity), Some(number(1e-3)), number(1e-3);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: Ground<T>,
    points: Vec<Vector3<T>>,
}

impl<T: Real> Ground<T> {
    #[inline]
    fn force(&self, position: &Vector3<T>, velocity: &Vector3<T>) -> Vector3<T> {
        let depth = self.height - position.dot(&self.normal);
        if depth <= 0.0 {
            return Vector3::zeros();
        }
        let approach = velocity.dot(&self.normal);
        let push = (self.stiffness * depth - self.damping * approach).max(T::zero());
        let sliding = velocity - self.normal * approach;
        let speed = (sliding.norm_squared() + self.slip_velocity * self.slip_velocity).sqrt();
        let rub = if speed == 0.0 { speed } else { self.friction * push / speed };
        self.normal * push - sliding * rub
    }
}

impl<T: Real> ForceLaw<T> for Ground<T> {
    const NAME: &'static str = "ground";
    const FORMULA: &'static str =
        "F_k = (k d - c U_k.n)+ n and friction -mu N s/sqrt(s.s + v0^2), d = height - X_k.n > 0";
    const SOURCE: &'static str = "penalty contact with regularised Coulomb friction";
    const ACTS: Acts = Acts::OnPoints;
    const HAS_KINK: bool = true;
    const SPLITS: bool = false;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        self.damping != 0.0 || self.friction != 0.0
    }

    fn clock(&self) -> T {
        T::zero()
    }

    fn conserves(&self) -> bool {
        self.damping == 0.0 && self.friction == 0.0
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
        (self.friction != 0.0 && self.slip_velocity <= 0.0)
            .then_some(("slip_velocity", "a velocity above zero where there is friction"))
    }

    fn reduce(&self, body: &Body<T>) -> Reduced<T> {
        let points = body.points.iter().map(|p| to_principal(body, &p.position)).collect();
        Reduced { law: self.clone(), points }
    }

    fn add_on_points(&self, _t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        each_point(cloud, load, |_, x, u| self.force(x, u));
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        Some(sum_points(cloud, |_, x| {
            let depth = (self.height - x.dot(&self.normal)).max(T::zero());
            T::of(0.5) * self.stiffness * depth * depth
        }))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, _t: T, pose: &Pose<T>, load: &mut Load<T>) {
        for point in &self.points {
            let arm = pose.in_world(point);
            load.push(&arm, &self.law.force(&(pose.origin + arm), &pose.velocity_at(&arm)));
        }
    }
}

impl RandomLaw for Ground {
    /// Below the body, stiff.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        if !draw.chance(0.4) {
            return None;
        }
        let rate = draw.logarithmic(2.0, 6.0);
        let height = draw.number(around.position.z - 1.5);
        let stiffness = draw.number(rate * rate);
        let damping = if draw.chance(0.5) { draw.number(0.2 * rate) } else { 0.0 };
        let (friction, slip_velocity) =
            if draw.chance(0.5) { (draw.between(0.1, 0.6), 0.125) } else { (0.0, 1e-3) };
        Some((Ground { normal: Vector3::z(), height, stiffness, damping, friction, slip_velocity }, rate))
    }
}
