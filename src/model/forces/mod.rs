//! Force laws, each in two forms that must agree: as the note sums them, point by point, and reduced to what a
//! rigid body needs of them.
//!
//! Point form: F = Σ F_k and τ = Σ X̃_k × F_k over every mass point, U_k = U + Ω × X̃_k. It runs under
//! `--model points` and in the references. Reduced form: sums over the points are taken once, in principal
//! axes, before the run; only laws that are not polynomial in X̃_k still visit their points.

mod argument;
mod central_gravity;
mod dipole;
mod drag;
#[cfg(test)]
mod facts;
pub(crate) mod draw;
mod gravity;
mod gravity_gradient;
mod ground;
mod law;
mod lorentz;
mod mass_center_gravity;
mod orbiting_dipole;
mod parameter;
mod per_point;
mod pieces;
mod pose;
mod rotational_damping;
mod spring;
mod torque;
mod torque_pulse;
mod wheels;

pub use argument::{Argument, Kind};
pub use central_gravity::CentralGravity;
pub use dipole::Dipole;
pub use drag::Drag;
pub use gravity::Gravity;
pub use gravity_gradient::GravityGradient;
pub use ground::Ground;
pub use law::Described;
pub(crate) use law::{ALONG_ROD, Acts};
pub use lorentz::Lorentz;
pub use mass_center_gravity::MassCenterGravity;
pub use orbiting_dipole::OrbitingDipole;
pub use parameter::{Dimension, Nature, Parameter};
pub use per_point::PerPoint;
pub(crate) use pose::{Arms, Cloud, Load, Pose};
pub use rotational_damping::RotationalDamping;
pub use spring::{Attachment, Spring};
pub use torque::{Torque, TorqueAxes};
pub use torque_pulse::TorquePulse;
pub use wheels::Wheels;

use std::convert::Infallible;
use std::fmt;

use nalgebra::{Matrix3, Vector3};

use super::body::Body;
use crate::arithmetic::Real;
use draw::{Draw, Surroundings};
use law::{ForceLaw, RandomLaw, ReducedLaw};

