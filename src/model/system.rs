//! A body, its forces and its start: what a scene says, checked and ready to be stepped.

mod check;
mod error;
mod reduced;

use std::any::Any;

use nalgebra::Vector3;

use super::body::{Body, Shape, rotation_of};
use super::forces::{Forces, Law};
use super::placed::Placed;
use super::{Falling, Forced, Free, PointCloud, Rotor, Snapshot};
use crate::arithmetic::{DoubleDouble, Real};
use crate::rotation::{self, Rotation};
use check::{check_law, check_momentum};
pub use error::SystemError;
pub use reduced::{AnyModel, Carried, Rotational};

/// How the initial rotation is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spin {
    /// Ω [rad/s], world.
    Velocity(Vector3<f64>),
    /// L [kg m²/s], world, about the origin.
    Momentum(Vector3<f64>),
}

/// The state of the body at t = 0, world axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start<T: Real = f64> {
    /// X_cm [m].
    pub position: Vector3<T>,
    /// Takes body axes to world axes.
    pub orientation: Rotation<T>,
    /// U_cm [m/s]; ignored where there is a pivot.
    pub velocity: Vector3<T>,
    /// L about the origin [kg m²/s].
    pub angular_momentum: Vector3<T>,
}

/// A body under forces, with its start.
#[derive(Clone, Debug)]
pub struct System<T: Real = f64> {
    /// The body, about its origin.
    pub body: Body<T>,
    /// The laws, bound to the body.
    pub forces: Forces<T>,
    /// State at t = 0.
    pub start: Start<T>,
}

/// What is wrong with each of some laws on a body.
pub(crate) fn faults_of_laws(body: &Body, laws: &[Law]) -> Vec<SystemError> {
    laws.iter().enumerate().filter_map(|(index, law)| check_law(index, law, body).err()).collect()
}

/// Relative difference from which on two moments are two.
const TWO_MOMENTS: f64 = 1e-9;

impl System {
    /// Puts a body under laws from a start.
    ///
    /// # Errors
    /// [`SystemError`]: what the body cannot do.
    pub fn new(
        body: Body,
        laws: Vec<Law>,
        position: Vector3<f64>,
        orientation: Rotation,
        velocity: Vector3<f64>,
        spin: Spin,
    ) -> Result<System, SystemError> {
        for (index, law) in laws.iter().enumerate() {
            check_law(index, law, &body)?;
        }
        let angular_momentum = match spin {
            Spin::Momentum(momentum) => momentum,
            Spin::Velocity(velocity) => {
                orientation * (body.inertia * (orientation.inverse_transform_vector(&velocity)))
            }
        };
        check_momentum(&body, &orientation, &angular_momentum)?;
        let mut start = Start { position, orientation, velocity, angular_momentum };
        if body.pivoted {
            let spin = orientation
                * (body.inverse_inertia() * orientation.inverse_transform_vector(&angular_momentum));
            start.velocity = spin.cross(&(orientation * body.center));
        }
        let forces = Forces::new(laws, &body);
        Ok(System { body, forces, start })
    }
}

impl System {
    /// Whether Ω is constant to rounding of double-double. A spin that is steady in f64 alone has a part beside its axis, which large
    /// steps amplify.
    pub fn steady_spin(&self) -> bool {
        System::<DoubleDouble>::of(self).is_ok_and(|system| system.is_steady())
    }
}

impl<T: Real> System<T> {
    /// The same system in this arithmetic. Its f64 numbers are taken as exact, and what follows from them is computed anew; in f64
    /// it is the system as it is.
    ///
    /// # Errors
    /// [`SystemError::Range`].
    pub fn of(given: &System) -> Result<System<T>, SystemError> {
        if let Some(same) = (given as &dyn Any).downcast_ref::<System<T>>() {
            return Ok(same.clone());
        }
        let body = Body::<T>::of(&given.body);
        let origin = given.origin().map(T::of);
        let Start { position, orientation, velocity, angular_momentum } = &given.start;
        let mut start = Start {
            position: position.map(T::of),
            orientation: rotation_of(orientation),
            velocity: velocity.map(T::of),
            angular_momentum: angular_momentum.map(T::of),
        };
        if let Shape::Rod { direction } = body.shape {
            // The part along the rod that f64 leaves is no spin.
            let direction = start.orientation * direction;
            let momentum = start.angular_momentum;
            start.angular_momentum = momentum - direction * direction.dot(&momentum);
        }
        let laws = given.forces.laws().iter().map(Law::of).collect();
        let forces = Forces::new(laws, &body);
        let mut system = System { body, forces, start };
        system.hold(&origin);
        if !system.holds(given) {
            return Err(SystemError::Range { arithmetic: T::NAME });
        }
        Ok(system)
    }

