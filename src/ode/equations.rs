//! The Euler equations in body axes with a quaternion, as one ordinary differential equation of dimension 13.
//!
//! ```text
//! (1) X' = U
//! (2) U' = F / M
//! (3) q' = ½ q ⊗ (0, ω)
//! (4) I ω' = τ − ω × I ω
//! ```
//!
//! X, U: origin of the body, world axes; q takes body axes to world axes; I, ω, τ: about the origin, body axes.
//! With a pivot the origin is fixed, X' = U' = 0. Source: Euler 1765; any text on mechanics.
//!
//! Nothing here is shared with the schemes but the point form of the force laws: I is the full matrix in the
//! given body axes, ω is integrated instead of L, and orientation has no exponential map. I⁻¹ is the cofactor
//! inverse; for a rod along d it is (E − d dᵀ)/s with s = tr I / 2, for a point it is 0.
//!
//! The state is scaled to numbers near one by [`Units`], so that one tolerance serves every component. Times
//! are counted from a clock that stands at the start of each stretch between two outputs: a solver's rounding
//! of its own time then never grows with t.

use std::cell::{Cell, RefCell};

use nalgebra::{Matrix3, Quaternion, Vector3};

use super::units::Units;
use crate::model::body::{Body, Shape};
use crate::model::{Placed, Snapshot, System};
use crate::rotation::{self, Rotation};

/// Number of equations: X 3, U 3, q 4, ω 3.
pub const DIMENSION: usize = 13;

/// X, U, q (w, x, y, z), ω in the units of the scene.
pub type State = [f64; DIMENSION];

/// The equations of one system, with buffers and a count of evaluations.
#[derive(Debug)]
pub struct Equations<'a> {
    system: &'a System,
    units: Units,
    /// Origin at t = 0 [m], world; X is counted from there.
    origin: Vector3<f64>,
    /// I over the inertia unit, body axes.
    inertia: Matrix3<f64>,
    /// I⁻¹ times the inertia unit, body axes.
    inverse: Matrix3<f64>,
    placed: RefCell<Placed>,
    clock: Cell<f64>,
    /// The piece between two jumps of the laws that holds; none where the time of an evaluation decides.
    piece: Cell<Option<usize>>,
    evaluations: Cell<usize>,
}

