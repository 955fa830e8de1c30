//! A body under uniform gravity: the force acts in the centre of mass and does not depend on the motion, so
//! the translation goes by itself and the rotation is that of a free body.

use std::ops::{Add, Mul};

use nalgebra::Vector3;

use super::forced::Forced;
use super::forces::Forces;
use super::system::{Rotational, Start};
use super::{Broken, Model, Motion, Rates, Snapshot, finite};
use crate::rotation::{self, Rotation};

/// Orientation and translation.
#[derive(Clone, Debug)]
pub struct Falling {
    pub(super) rotational: Rotational,
    pub(super) start: Start,
    /// F/M [m/s²], world.
    pub(super) acceleration: Vector3<f64>,
    pub(super) forces: Forces,
    /// 1/M [1/kg].
    pub(super) inverse_mass: f64,
}

impl Falling {
    /// The same body with an L of its own in the state, for schemes that do not keep L by themselves.
    pub fn with_momentum(&self) -> Forced {
        Forced {
            rotational: self.rotational.clone(),
            start: self.start,
            forces: self.forces.clone(),
            inverse_mass: self.inverse_mass,
        }
    }
}

/// State of a falling body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallingState {
    pub(super) attitude: Rotation,
    pub(super) position: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
}

/// Rates of a falling body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallingRates {
    pub(super) spin: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) acceleration: Vector3<f64>,
}

impl Add for FallingRates {
    type Output = FallingRates;

    #[inline]
    fn add(self, other: FallingRates) -> FallingRates {
        FallingRates {
            spin: self.spin + other.spin,
            velocity: self.velocity + other.velocity,
            acceleration: self.acceleration + other.acceleration,
        }
    }
}

impl Mul<f64> for FallingRates {
    type Output = FallingRates;

    #[inline]
    fn mul(self, factor: f64) -> FallingRates {
        FallingRates {
            spin: self.spin * factor,
            velocity: self.velocity * factor,
            acceleration: self.acceleration * factor,
        }
    }
}

impl Rates for FallingRates {
    #[inline]
    fn motion(self) -> Motion {
        let FallingRates { spin, velocity, acceleration } = self;
        Motion { spin, velocity, acceleration, ..Motion::default() }
    }

    #[inline]
    fn of(motion: Motion) -> FallingRates {
        let Motion { spin, velocity, acceleration, .. } = motion;
        FallingRates { spin, velocity, acceleration }
    }
}

impl Model for Falling {
    type State = FallingState;
    type Rates = FallingRates;

    fn start(&self) -> FallingState {
        FallingState {
            attitude: self.rotational.attitude,
            position: self.start.position,
            velocity: self.start.velocity,
        }
    }

    #[inline(always)]
    fn rates(&self, _t: f64, state: &FallingState) -> Result<FallingRates, Broken> {
        let spin = self.rotational.spin(&state.attitude, &self.start.angular_momentum);
        Ok(FallingRates { spin, velocity: state.velocity, acceleration: self.acceleration })
    }

    #[inline(always)]
    fn advance(&self, from: &FallingState, s: f64, rates: &FallingRates, into: &mut FallingState) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.position = from.position + rates.velocity * s;
        into.velocity = from.velocity + rates.acceleration * s;
    }

    fn is_finite(&self, state: &FallingState) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite()) && finite(&[&state.position, &state.velocity])
    }

    fn observe(&self, t: f64, state: &FallingState) -> Result<Snapshot, Broken> {
        Ok(Snapshot {
            time: t,
            position: state.position,
            velocity: state.velocity,
            orientation: self.rotational.orientation(&state.attitude),
            angular_velocity: self.rotational.spin(&state.attitude, &self.start.angular_momentum),
            angular_momentum: self.start.angular_momentum,
            stretch: (state.attitude.norm_squared() - 1.0).abs(),
        })
    }
}