    /// The same start with another body and laws; a pivot stays in its place.
    pub(crate) fn with_body(&self, body: Body<T>, laws: Vec<Law<T>>) -> System<T> {
        let forces = Forces::new(laws, &body);
        let mut system = System { body, forces, start: self.start };
        system.hold(&self.origin());
        system
    }

    /// Position and velocity of the centre of mass, where a pivot at this place has a say in them.
    fn hold(&mut self, pivot: &Vector3<T>) {
        if !self.body.pivoted {
            return;
        }
        let start = &mut self.start;
        let arm = start.orientation * self.body.center;
        let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        start.position = pivot + arm;
        start.velocity = (start.orientation * (self.body.inverse_inertia() * momentum)).cross(&arm);
    }

    /// Whether mass, moments and L are numbers of this arithmetic that are zero only where those of the f64 system are.
    fn holds(&self, given: &System) -> bool {
        fn sizes<T: Real>(system: &System<T>) -> [T; 5] {
            let [a, b, c] = system.body.inverse_moments().into();
            [a, b, c, system.body.mass, system.start.angular_momentum.amax()]
        }
        let kept = |(own, given): (T, f64)| own.is_finite() && (own != 0.0 || given == 0.0);
        sizes(self).into_iter().zip(sizes(given)).all(kept)
    }

    /// The same system started a little off: turned by `turn` [rad], with changes of L [kg m²/s], position [m]
    /// and velocity [m/s]. A pivot stays where it is, and a rod gets no L along it.
    pub fn displaced(&self, turn: &Vector3<T>, change: &Start<T>) -> System<T> {
        let mut system = self.clone();
        let start = &mut system.start;
        start.orientation = rotation::turn(turn) * start.orientation;
        match self.body.shape {
            Shape::Point => {}
            Shape::Rod { direction } => {
                let direction = start.orientation * direction;
                let momentum = start.angular_momentum + change.angular_momentum;
                start.angular_momentum = momentum - direction * direction.dot(&momentum);
            }
            Shape::Extended => start.angular_momentum += change.angular_momentum,
        }
        if self.body.pivoted {
            start.position = self.origin() + start.orientation * self.body.center;
        } else {
            start.position += change.position;
            start.velocity += change.velocity;
        }
        system
    }

    /// Position of the origin at t = 0 [m], world: the pivot, or the centre of mass.
    pub fn origin(&self) -> Vector3<T> {
        self.start.position - self.start.orientation * self.body.center
    }

    /// The same system started at a moment of a motion.
    pub fn started_at(&self, snapshot: &Snapshot<T>) -> System<T> {
        let mut system = self.clone();
        system.start = Start {
            position: snapshot.position,
            orientation: snapshot.orientation,
            velocity: snapshot.velocity,
            angular_momentum: snapshot.angular_momentum,
        };
        system
    }

    /// Whether the force on the centre of mass is constant, and whether it is zero.
    pub fn constant_force(&self) -> (bool, bool) {
        let laws = self.forces.laws();
        let free_of_force = !self.body.pivoted && laws.iter().all(Law::is_torque);
        let is_constant = |law: &Law<T>| law.is_torque() || law.uniform_acceleration().is_some();
        let constant = !self.body.pivoted && laws.iter().all(is_constant);
        (constant, free_of_force)
    }

    /// Whether Ω is constant to rounding of this arithmetic: no torque, and Ω along L about an axis where it stays.
    fn is_steady(&self) -> bool {
        let attitude = self.start.orientation;
        let momentum = attitude.inverse_transform_vector(&self.start.angular_momentum);
        let spin = self.body.inverse_inertia() * momentum;
        let across = rotation::length(&spin.cross(&momentum));
        // I⁻¹ of an extended body is good to a few rounding units times its condition.
        let condition = match self.body.shape {
            Shape::Extended => (self.body.moments.max() / self.body.moments.min()).to_f64(),
            Shape::Point | Shape::Rod { .. } => 1.0,
        };
        let rounding = 16.0 * T::UNIT * condition.min(1e3);
        let along = across <= rotation::length(&spin) * rotation::length(&momentum) * rounding;
        self.torque_free() && along && !self.about_the_middle_axis(&spin, &momentum)
    }

