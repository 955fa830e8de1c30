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

use super::forces::{Attachment, Forces, Law, TorqueAxes};
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
        let moves = |law: &Law<T>| match law {
            Law::Gravity(_) | Law::Torque(_) | Law::Dipole(_) | Law::GravityGradient(_) => true,
            Law::Lorentz(lorentz) => lorentz.magnetic.amax() == 0.0,
            Law::Spring(_) | Law::Drag(_) | Law::CentralGravity(_) | Law::Ground(_) => false,
        };
        !system.body.pivoted && system.forces.laws().iter().all(moves)
    }

    /// A law in the new world.
    fn law(&self, law: &Law<T>) -> Law<T> {
        let acceleration = self.length / (self.time * self.time);
        let force = self.mass * acceleration;
        let torque = force * self.length;
        let stiffness = self.mass / (self.time * self.time);
        let damping = self.mass / self.time;
        let turned = |vector: &Vector3<T>, unit: T| self.turn * vector * unit;
        let mut law = law.clone();
        match &mut law {
            Law::Gravity(law) => law.acceleration = turned(&law.acceleration, acceleration),
            Law::Spring(law) => {
                law.anchor = turned(&law.anchor, self.length) + self.shift;
                law.stiffness *= stiffness;
                law.damping *= damping;
                law.rest_length *= self.length.abs();
                if let Attachment::At(position) = &mut law.attachment {
                    *position *= self.length;
                }
            }
            Law::Drag(law) => law.coefficient = law.coefficient.scaled(damping),
            Law::CentralGravity(law) => {
                law.mu *= self.length.abs().powi(3) / (self.time * self.time);
                law.center = turned(&law.center, self.length) + self.shift;
            }
            Law::Lorentz(law) => {
                for field in [&mut law.electric, &mut law.electric_cosine, &mut law.electric_sine] {
                    *field = turned(field, force);
                }
                law.frequency /= self.time;
                law.magnetic = turned(&law.magnetic, damping);
            }
            Law::Torque(law) => {
                for amplitude in [&mut law.constant, &mut law.cosine, &mut law.sine] {
                    *amplitude = match law.axes {
                        TorqueAxes::World => turned(amplitude, torque),
                        TorqueAxes::Body => *amplitude * torque,
                    };
                }
                law.frequency /= self.time;
            }
            Law::Dipole(law) => law.field = turned(&law.field, torque),
            Law::GravityGradient(law) => {
                law.mu_over_r3 /= self.time * self.time;
                law.direction = turned(&law.direction, T::one());
                law.normal = turned(&law.normal, T::one());
                law.rate /= self.time;
            }
            Law::Ground(law) => {
                law.normal = turned(&law.normal, self.length.signum());
                law.height = law.height * self.length.abs() + law.normal.dot(&self.shift);
                law.stiffness *= stiffness;
                law.damping *= damping;
                law.slip_velocity *= self.length.abs() / self.time;
            }
        }
        law
    }
}
