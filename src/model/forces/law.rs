//! What every law has to say, beside its table of parameters.

use std::fmt::Debug;

use nalgebra::Vector3;

use super::draw::{Draw, Surroundings};
use super::pose::{Cloud, Load, Pose};
use crate::arithmetic::Real;
use crate::model::body::Body;

/// Part along a rod, over the whole, that may still be rounding of what was given.
pub(crate) const ALONG_ROD: f64 = 1e-9;

/// What a law acts on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Acts {
    /// On the mass, wherever it is: one force in the centre of mass.
    OnMass,
    /// On the mass, by where its centre is: one force in the centre of mass.
    OnCenter,
    /// On one place of the body.
    OnPlace,
    /// On every mass point, in a way that needs the points themselves.
    OnPoints,
    /// On the orientation: a torque without a force.
    AsTorque,
}

/// A force law. Nothing has a default, so that a law which forgets something does not compile.
pub(super) trait ForceLaw<T: Real>: Sized {
    /// Its name, as in a scene file.
    const NAME: &'static str;
    /// Its formula, in ASCII.
    const FORMULA: &'static str;
    /// Where the formula comes from.
    const SOURCE: &'static str;
    /// What it acts on.
    const ACTS: Acts;
    /// Whether the force has a kink: no scheme keeps its order across one.
    const HAS_KINK: bool;
    /// Whether a mass point and its two halves feel the same, each half with half of every value of the point.
    const SPLITS: bool;
    /// The law with its sums over the points taken, in principal axes.
    type Reduced: ReducedLaw<T>;

    /// Whether the force depends on a velocity.
    fn reads_velocity(&self) -> bool;

    /// How fast the law goes round by itself [rad/s]; 0 where it does not depend on time.
    fn clock(&self) -> T;

    /// Whether the law conserves the total energy.
    fn conserves(&self) -> bool;

    /// Whether the law may feed energy into a motion for as long as it lasts.
    fn drives(&self) -> bool;

    /// Whether the law is the same in a world that moves at a constant velocity.
    fn is_galilean(&self) -> bool;

    /// The acceleration that it gives to every mass alike, where it does so.
    fn uniform_acceleration(&self) -> Option<Vector3<T>>;

    /// Whether it has a torque about a rod in this direction [body axes] of this extent [m].
    fn turns_rod(&self, direction: &Vector3<T>, extent: T) -> bool;

    /// A parameter that contradicts the others, and what it should be.
    fn contradiction(&self) -> Option<(&'static str, &'static str)>;

    /// Takes the sums over the points.
    fn reduce(&self, body: &Body<T>) -> Self::Reduced;

    /// Adds force and torque as the note sums them, point by point. `marker` is the index of the law's own massless
    /// point, where it has one; the law counts it on.
    fn add_on_points(&self, t: T, cloud: &Cloud<T>, marker: &mut usize, load: &mut Load<T>);

    /// Potential energy [J]; `None` where the law has no potential. `marker` as above.
    fn potential(&self, cloud: &Cloud<T>, marker: &mut usize) -> Option<T>;
}

/// A law in its reduced form.
pub(super) trait ReducedLaw<T: Real>: Clone + Debug {
    /// Adds force and torque.
    fn add(&self, t: T, pose: &Pose<T>, load: &mut Load<T>);
}

/// A law that can be drawn by chance.
pub(super) trait RandomLaw: Sized {
    /// The law on a unit body, and the rate at which it changes a motion [rad/s]; `None` where the body does not feel it or
    /// chance decides against it. Directions have any length: a scene file may give them so.
    fn random(draw: &mut Draw, around: &Surroundings) -> Option<(Self, f64)>;
}

/// What is known of a law without an instance of it.
#[derive(Debug)]
pub struct Described {
    /// Its name, as in a scene file.
    pub name: &'static str,
    /// Its formula.
    pub formula: &'static str,
    /// Where the formula comes from.
    pub source: &'static str,
    /// Its parameters.
    pub parameters: &'static [super::Parameter],
    pub(super) random: fn(&mut Draw, &Surroundings) -> Option<(super::Law, f64)>,
}
