//! A body under forces on its points: translation and rotation depend on each other, so everything is kept.

use nalgebra::{Matrix3, Vector3};

use super::forces::{Forces, Pose};
use super::system::{Rotational, Start};
use super::{Broken, Model, Snapshot, finite, rates};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Orientation, translation and angular momentum.
#[derive(Clone, Debug)]
pub struct Forced<T: Real = f64> {
    pub(super) rotational: Rotational<T>,
    pub(super) start: Start<T>,
    pub(super) forces: Forces<T>,
    /// 1/M [1/kg].
    pub(super) inverse_mass: T,
}

/// State of a forced body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForcedState<T: Real = f64> {
    pub(super) attitude: Rotation<T>,
    pub(super) position: Vector3<T>,
    pub(super) velocity: Vector3<T>,
    pub(super) momentum: Vector3<T>,
}

rates! {
    /// Ω, U_cm, F/M and τ, world.
    Motion {
        /// Ω [rad/s].
        spin,
        /// U_cm [m/s].
        velocity,
        /// F/M [m/s²].
        acceleration,
        /// τ [N m].
        torque
    }
}

impl<T: Real> Forced<T> {
    /// Ω and the matrix that takes principal axes to world axes.
    #[inline(always)]
    fn spin(&self, state: &ForcedState<T>) -> (Vector3<T>, Matrix3<T>) {
        (self.rotational.spin(&state.attitude, &state.momentum), rotation::axes(&state.attitude))
    }
}

impl<T: Real> Model for Forced<T> {
    type Real = T;
    type State = ForcedState<T>;
    type Rates = Motion<T>;

    fn start(&self) -> ForcedState<T> {
        ForcedState {
            attitude: self.rotational.attitude,
            position: self.start.position,
            velocity: self.start.velocity,
            momentum: self.start.angular_momentum,
        }
    }

    fn pieces(&self) -> Vec<(T, Forced<T>)> {
        let in_piece =
            |(end, forces): &(T, Forces<T>)| (*end, Forced { forces: forces.clone(), ..self.clone() });
        self.forces.pieces().iter().map(in_piece).collect()
    }

    #[inline(always)]
    fn rates(&self, t: T, state: &ForcedState<T>) -> Result<Motion<T>, Broken> {
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
    fn advance(&self, from: &ForcedState<T>, s: T, rates: &Motion<T>, into: &mut ForcedState<T>) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.position = from.position + rates.velocity * s;
        into.velocity = from.velocity + rates.acceleration * s;
        into.momentum = from.momentum + rates.torque * s;
    }

    fn is_finite(&self, state: &ForcedState<T>) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite())
            && finite(&[&state.position, &state.velocity, &state.momentum])
    }

    fn observe(&self, t: T, state: &ForcedState<T>) -> Result<Snapshot<T>, Broken> {
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
