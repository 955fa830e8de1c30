//! The same scene in another world: turned, mirrored, shifted, boosted, or told in other units of mass, length and
//! time. No law of mechanics knows the difference, so no scheme may.
//!
//! With a rotation Q and units m, l, s, all but l positive:
//!
//! ```text
//! X' = l Q X + a + b t'        U' = (l/s) Q U + b        R' = Q R        x' = l x (body axes)
//! Ω' = Q Ω / s                 L' = (m l²/s) Q L         t' = s t
//! ```
//!
//! A negative l mirrors: points and polar vectors change sign, axial ones (Ω, L, τ, B) do not.

use nalgebra::Vector3;

use super::forces::{Argument, Dimension, Forces, Law, Nature};
use super::{Snapshot, System};
use crate::arithmetic::Real;
use crate::rotation::Rotation;

/// A change of world and units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<T: Real = f64> {
    /// Q.
    pub turn: Rotation<T>,
    /// a, in the new unit of length.
    pub shift: Vector3<T>,
    /// b, in the new unit of velocity.
    pub boost: Vector3<T>,
    /// m: how many new units of mass the old one is.
    pub mass: T,
    /// l, the same for length; negative mirrors.
    pub length: T,
    /// s, the same for time.
    pub time: T,
}

impl<T: Real> Change<T> {
    /// No change.
    pub fn none() -> Change<T> {
        Change {
            turn: Rotation::identity(),
            shift: Vector3::zeros(),
            boost: Vector3::zeros(),
            mass: T::one(),
            length: T::one(),
            time: T::one(),
        }
    }

    /// The scene in the new world.
    pub fn apply(&self, system: &System<T>) -> System<T> {
        let mut new = system.clone();
        let inertia = self.mass * self.length * self.length;
        new.body.mass *= self.mass;
        new.body.center *= self.length;
        new.body.inertia *= inertia;
        new.body.moments *= inertia;
        for point in &mut new.body.points {
            point.mass *= self.mass;
            point.position *= self.length;
        }
        let start = &mut new.start;
        start.position = self.turn * start.position * self.length + self.shift;
        start.velocity = self.turn * start.velocity * (self.length / self.time) + self.boost;
        start.orientation = self.turn * start.orientation;
        start.angular_momentum = self.turn * start.angular_momentum * (inertia / self.time);
        let laws = system.forces.laws().iter().map(|law| self.law(law)).collect();
        new.forces = Forces::new(laws, &new.body);
        new
    }

    /// A moment of a motion in the new world, told in the old one.
    pub fn undo(&self, new: &Snapshot<T>) -> Snapshot<T> {
        let back = self.turn.inverse();
        let time = new.time / self.time;
        let velocity = back * (new.velocity - self.boost) / (self.length / self.time);
        Snapshot {
            time,
            position: back * (new.position - self.shift - self.boost * new.time) / self.length,
            velocity,
            orientation: back * new.orientation,
            angular_velocity: back * new.angular_velocity * self.time,
            angular_momentum: back * new.angular_momentum
                / (self.mass * self.length * self.length / self.time),
            stretch: new.stretch,
        }
    }

    /// Whether a boosted world has the same laws: nothing in it stands still by itself.
    pub fn may_boost(system: &System<T>) -> bool {
        !system.body.pivoted && system.forces.laws().iter().all(Law::is_galilean)
    }

    /// A law in the new world.
    fn law(&self, law: &Law<T>) -> Law<T> {
        // A height goes along the direction that stands before it in the table.
        let mut normal = Vector3::zeros();
        law.map(|parameter, argument| {
            let new = self.argument(parameter.nature, law.in_body_axes(parameter), argument, &normal);
            if let (Nature::Direction, Argument::Vector(direction)) = (parameter.nature, &new) {
                normal = *direction;
            }
            new
        })
    }

    /// An argument of a law in the new world.
    fn argument(
        &self,
        nature: Nature,
        in_body_axes: bool,
        argument: Argument<T>,
        normal: &Vector3<T>,
    ) -> Argument<T> {
        let dimension = nature.dimension();
        let number = |x: T| match nature {
            Nature::Height => x * self.length.abs() + normal.dot(&self.shift),
            _ => self.scaled(x, self.length.abs(), dimension),
        };
        let scaled = |v: Vector3<T>| v.map(|x| self.scaled(x, self.length, dimension));
        let vector = |v: Vector3<T>| match nature {
            _ if in_body_axes => scaled(v),
            Nature::Place => self.turn * v * self.length + self.shift,
            Nature::Direction => self.turn * v * self.length.signum(),
            _ => scaled(self.turn * v),
        };
        argument.map(number, vector)
    }

    /// A number of this dimension in the new units.
    fn scaled(&self, x: T, length: T, dimension: Dimension) -> T {
        let [m, l, s] = dimension.powers();
        let time = self.time.powi(s);
        if m == 0 && l == 0 { x / time } else { x * (self.mass.powi(m) * length.powi(l) / time) }
    }
}
