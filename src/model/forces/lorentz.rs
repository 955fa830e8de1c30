//! The Lorentz force on charged points, F_k = q_k (E(t) + U_k × B).
//!
//! Reduced: with q = Σ q_k, s = Σ q_k x_k and Q = Σ q_k x_k x_kᵀ,
//!     F = q E + (q U + Ω × s) × B,   τ = s × (E + U × B) + Ω × Q B,
//! the last term from x × ((Ω × x) × B) = (Ω × x)(x·B).

use nalgebra::{Matrix3, Vector3};

use super::argument::{Argument, Field};
use super::draw::{Draw, Surroundings};
use super::law::{Acts, ForceLaw, RandomLaw, ReducedLaw};
use super::parameter::{Parameter, parameters};
use super::pose::{each_point, sum_points};
use super::{Cloud, Load, PerPoint, Pose, tensor_to_principal, to_principal};
use crate::arithmetic::Real;
use crate::model::body::Body;
use crate::rotation;

parameters! {
    /// F_k = q_k (E(t) + U_k × B), E(t) = electric + electric_cosine cos(ωt) + electric_sine sin(ωt).
    pub struct Lorentz {
        /// q_k
        charge: PerPoint<T> ["C"] = Number(Pure), REQUIRED, each(1.0);
        /// Constant part of E, world
        electric: Vector3<T> ["V/m"] = World(Force), ZEROS, vector(0.0, 0.0, 1.0);
        /// Amplitude of the cosine, world
        electric_cosine: Vector3<T> ["V/m"] = World(Force), ZEROS, vector(1.0, 0.0, 0.0);
        /// Amplitude of the sine, world
        electric_sine: Vector3<T> ["V/m"] = World(Force), ZEROS, vector(0.0, 1.0, 0.0);
        /// ω
        frequency: T ["rad/s"] = Number(Frequency), ZERO, number(2.0);
        /// B, world
        magnetic: Vector3<T> ["T"] = World(Damping), ZEROS, vector(0.0, 0.0, 1.0);
    }
}

#[derive(Clone, Debug)]
pub(super) struct Reduced<T: Real = f64> {
    law: Lorentz<T>,
    total: T,
    first: Vector3<T>,
    second: Matrix3<T>,
}

impl<T: Real> Lorentz<T> {
    #[inline]
    fn electric_at(&self, t: T) -> Vector3<T> {
        let (sine, cosine) = (self.frequency * t).sin_cos();
        self.electric + self.electric_cosine * cosine + self.electric_sine * sine
    }

    #[inline]
    fn force(&self, t: T, k: usize, velocity: &Vector3<T>) -> Vector3<T> {
        (self.electric_at(t) + velocity.cross(&self.magnetic)) * self.charge.at(k)
    }

    /// q, s and Q, in principal axes.
    pub(crate) fn sums(&self, body: &Body<T>) -> (T, Vector3<T>, Matrix3<T>) {
        let (mut total, mut first, mut second) = (T::zero(), Vector3::zeros(), Matrix3::zeros());
        for (k, point) in body.points.iter().enumerate() {
            let q = self.charge.at(k);
            total += q;
            first += point.position * q;
            second += point.position * point.position.transpose() * q;
        }
        (total, to_principal(body, &first), tensor_to_principal(body, &second))
    }

    /// Whether the electric field does not depend on time.
    pub fn is_static(&self) -> bool {
        self.frequency == 0.0 || (self.electric_cosine.amax() == 0.0 && self.electric_sine.amax() == 0.0)
    }
}

impl<T: Real> ForceLaw<T> for Lorentz<T> {
    const NAME: &'static str = "lorentz";
    const FORMULA: &'static str = "F_k = q_k (E(t) + U_k x B)";
    const SOURCE: &'static str = "the Lorentz force; Jackson, Classical Electrodynamics";
    const ACTS: Acts = Acts::OnPoints;
    const HAS_KINK: bool = false;
    const SPLITS: bool = true;
    type Reduced = Reduced<T>;

    fn reads_velocity(&self) -> bool {
        self.magnetic.amax() != 0.0
    }

    fn clock(&self) -> T {
        if self.is_static() { T::zero() } else { self.frequency }
    }

    fn conserves(&self) -> bool {
        self.is_static()
    }

    fn drives(&self) -> bool {
        true
    }

    fn is_galilean(&self) -> bool {
        self.magnetic.amax() == 0.0
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
        Reduced { law: self.clone(), total, first, second }
    }

    fn add_on_points(&self, t: T, cloud: &Cloud<T>, _marker: &mut usize, load: &mut Load<T>) {
        each_point(cloud, load, |k, _, u| self.force(t, k, u));
    }

    fn potential(&self, cloud: &Cloud<T>, _marker: &mut usize) -> Option<T> {
        let electric = self.electric_at(T::zero());
        let potential = |k: usize, x: &Vector3<T>| -self.charge.at(k) * electric.dot(x);
        self.is_static().then(|| sum_points(cloud, potential))
    }
}

impl<T: Real> ReducedLaw<T> for Reduced<T> {
    #[inline]
    fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
        let electric = self.law.electric_at(t);
        let magnetic = self.law.magnetic;
        let first = pose.in_world(&self.first);
        load.force +=
            electric * self.total + (pose.velocity * self.total + pose.spin.cross(&first)).cross(&magnetic);
        let second = pose.in_world(&rotation::applied(&self.second, &pose.axes.tr_mul(&magnetic)));
        load.torque += first.cross(&(electric + pose.velocity.cross(&magnetic))) + pose.spin.cross(&second);
    }
}

impl RandomLaw for Lorentz {
    /// Charges in proportion to nothing, of both signs.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)> {
        let charge = if draw.chance(0.3) {
            PerPoint::Same(draw.between(-1.0, 1.0))
        } else {
            PerPoint::Each(around.body.points.iter().map(|p| draw.between(-1.0, 1.0) * p.mass).collect())
        };
        let frequency = draw.logarithmic(0.3, 3.0);
        let [electric, electric_cosine, electric_sine] =
            [(); 3].map(|()| if draw.chance(0.5) { draw.vector(0.5) } else { Vector3::zeros() });
        let strength = if draw.chance(0.7) { draw.logarithmic(0.2, 2.0) } else { 0.0 };
        let magnetic = if strength > 0.0 { draw.vector(strength) } else { Vector3::zeros() };
        let law = Lorentz { charge, electric, electric_cosine, electric_sine, frequency, magnetic };
        Some((law, 0.5 + strength + frequency))
    }
}
