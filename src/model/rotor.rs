//! A body that turns under torques about a point whose motion is known: a pivot fixed in the world, or the
//! centre of mass of a body that no force pushes. It keeps orientation and L about that point.

use std::ops::{Add, Mul};

use nalgebra::{Matrix3, Vector3};

use super::forces::{Forces, Pose};
use super::system::{Rotational, Start};
use super::{Broken, Model, Motion, Rates, Snapshot, finite};
use crate::rotation::{self, Rotation};

/// Orientation and angular momentum.
#[derive(Clone, Debug)]
pub struct Rotor {
    pub(super) rotational: Rotational,
    pub(super) start: Start,
    pub(super) forces: Forces,
    /// Position of the pivot [m], world; `None` where the centre of mass moves straight.
    pub(super) pivot: Option<Vector3<f64>>,
    /// Centre of mass from the pivot [m], principal axes.
    pub(super) center: Vector3<f64>,
}

/// State of a rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotorState {
    pub(super) attitude: Rotation,
    pub(super) momentum: Vector3<f64>,
}

/// Rates of a rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotorRates {
    pub(super) spin: Vector3<f64>,
    pub(super) torque: Vector3<f64>,
}

impl Add for RotorRates {
    type Output = RotorRates;

    #[inline]
    fn add(self, other: RotorRates) -> RotorRates {
        RotorRates { spin: self.spin + other.spin, torque: self.torque + other.torque }
    }
}

impl Mul<f64> for RotorRates {
    type Output = RotorRates;

    #[inline]
    fn mul(self, factor: f64) -> RotorRates {
        RotorRates { spin: self.spin * factor, torque: self.torque * factor }
    }
}

impl Rates for RotorRates {
    #[inline]
    fn motion(self) -> Motion {
        Motion { spin: self.spin, torque: self.torque, ..Motion::default() }
    }

    #[inline]
    fn of(motion: Motion) -> RotorRates {
        RotorRates { spin: motion.spin, torque: motion.torque }
    }
}

impl Rotor {
    /// Ω and the matrix that takes principal axes to world axes.
    #[inline(always)]
    fn spin(&self, state: &RotorState) -> (Vector3<f64>, Matrix3<f64>) {
        (self.rotational.spin(&state.attitude, &state.momentum), rotation::axes(&state.attitude))
    }
}

impl Model for Rotor {
    type State = RotorState;
    type Rates = RotorRates;

    fn start(&self) -> RotorState {
        RotorState { attitude: self.rotational.attitude, momentum: self.start.angular_momentum }
    }

    #[inline(always)]
    fn rates(&self, t: f64, state: &RotorState) -> Result<RotorRates, Broken> {
        let (spin, axes) = self.spin(state);
        let (origin, velocity) = match self.pivot {
            Some(pivot) => (pivot, Vector3::zeros()),
            None => (self.start.position + self.start.velocity * t, self.start.velocity),
        };
        let load = self.forces.load(t, &Pose { axes, origin, velocity, spin });
        Ok(RotorRates { spin, torque: load.torque })
    }

    #[inline(always)]
    fn advance(&self, from: &RotorState, s: f64, rates: &RotorRates, into: &mut RotorState) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.momentum = from.momentum + rates.torque * s;
    }

    fn is_finite(&self, state: &RotorState) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite()) && finite(&[&state.momentum])
    }

    fn observe(&self, t: f64, state: &RotorState) -> Result<Snapshot, Broken> {
        let (spin, axes) = self.spin(state);
        let (position, velocity) = match self.pivot {
            Some(pivot) => {
                let arm = axes * self.center;
                (pivot + arm, spin.cross(&arm))
            }
            None => (self.start.position + self.start.velocity * t, self.start.velocity),
        };
        Ok(Snapshot {
            time: t,
            position,
            velocity,
            orientation: self.rotational.orientation(&state.attitude),
            angular_velocity: spin,
            angular_momentum: state.momentum,
            stretch: (state.attitude.norm_squared() - 1.0).abs(),
        })
    }
}
