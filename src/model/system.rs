//! A body, its forces and its start: what a scene says, checked and ready to be stepped.

use nalgebra::Vector3;

use super::body::{Body, Shape};
use super::forces::{Attachment, Forces, Law, PerPoint, Spring, TorqueAxes};
use super::placed::Placed;
use super::{Falling, Forced, Free, PointCloud, Rotor, Snapshot};
use crate::rotation::{self, Rotation, formulas};

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
pub struct Start {
    /// X_cm [m].
    pub position: Vector3<f64>,
    /// Takes body axes to world axes.
    pub orientation: Rotation,
    /// U_cm [m/s]; ignored where there is a pivot.
    pub velocity: Vector3<f64>,
    /// L about the origin [kg m²/s].
    pub angular_momentum: Vector3<f64>,
}

/// A scene that contradicts itself.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// L of a rod has a part along it.
    #[error(
        "the body is a rod and the angular momentum has a part of {along:e} along it (|L| = {length:e}): no spin carries it; make it perpendicular to the rod"
    )]
    AlongRod {
        /// Part along the rod [kg m²/s].
        along: f64,
        /// |L| [kg m²/s].
        length: f64,
    },
    /// A torque about a rod.
    #[error(
        "the body is a rod and law '{law}' turns it about itself, which no spin can follow; write a torque in body \
         axes across the rod, a moment along it, or a spring that is fastened on its line"
    )]
    TorqueAlongRod {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
    },
    /// L of a single point.
    #[error(
        "the body is a single point and cannot carry an angular momentum of {length:e} about itself; remove it"
    )]
    PointMomentum {
        /// |L| [kg m²/s].
        length: f64,
    },
    /// A law that acts on points on a body that has none.
    #[error("law '{law}' acts on mass points, and no positive masses have this body's inertia")]
    NoPoints {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
    },
    /// A list with a length other than the number of points.
    #[error("law '{law}' has {given} values for {points} mass points")]
    ListLength {
        /// Index of the law.
        index: usize,
        /// Name of the law.
        law: &'static str,
        /// Values given.
        given: usize,
        /// Mass points of the body.
        points: usize,
    },
    /// A point index out of range.
    #[error("point {point} does not exist: the body has {points} mass points, counted from 0")]
    PointIndex {
        /// Index of the law.
        index: usize,
        /// Index given.
        point: usize,
        /// Mass points of the body.
        points: usize,
    },
    /// The point form of a body that has none.
    #[error("no positive masses have this body's inertia: it has no point form; use --model least")]
    NoPointForm,
}

/// A body under forces, with its start.
#[derive(Clone, Debug)]
pub struct System {
    /// The body, about its origin.
    pub body: Body,
    /// The laws, bound to the body.
    pub forces: Forces,
    /// State at t = 0.
    pub start: Start,
}

/// Any of the models.
#[derive(Clone, Debug)]
pub enum AnyModel {
    /// Neither force nor torque.
    Free(Free),
    /// Uniform gravity only.
    Falling(Falling),
    /// Torques without force.
    Torque(Rotor),
    /// A point fixed in the world.
    Pivot(Rotor),
    /// Forces on points.
    Forced(Forced),
    /// The note as written.
    Points(PointCloud),
}

impl AnyModel {
    /// Name as in records.
    pub fn name(&self) -> &'static str {
        match self {
            AnyModel::Free(_) => "free",
            AnyModel::Falling(_) => "falling",
            AnyModel::Torque(_) => "torque",
            AnyModel::Pivot(_) => "pivot",
            AnyModel::Forced(_) => "forced",
            AnyModel::Points(_) => "points",
        }
    }
}

/// What every reduced model knows about rotation: the body in its principal axes.
#[derive(Clone, Debug)]
pub struct Rotational {
    /// Principal moments about the origin [kg m²].
    pub moments: Vector3<f64>,
    /// 1/moment about each principal axis [1/(kg m²)]; 0 where the body cannot spin.
    pub inverse_moments: Vector3<f64>,
    /// Takes principal axes to world axes at t = 0.
    pub attitude: Rotation,
    /// Takes body axes to principal axes.
    body_to_principal: Rotation,
}