    /// Whether a spin is about the axis of a moment that lies between two others: what rounding leaves beside it grows.
    fn about_the_middle_axis(&self, spin: &Vector3<T>, momentum: &Vector3<T>) -> bool {
        let moments = self.body.moments;
        let moment = rotation::length(momentum) / rotation::length(spin);
        self.body.shape == Shape::Extended
            && moment > moments.min() * (1.0 + TWO_MOMENTS)
            && moment < moments.max() * (1.0 - TWO_MOMENTS)
    }

    /// Whether no torque acts about the centre of mass and nothing holds the body.
    pub fn torque_free(&self) -> bool {
        !self.body.pivoted && self.forces.laws().iter().all(|law| law.uniform_acceleration().is_some())
    }

    /// The least model that determines the motion.
    pub fn least(&self) -> AnyModel<T> {
        let (rotational, start, forces) = (self.rotational(), self.start, self.forces.clone());
        let laws = self.forces.laws();
        if self.body.pivoted {
            let center = self.body.principal.inverse() * self.body.center;
            return AnyModel::Pivot(Rotor { rotational, start, forces, pivot: Some(self.origin()), center });
        }
        if laws.is_empty() {
            return AnyModel::Free(Free { rotational, start });
        }
        if laws.iter().all(|law| law.uniform_acceleration().is_some()) {
            let acceleration = laws.iter().filter_map(Law::uniform_acceleration).sum();
            let inverse_mass = T::one() / self.body.mass;
            return AnyModel::Falling(Falling { rotational, start, acceleration, forces, inverse_mass });
        }
        if laws.iter().all(Law::is_torque) {
            let center = Vector3::zeros();
            return AnyModel::Torque(Rotor { rotational, start, forces, pivot: None, center });
        }
        AnyModel::Forced(Forced { rotational, start, forces, inverse_mass: T::one() / self.body.mass })
    }

    /// The note as written, on every mass point.
    ///
    /// # Errors
    /// [`SystemError::NoPointForm`].
    pub fn points(&self) -> Result<AnyModel<T>, SystemError> {
        if self.body.points.is_empty() {
            return Err(SystemError::NoPointForm);
        }
        let has_axes = self.forces.laws().iter().any(Law::needs_axes);
        let tips = if has_axes { vec![Vector3::x(), Vector3::y(), Vector3::z()] } else { Vec::new() };
        let arms: Vec<_> = self
            .body
            .points
            .iter()
            .map(|p| p.position)
            .chain(self.forces.markers().iter().copied())
            .chain(tips)
            .collect();
        Ok(AnyModel::Points(PointCloud::new(self, arms, has_axes)))
    }

    /// Rotational energy ½ Ω·L [J], about the origin.
    pub fn rotational_energy(&self, snapshot: &Snapshot<T>) -> T {
        snapshot.angular_velocity.dot(&snapshot.angular_momentum) * 0.5
    }

    /// Kinetic energy [J].
    pub fn kinetic_energy(&self, snapshot: &Snapshot<T>) -> T {
        let translation = if self.body.pivoted {
            T::zero()
        } else {
            self.body.mass * 0.5 * snapshot.velocity.norm_squared()
        };
        translation + self.rotational_energy(snapshot)
    }

    /// Potential energy [J]; `None` where a law has none.
    pub fn potential_energy(&self, snapshot: &Snapshot<T>) -> Option<T> {
        if self.forces.laws().is_empty() {
            return Some(T::zero());
        }
        let mut placed = Placed::new(self);
        placed.turn(self, &snapshot.orientation);
        let origin = snapshot.position - placed.center();
        self.forces.potential(&placed.cloud(origin, snapshot.velocity, snapshot.angular_velocity))
    }

    fn rotational(&self) -> Rotational<T> {
        let body_to_principal = self.body.principal.inverse();
        Rotational {
            moments: self.body.moments,
            inverse_moments: self.body.inverse_moments(),
            attitude: self.start.orientation * self.body.principal,
            carried: self
                .body
                .pivoted
                .then(|| Carried { mass: self.body.mass, center: body_to_principal * self.body.center }),
            body_to_principal,
        }
    }
}
