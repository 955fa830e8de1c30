//! A body under forces on its points: translation and rotation depend on each other, so everything is kept.

use std::ops::{Add, Mul};

use nalgebra::{Matrix3, Vector3};

use super::forces::{Forces, Pose};
use super::system::{Rotational, Start};
use super::{Broken, Model, Rates, Snapshot, finite};
use crate::rotation::{self, Rotation};

/// Orientation, translation and angular momentum.
#[derive(Clone, Debug)]
pub struct Forced {
    pub(super) rotational: Rotational,
    pub(super) start: Start,
    pub(super) forces: Forces,
    /// 1/M [1/kg].
    pub(super) inverse_mass: f64,
}

/// State of a forced body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForcedState {
    pub(super) attitude: Rotation,
    pub(super) position: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) momentum: Vector3<f64>,
}

/// Ω, U_cm, F/M and τ, world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Ω [rad/s].
    pub spin: Vector3<f64>,
    /// U_cm [m/s].
    pub velocity: Vector3<f64>,
    /// F/M [m/s²].
    pub acceleration: Vector3<f64>,
    /// τ [N m].
    pub torque: Vector3<f64>,
}

impl Add for Motion {
    type Output = Motion;

    #[inline]
    fn add(self, other: Motion) -> Motion {
        Motion {
            spin: self.spin + other.spin,
            velocity: self.velocity + other.velocity,
            acceleration: self.acceleration + other.acceleration,
            torque: self.torque + other.torque,
        }
    }
}

impl Mul<f64> for Motion {
    type Output = Motion;

    #[inline]
    fn mul(self, factor: f64) -> Motion {
        Motion {
            spin: self.spin * factor,
            velocity: self.velocity * factor,
            acceleration: self.acceleration * factor,
            torque: self.torque * factor,
        }
    }
}

impl Rates for Motion {
    #[inline]
    fn motion(self) -> Motion {
        self
    }

    #[inline]
    fn of(motion: Motion) -> Motion {
        motion
    }
}

impl Forced {
    /// Ω and the matrix that takes principal axes to world axes.
    #[inline(always)]
    fn spin(&self, state: &ForcedState) -> (Vector3<f64>, Matrix3<f64>) {
        (self.rotational.spin(&state.attitude, &state.momentum), rotation::axes(&state.attitude))
    }
}

impl Model for Forced {
    type State = ForcedState;
    type Rates = Motion;

    fn start(&self) -> ForcedState {
        ForcedState {
            attitude: self.rotational.attitude,
            position: self.start.position,
            velocity: self.start.velocity,
            momentum: self.start.angular_momentum,
        }
    }

    #[inline(always)]
    fn rates(&self, t: f64, state: &ForcedState) -> Result<Motion, Broken> {
        let (spin, axes) = self.spin(state);
        let pose = Pose { axes, origin: state.position, velocity: state.velocity, spin };
        let load = self.forces.load(t, &pose);
        Ok(Motion {
            spin,
            velocity: state.velocity,
            acceleration: load.force * self.inverse_mass,
            torque: load.torque,
        })
    }

    #[inline(always)]
    fn advance(&self, from: &ForcedState, s: f64, rates: &Motion, into: &mut ForcedState) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.position = from.position + rates.velocity * s;
        into.velocity = from.velocity + rates.acceleration * s;
        into.momentum = from.momentum + rates.torque * s;
    }

    fn is_finite(&self, state: &ForcedState) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite())
            && finite(&[&state.position, &state.velocity, &state.momentum])
    }

    fn observe(&self, t: f64, state: &ForcedState) -> Result<Snapshot, Broken> {
        let (spin, _) = self.spin(state);
        Ok(Snapshot {
            time: t,
            position: state.position,
            velocity: state.velocity,
            orientation: self.rotational.orientation(&state.attitude),
            angular_velocity: spin,
            angular_momentum: state.momentum,
            stretch: (state.attitude.norm_squared() - 1.0).abs(),
        })
    }
}