impl Rotational {
    /// Ω = R I⁻¹ Rᵀ L [rad/s], world.
    #[inline(always)]
    pub fn spin(&self, attitude: &Rotation, momentum: &Vector3<f64>) -> Vector3<f64> {
        let columns = formulas::outer_columns([attitude.w, attitude.i, attitude.j, attitude.k]);
        formulas::spin(&columns, self.inverse_moments.into(), (*momentum).into()).into()
    }

    /// The orientation of the body axes.
    pub fn orientation(&self, attitude: &Rotation) -> Rotation {
        attitude * self.body_to_principal
    }
}

/// Relative difference from which on two moments are two.
const TWO_MOMENTS: f64 = 1e-9;
/// Part along a rod, over the whole, that may still be rounding of what was given.
const ALONG_ROD: f64 = 1e-9;

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

    /// Position of the origin at t = 0 [m], world: the pivot, or the centre of mass.
    pub fn origin(&self) -> Vector3<f64> {
        self.start.position - self.start.orientation * self.body.center
    }

    /// The same system started a little off: turned by `turn` [rad], with changes of L [kg m²/s], position [m]
    /// and velocity [m/s]. A pivot stays where it is, and a rod gets no L along it.
    pub fn displaced(&self, turn: &Vector3<f64>, change: &Start) -> System {
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

    /// The same system started at a moment of a motion.
    pub fn started_at(&self, snapshot: &Snapshot) -> System {
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
        let constant =
            !self.body.pivoted && laws.iter().all(|law| law.is_torque() || matches!(law, Law::Gravity(_)));
        (constant, free_of_force)
    }

    /// Whether no torque acts about the centre of mass and nothing holds the body.
    pub fn torque_free(&self) -> bool {
        !self.body.pivoted && self.forces.laws().iter().all(|law| matches!(law, Law::Gravity(_)))
    }

    /// Whether Ω is constant to rounding: no torque, and Ω along L about an axis where it stays.
    pub fn steady_spin(&self) -> bool {
        let attitude = self.start.orientation;
        let momentum = attitude.inverse_transform_vector(&self.start.angular_momentum);
        let spin = self.body.inverse_inertia() * momentum;
        let across = rotation::length(&spin.cross(&momentum));
        // I⁻¹ of an extended body is good to a few rounding units times its condition.
        let condition = match self.body.shape {
            Shape::Extended => self.body.moments.max() / self.body.moments.min(),
            Shape::Point | Shape::Rod { .. } => 1.0,
        };
        let rounding = 16.0 * f64::EPSILON * condition.min(1e3);
        let along = across <= rounding * rotation::length(&spin) * rotation::length(&momentum);
        self.torque_free() && along && !self.about_the_middle_axis(&spin, &momentum)
    }

    /// Whether a spin is about the axis of a moment that lies between two others: what rounding leaves beside it grows.
    fn about_the_middle_axis(&self, spin: &Vector3<f64>, momentum: &Vector3<f64>) -> bool {
        let moments = self.body.moments;
        let moment = rotation::length(momentum) / rotation::length(spin);
        self.body.shape == Shape::Extended
            && moment > moments.min() * (1.0 + TWO_MOMENTS)
            && moment < moments.max() * (1.0 - TWO_MOMENTS)
    }

    /// The least model that determines the motion.
    pub fn least(&self) -> AnyModel {
        let (rotational, start, forces) = (self.rotational(), self.start, self.forces.clone());
        let laws = self.forces.laws();
        if self.body.pivoted {
            let center = self.body.principal.inverse() * self.body.center;
            return AnyModel::Pivot(Rotor { rotational, start, forces, pivot: Some(self.origin()), center });
        }
        if laws.is_empty() {
            return AnyModel::Free(Free { rotational, start });
        }
        if laws.iter().all(|law| matches!(law, Law::Gravity(_))) {
            let acceleration = laws
                .iter()
                .filter_map(
                    |law| if let Law::Gravity(gravity) = law { Some(gravity.acceleration) } else { None },
                )
                .sum();
            let inverse_mass = 1.0 / self.body.mass;
            return AnyModel::Falling(Falling { rotational, start, acceleration, forces, inverse_mass });
        }
        if laws.iter().all(Law::is_torque) {
            let center = Vector3::zeros();
            return AnyModel::Torque(Rotor { rotational, start, forces, pivot: None, center });
        }
        AnyModel::Forced(Forced { rotational, start, forces, inverse_mass: 1.0 / self.body.mass })
    }

    /// The note as written, on every mass point.
    ///
    /// # Errors
    /// [`SystemError::NoPointForm`].
    pub fn points(&self) -> Result<AnyModel, SystemError> {
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
    pub fn rotational_energy(&self, snapshot: &Snapshot) -> f64 {
        0.5 * snapshot.angular_velocity.dot(&snapshot.angular_momentum)
    }

    /// Kinetic energy [J].
    pub fn kinetic_energy(&self, snapshot: &Snapshot) -> f64 {
        let translation =
            if self.body.pivoted { 0.0 } else { 0.5 * self.body.mass * snapshot.velocity.norm_squared() };
        translation + self.rotational_energy(snapshot)
    }

    /// Potential energy [J]; `None` where a law has none.
    pub fn potential_energy(&self, snapshot: &Snapshot) -> Option<f64> {
        let mut placed = Placed::new(self);
        placed.turn(self, &snapshot.orientation);
        let origin = snapshot.position - placed.center();
        self.forces.potential(&placed.cloud(origin, snapshot.velocity, snapshot.angular_velocity))
    }

    fn rotational(&self) -> Rotational {
        let body_to_principal = self.body.principal.inverse();
        Rotational {
            moments: self.body.moments,
            inverse_moments: self.body.inverse_moments(),
            attitude: self.start.orientation * self.body.principal,
            body_to_principal,
        }
    }
}

fn check_momentum(body: &Body, orientation: &Rotation, momentum: &Vector3<f64>) -> Result<(), SystemError> {
    let length = rotation::length(momentum);
    match body.shape {
        Shape::Point if length != 0.0 => Err(SystemError::PointMomentum { length }),
        Shape::Rod { direction } => {
            let along = (orientation * direction).dot(momentum);
            if along.abs() > ALONG_ROD * length {
                Err(SystemError::AlongRod { along, length })
            } else {
                Ok(())
            }
        }
        _ => Ok(()),
    }
}

fn check_law(index: usize, law: &Law, body: &Body) -> Result<(), SystemError> {
    let points = body.points.len();
    if let Shape::Rod { direction } = body.shape
        && turns_about(law, &direction, body.extent())
    {
        return Err(SystemError::TorqueAlongRod { index, law: law.name() });
    }
    if law.needs_points() && points == 0 {
        return Err(SystemError::NoPoints { index, law: law.name() });
    }
    let list = match law {
        Law::Drag(drag) => Some(&drag.coefficient),
        Law::Lorentz(lorentz) => Some(&lorentz.charge),
        _ => None,
    };
    if let Some(PerPoint::Each(values)) = list
        && values.len() != points
    {
        return Err(SystemError::ListLength { index, law: law.name(), given: values.len(), points });
    }
    if let Law::Spring(spring) = law
        && let Attachment::Point(point) = spring.attachment
        && point >= points
    {
        return Err(SystemError::PointIndex { index, point, points });
    }
    Ok(())
}

/// Whether a law has a torque about a rod: one that is fixed in the world while the rod turns, one with a part along
/// the rod, that of a moment with a part across it, or a spring fastened off its line. Forces on points and
/// gravity-gradient torques have none.
fn turns_about(law: &Law, direction: &Vector3<f64>, extent: f64) -> bool {
    match law {
        Law::Torque(torque) => [torque.constant, torque.cosine, torque.sine].iter().any(|amplitude| {
            let along = amplitude.dot(direction).abs() > ALONG_ROD * rotation::length(amplitude);
            along || (torque.axes == TorqueAxes::World && amplitude.amax() > 0.0)
        }),
        Law::Dipole(dipole) => {
            let across = rotation::length(&dipole.moment.cross(direction));
            across > ALONG_ROD * rotation::length(&dipole.moment)
        }
        Law::Spring(Spring { attachment: Attachment::At(place), .. }) => {
            let off = rotation::length(&place.cross(direction));
            off > ALONG_ROD * rotation::length(place).max(extent)
        }
        _ => false,
    }
}
