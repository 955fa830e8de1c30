//! A body under uniform gravity: the force acts in the centre of mass and does not depend on the motion, so
//! the translation goes by itself and the rotation is that of a free body.

use nalgebra::Vector3;

use super::forced::Forced;
use super::forces::Forces;
use super::system::{Rotational, Start};
use super::{Broken, Model, Snapshot, finite, rates};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Orientation and translation.
#[derive(Clone, Debug)]
pub struct Falling<T: Real = f64> {
    pub(super) rotational: Rotational<T>,
    pub(super) start: Start<T>,
    /// F/M [m/s²], world.
    pub(super) acceleration: Vector3<T>,
    pub(super) forces: Forces<T>,
    /// 1/M [1/kg].
    pub(super) inverse_mass: T,
}

impl<T: Real> Falling<T> {
    /// The same body with an L of its own in the state, for schemes that do not keep L by themselves.
    pub fn with_momentum(&self) -> Forced<T> {
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
pub struct FallingState<T: Real = f64> {
    pub(super) attitude: Rotation<T>,
    pub(super) position: Vector3<T>,
    pub(super) velocity: Vector3<T>,
}

rates! {
    /// Rates of a falling body.
    FallingRates {
        spin,
        velocity,
        acceleration
    }
}

impl<T: Real> Model for Falling<T> {
    type Real = T;
    type State = FallingState<T>;
    type Rates = FallingRates<T>;

    fn start(&self) -> FallingState<T> {
        FallingState {
            attitude: self.rotational.attitude,
            position: self.start.position,
            velocity: self.start.velocity,
        }
    }

    #[inline(always)]
    fn rates(&self, _t: T, state: &FallingState<T>) -> Result<FallingRates<T>, Broken> {
        let spin = self.rotational.spin(&state.attitude, &self.start.angular_momentum);
        Ok(FallingRates { spin, velocity: state.velocity, acceleration: self.acceleration })
    }

    #[inline(always)]
    fn advance(&self, from: &FallingState<T>, s: T, rates: &FallingRates<T>, into: &mut FallingState<T>) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.position = from.position + rates.velocity * s;
        into.velocity = from.velocity + rates.acceleration * s;
    }

    fn is_finite(&self, state: &FallingState<T>) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite()) && finite(&[&state.position, &state.velocity])
    }

    fn observe(&self, t: T, state: &FallingState<T>) -> Result<Snapshot<T>, Broken> {
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
