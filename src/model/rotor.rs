//! A body that turns under torques about a point whose motion is known: a pivot fixed in the world, or the
//! centre of mass of a body that no force pushes. It keeps orientation and L about that point.

use nalgebra::{Matrix3, Vector3};

use super::forces::{Forces, Pose};
use super::system::{Rotational, Start};
use super::{Broken, Model, Snapshot, finite, rates};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Orientation and angular momentum.
#[derive(Clone, Debug)]
pub struct Rotor<T: Real = f64> {
    pub(super) rotational: Rotational<T>,
    pub(super) start: Start<T>,
    pub(super) forces: Forces<T>,
    /// Position of the pivot [m], world; `None` where the centre of mass moves straight.
    pub(super) pivot: Option<Vector3<T>>,
    /// Centre of mass from the pivot [m], principal axes.
    pub(super) center: Vector3<T>,
}

/// State of a rotor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotorState<T: Real = f64> {
    pub(super) attitude: Rotation<T>,
    pub(super) momentum: Vector3<T>,
}

rates! {
    /// Rates of a rotor.
    RotorRates {
        spin,
        torque
    }
}

impl<T: Real> Rotor<T> {
    /// Ω and the matrix that takes principal axes to world axes.
    #[inline(always)]
    fn spin(&self, state: &RotorState<T>) -> (Vector3<T>, Matrix3<T>) {
        (self.rotational.spin(&state.attitude, &state.momentum), rotation::axes(&state.attitude))
    }
}

impl<T: Real> Model for Rotor<T> {
    type Real = T;
    type State = RotorState<T>;
    type Rates = RotorRates<T>;

    fn start(&self) -> RotorState<T> {
        RotorState { attitude: self.rotational.attitude, momentum: self.start.angular_momentum }
    }

    fn pieces(&self) -> Vec<(T, Rotor<T>)> {
        let in_piece =
            |(end, forces): &(T, Forces<T>)| (*end, Rotor { forces: forces.clone(), ..self.clone() });
        self.forces.pieces().iter().map(in_piece).collect()
    }

    #[inline(always)]
    fn rates(&self, t: T, state: &RotorState<T>) -> Result<RotorRates<T>, Broken> {
        let (spin, axes) = self.spin(state);
        let (origin, velocity) = match self.pivot {
            Some(pivot) => (pivot, rotation::zero()),
            None => (self.start.position + self.start.velocity * t, self.start.velocity),
        };
        let load = self.forces.load(t, &Pose { axes, origin, velocity, spin });
        Ok(RotorRates { spin, torque: load.torque })
    }

    #[inline(always)]
    fn advance(&self, from: &RotorState<T>, s: T, rates: &RotorRates<T>, into: &mut RotorState<T>) {
        into.attitude = rotation::turned(&from.attitude, &rates.spin, s);
        into.momentum = from.momentum + rates.torque * s;
    }

    fn is_finite(&self, state: &RotorState<T>) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite()) && finite(&[&state.momentum])
    }

    fn observe(&self, t: T, state: &RotorState<T>) -> Result<Snapshot<T>, Broken> {
        let (spin, axes) = self.spin(state);
        let (position, velocity) = match self.pivot {
            Some(pivot) => {
                let arm = rotation::applied(&axes, &self.center);
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