impl<'a> Equations<'a> {
    /// The equations of `system` for a run of `duration` [s].
    pub fn new(system: &'a System, duration: f64) -> Equations<'a> {
        let units = Units::of(system, duration);
        let inertia = system.body.inertia / units.inertia;
        Equations {
            system,
            units,
            origin: system.origin(),
            inertia,
            inverse: inverse(&system.body, &inertia),
            placed: RefCell::new(Placed::new(system)),
            clock: Cell::new(0.0),
            piece: Cell::new(None),
            evaluations: Cell::new(0),
        }
    }

    /// Units of the state.
    pub fn units(&self) -> &Units {
        &self.units
    }

    /// Evaluations so far.
    pub fn evaluations(&self) -> usize {
        self.evaluations.get()
    }

    /// Puts the time that a solver calls 0 at `time` [s].
    pub fn set_clock(&self, time: f64) {
        self.clock.set(time);
    }

    /// The first time after this one [s] at which a law jumps. Until then the laws stay as they are just after this one.
    pub fn enter(&self, time: f64) -> Option<f64> {
        let pieces = self.system.forces.pieces();
        let place = pieces.iter().position(|(end, _)| time < *end)?;
        self.piece.set(Some(place));
        Some(pieces[place].0)
    }

    /// The state at t = 0.
    pub fn start(&self) -> State {
        let start = &self.system.start;
        let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        let spin = self.inverse * (momentum / self.units.inertia) / self.units.spin;
        let speed =
            if self.system.body.pivoted { Vector3::zeros() } else { start.velocity / self.units.speed };
        let q = start.orientation;
        [0.0, 0.0, 0.0, speed.x, speed.y, speed.z, q.w, q.i, q.j, q.k, spin.x, spin.y, spin.z]
    }

    /// Writes dy/ds at a solver's time `s`, both in units of the scene. Slices are [`DIMENSION`] long.
    pub fn rate(&self, s: f64, y: &[f64], into: &mut [f64]) {
        self.evaluations.set(self.evaluations.get() + 1);
        let units = &self.units;
        let q = Quaternion::new(y[6], y[7], y[8], y[9]);
        let spin = Vector3::new(y[10], y[11], y[12]) * units.spin;
        let (acceleration, torque) = self.load(s, y, &q, &spin);
        if self.system.body.pivoted {
            into[..6].fill(0.0);
        } else {
            let velocity = Vector3::new(y[3], y[4], y[5]) * (units.speed * units.time / units.length); // (1)
            into[..3].copy_from_slice(velocity.as_slice());
            into[3..6].copy_from_slice((acceleration * (units.time / units.speed)).as_slice()); // (2)
        }
        let turning = q * Quaternion::from_imag(spin * (0.5 * units.time)); // (3)
        into[6..10].copy_from_slice(&[turning.w, turning.i, turning.j, turning.k]);
        let turn = self.inverse * (torque - spin.cross(&(self.inertia * spin))); // (4)
        into[10..13].copy_from_slice((turn * (units.time / units.spin)).as_slice());
    }

    /// F/M [m/s²], world axes, and τ over the inertia unit [1/s²], body axes.
    fn load(
        &self,
        s: f64,
        y: &[f64],
        q: &Quaternion<f64>,
        spin: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        if self.system.forces.laws().is_empty() {
            return (Vector3::zeros(), Vector3::zeros());
        }
        let units = &self.units;
        let orientation = Rotation::new_normalize(*q);
        let position = self.origin + Vector3::new(y[0], y[1], y[2]) * units.length;
        let velocity = Vector3::new(y[3], y[4], y[5]) * units.speed;
        let mut placed = self.placed.borrow_mut();
        placed.turn(self.system, &orientation);
        let cloud = placed.cloud(position, velocity, orientation * spin);
        let forces = &self.system.forces;
        let piece = self.piece.get().and_then(|place| forces.pieces().get(place));
        let forces = piece.map_or(forces, |(_, forces)| forces);
        let load = forces.load_on_points(self.clock.get() + s * units.time, &cloud);
        let torque = orientation.inverse_transform_vector(&load.torque);
        (load.force / self.system.body.mass, torque / units.inertia)
    }

    /// The state as a snapshot at `time` [s]: the quaternion normalised, L = R I ω.
    pub fn observe(&self, time: f64, y: &State) -> Snapshot {
        let units = &self.units;
        let orientation = Rotation::new_normalize(Quaternion::new(y[6], y[7], y[8], y[9]));
        let spin = Vector3::new(y[10], y[11], y[12]) * units.spin;
        let angular_velocity = orientation * spin;
        let arm = orientation * self.system.body.center;
        let origin = self.origin + Vector3::new(y[0], y[1], y[2]) * units.length;
        let velocity = Vector3::new(y[3], y[4], y[5]) * units.speed;
        Snapshot {
            time,
            position: origin + arm,
            velocity: velocity + angular_velocity.cross(&arm),
            orientation,
            angular_velocity,
            angular_momentum: orientation * (self.inertia * spin * units.inertia),
            stretch: 0.0,
        }
    }
}

/// I⁻¹ without the principal axes of the schemes.
fn inverse(body: &Body, inertia: &Matrix3<f64>) -> Matrix3<f64> {
    match body.shape {
        Shape::Point => Matrix3::zeros(),
        Shape::Rod { direction } => {
            let along = direction / rotation::length(&direction);
            (Matrix3::identity() - along * along.transpose()) * (2.0 / inertia.trace())
        }
        Shape::Extended => inertia.try_inverse().unwrap_or_else(Matrix3::zeros),
    }
}