/// Writes the list of laws, and for each what differs by nothing but its name.
macro_rules! laws {
    ($($(#[$doc:meta])* $law:ident in $file:ident,)*) => {
        /// A force law as a scene states it.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Law<T: Real = f64> {
            $($(#[$doc])* $law($law<T>),)*
        }

        /// A law with its sums over the points taken, in principal axes.
        #[derive(Clone, Debug)]
        enum Reduced<T: Real = f64> {
            $($law($file::Reduced<T>),)*
        }

        impl Law {
            /// All laws, in the order of the list.
            pub const ALL: [Described; [$(stringify!($law)),*].len()] = [$(Described {
                name: <$law as ForceLaw<f64>>::NAME,
                formula: <$law as ForceLaw<f64>>::FORMULA,
                source: <$law as ForceLaw<f64>>::SOURCE,
                parameters: $law::<f64>::PARAMETERS,
                random: |draw, around| $law::random(draw, around).map(|(law, rate)| (Law::$law(law), rate)),
            },)*];

            /// Names of all laws, with the formula of each.
            pub const NAMES: [(&'static str, &'static str); [$(stringify!($law)),*].len()] =
                [$((<$law as ForceLaw<f64>>::NAME, <$law as ForceLaw<f64>>::FORMULA),)*];

            /// The law of this name with these arguments; `None` where no law has the name.
            pub(crate) fn build<E>(
                name: &str,
                argument: impl FnMut(&'static Parameter) -> Result<Argument, E>,
            ) -> Option<Result<Law, E>> {
                $(if name == <$law as ForceLaw<f64>>::NAME {
                    return Some($law::build(argument).map(Law::$law));
                })*
                None
            }
        }

        impl<T: Real> Law<T> {
            /// Its name, as in a scene file.
            pub fn name(&self) -> &'static str {
                match self { $(Law::$law(_) => <$law<T> as ForceLaw<T>>::NAME,)* }
            }

            /// What it acts on.
            pub(crate) fn acts(&self) -> Acts {
                match self { $(Law::$law(_) => <$law<T> as ForceLaw<T>>::ACTS,)* }
            }

            /// Whether the force has a kink.
            pub(crate) fn has_kink(&self) -> bool {
                match self { $(Law::$law(_) => <$law<T> as ForceLaw<T>>::HAS_KINK,)* }
            }

            /// Whether a mass point and its two halves feel the same, each half with half of every value of the point.
            pub(crate) fn splits(&self) -> bool {
                match self { $(Law::$law(_) => <$law<T> as ForceLaw<T>>::SPLITS,)* }
            }

            /// Its arguments, in the order of its table.
            pub fn arguments(&self) -> Vec<(&'static Parameter, Argument<T>)> {
                match self { $(Law::$law(law) => law.arguments(),)* }
            }

            /// The same law with its arguments changed.
            pub(crate) fn map<U: Real>(
                &self,
                change: impl FnMut(&'static Parameter, Argument<T>) -> Argument<U>,
            ) -> Law<U> {
                match self { $(Law::$law(law) => Law::$law(law.map(change)),)* }
            }

            /// How fast the law goes round by itself [rad/s]; 0 where it does not depend on time.
            pub(crate) fn clock(&self) -> T {
                match self { $(Law::$law(law) => law.clock(),)* }
            }

            /// Whether the law may feed energy into a motion for as long as it lasts.
            pub(crate) fn drives(&self) -> bool {
                match self { $(Law::$law(law) => law.drives(),)* }
            }

            /// Whether the law is the same in a world that moves at a constant velocity.
            pub(crate) fn is_galilean(&self) -> bool {
                match self { $(Law::$law(law) => law.is_galilean(),)* }
            }

            /// The acceleration that it gives to every mass alike [m/s²], where it does so.
            pub(crate) fn uniform_acceleration(&self) -> Option<Vector3<T>> {
                match self { $(Law::$law(law) => law.uniform_acceleration(),)* }
            }

            /// Whether it has a torque about a rod in this direction [body axes] of this extent [m].
            pub(crate) fn turns_rod(&self, direction: &Vector3<T>, extent: T) -> bool {
                match self { $(Law::$law(law) => law.turns_rod(direction, extent),)* }
            }

            /// A parameter that contradicts the others, and what it should be.
            pub(crate) fn contradiction(&self) -> Option<(&'static str, &'static str)> {
                match self { $(Law::$law(law) => law.contradiction(),)* }
            }

            fn reads_velocity(&self) -> bool {
                match self { $(Law::$law(law) => law.reads_velocity(),)* }
            }

            fn conserves(&self) -> bool {
                match self { $(Law::$law(law) => law.conserves(),)* }
            }

            fn reduce(&self, body: &Body<T>) -> Reduced<T> {
                match self { $(Law::$law(law) => Reduced::$law(law.reduce(body)),)* }
            }

            #[inline]
            fn add_on_points(&self, t: T, cloud: &Cloud<T>, marker: &mut usize, load: &mut Load<T>) {
                match self { $(Law::$law(law) => law.add_on_points(t, cloud, marker, load),)* }
            }

            fn potential(&self, cloud: &Cloud<T>, marker: &mut usize) -> Option<T> {
                match self { $(Law::$law(law) => law.potential(cloud, marker),)* }
            }
        }

        impl<T: Real> Reduced<T> {
            #[inline]
            fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>) {
                match self { $(Reduced::$law(law) => law.add(t, pose, load),)* }
            }
        }
    };
}

laws! {
    /// F_k = M_k g.
    Gravity in gravity,
    /// A spring with damper from a point of the body to an anchor.
    Spring in spring,
    /// F_k = −c_k U_k.
    Drag in drag,
    /// F_k = −μ M_k d/|d|³.
    CentralGravity in central_gravity,
    /// F_k = q_k (E(t) + U_k × B).
    Lorentz in lorentz,
    /// A torque that depends on time alone.
    Torque in torque,
    /// τ = m × B.
    Dipole in dipole,
    /// τ = 3 μ/r³ (r̂ × I r̂).
    GravityGradient in gravity_gradient,
    /// A one-sided elastic plane with friction.
    Ground in ground,
    /// τ = −C Ω.
    RotationalDamping in rotational_damping,
    /// τ = −Ω × R h.
    Wheels in wheels,
    /// τ = m × B(t).
    OrbitingDipole in orbiting_dipole,
    /// F = −μ M d/|d|³ on the centre of mass.
    MassCenterGravity in mass_center_gravity,
    /// A torque that acts for a time.
    TorquePulse in torque_pulse,
}

impl Described {
    /// An instance with the example of every parameter.
    ///
    /// # Panics
    /// The list has no law of this name, which cannot be.
    pub fn example(&self) -> Law {
        let Some(Ok(law)) = Law::build(self.name, |parameter| Ok::<_, Infallible>(parameter.example.clone()))
        else {
            panic!("no law {}", self.name)
        };
        law
    }

    /// An instance by chance, and the rate at which it changes a motion [rad/s].
    pub(crate) fn random(&self, draw: &mut Draw, around: &Surroundings) -> Option<(Law, f64)> {
        (self.random)(draw, around)
    }
}

impl<T: Real> Law<T> {
    /// The same law in this arithmetic.
    pub(crate) fn of(law: &Law) -> Law<T> {
        law.map(|_, argument| argument.map(T::of, |vector| vector.map(T::of)))
    }

    /// Whether the law is a torque without a force.
    pub fn is_torque(&self) -> bool {
        self.acts() == Acts::AsTorque
    }

    /// Whether the law acts on every mass point in a way that needs the points themselves.
    pub fn needs_points(&self) -> bool {
        self.acts() == Acts::OnPoints
    }

    /// Whether the point form needs the direction of the body axes.
    pub fn needs_axes(&self) -> bool {
        let in_body_axes = |(parameter, argument): (&Parameter, Argument<T>)| {
            matches!(argument, Argument::Vector(_) | Argument::Matrix(_)) && self.in_body_axes(parameter)
        };
        self.arguments().into_iter().any(in_body_axes)
    }

    /// Whether a parameter is a vector in body axes.
    pub(crate) fn in_body_axes(&self, parameter: &Parameter) -> bool {
        let stated = || self.arguments().iter().any(|(_, a)| *a == Argument::Axes(TorqueAxes::Body));
        match parameter.nature {
            Nature::Body(_) => true,
            Nature::Stated(_) => stated(),
            _ => false,
        }
    }

    fn markers(&self) -> impl Iterator<Item = Vector3<T>> {
        self.arguments().into_iter().filter_map(|(_, argument)| match argument {
            Argument::Attachment(Attachment::At(position)) => Some(position),
            _ => None,
        })
    }
}

/// The laws of a scene, bound to its body.
#[derive(Clone, Default)]
pub struct Forces<T: Real = f64> {
    laws: Vec<Law<T>>,
    reduced: Vec<Reduced<T>>,
    markers: Vec<Vector3<T>>,
    /// The laws between their jumps, each with its end [s]; none where no law jumps.
    pieces: Vec<(T, Forces<T>)>,
}

/// Without the pieces, which follow from the laws: the fingerprint of a scene is made of this text.
impl<T: Real> fmt::Debug for Forces<T> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut shown = f.debug_struct("Forces");
        shown.field("laws", &self.laws).field("reduced", &self.reduced).field("markers", &self.markers);
        shown.finish()
    }
}

impl<T: Real> Forces<T> {
    /// Binds laws to a body. The caller has checked that indices and lists fit the body's points.
    pub fn new(laws: Vec<Law<T>>, body: &Body<T>) -> Forces<T> {
        let reduced = laws.iter().map(|law| law.reduce(body)).collect();
        let markers = laws.iter().flat_map(Law::markers).collect();
        let pieces = pieces::pieces(&laws, body);
        Forces { laws, reduced, markers, pieces }
    }

    /// The laws between their jumps, each with the time that it ends at [s], the last without an end; none where no law jumps.
    pub(crate) fn pieces(&self) -> &[(T, Forces<T>)] {
        &self.pieces
    }

    /// The laws as stated.
    pub fn laws(&self) -> &[Law<T>] {
        &self.laws
    }

    /// Massless points that carry a force [m], body axes, relative to the origin, in the order of their springs.
    pub fn markers(&self) -> &[Vector3<T>] {
        &self.markers
    }

    /// Force and torque in the reduced form.
    #[inline]
    pub fn load(&self, t: T, pose: &Pose<T>) -> Load<T> {
        if self.reduced.is_empty() { Load::default() } else { self.sum(t, pose) }
    }

    fn sum(&self, t: T, pose: &Pose<T>) -> Load<T> {
        let mut load = Load::default();
        for law in &self.reduced {
            law.add(t, pose, &mut load);
        }
        load
    }

    /// Force and torque summed over the points, as the note writes them.
    pub fn load_on_points(&self, t: T, cloud: &Cloud<T>) -> Load<T> {
        let mut load = Load::default();
        let mut marker = cloud.masses.len();
        for law in &self.laws {
            law.add_on_points(t, cloud, &mut marker, &mut load);
        }
        load
    }

    /// Potential energy [J]; `None` where a law has no potential.
    pub fn potential(&self, cloud: &Cloud<T>) -> Option<T> {
        let mut marker = cloud.masses.len();
        self.laws.iter().try_fold(T::zero(), |total, law| Some(total + law.potential(cloud, &mut marker)?))
    }

    /// Whether a force depends on a velocity.
    pub fn read_velocity(&self) -> bool {
        self.laws.iter().any(Law::reads_velocity)
    }

    /// Whether a law depends on time by itself.
    pub fn read_time(&self) -> bool {
        self.laws.iter().any(|law| law.clock() != 0.0)
    }

    /// The fastest that a law goes round by itself [rad/s]; 0 where none reads the time.
    pub fn fastest_clock(&self) -> T {
        self.laws.iter().map(|law| law.clock().abs()).fold(T::zero(), T::max)
    }

    /// Whether every law conserves the total energy.
    pub fn conservative(&self) -> bool {
        self.laws.iter().all(Law::conserves)
    }
}

/// A vector in body axes, taken to principal axes.
fn to_principal<T: Real>(body: &Body<T>, vector: &Vector3<T>) -> Vector3<T> {
    body.principal.inverse() * vector
}

/// A symmetric tensor in body axes, taken to principal axes.
fn tensor_to_principal<T: Real>(body: &Body<T>, tensor: &Matrix3<T>) -> Matrix3<T> {
    let axes = body.principal.to_rotation_matrix().into_inner();
    axes.transpose() * tensor * axes
}
