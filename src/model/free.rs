//! A body under neither force nor torque: only its orientation has to be stepped. L and U_cm are constant and
//! X_cm moves along a straight line, exactly.

use nalgebra::Vector3;

use super::forces::Forces;
use super::rotor::Rotor;
use super::system::{Rotational, Start};
use super::{Broken, Model, Snapshot, rates};
use crate::arithmetic::Real;
use crate::rotation::{self, Rotation};

/// Orientation alone.
#[derive(Clone, Debug)]
pub struct Free<T: Real = f64> {
    pub(super) rotational: Rotational<T>,
    pub(super) start: Start<T>,
}

impl<T: Real> Free<T> {
    /// The same body with an L of its own in the state, for schemes that do not keep L by themselves.
    pub fn with_momentum(&self) -> Rotor<T> {
        Rotor {
            rotational: self.rotational.clone(),
            start: self.start,
            forces: Forces::default(),
            pivot: None,
            center: Vector3::zeros(),
        }
    }
}

rates! {
    /// Rates of a free body.
    FreeRates {
        /// Ω [rad/s], world.
        spin
    }
}

impl<T: Real> Model for Free<T> {
    type Real = T;
    /// Takes principal axes to world axes.
    type State = Rotation<T>;
    type Rates = FreeRates<T>;

    fn start(&self) -> Rotation<T> {
        self.rotational.attitude
    }

    #[inline(always)]
    fn rates(&self, _t: T, attitude: &Rotation<T>) -> Result<FreeRates<T>, Broken> {
        Ok(FreeRates { spin: self.rotational.spin(attitude, &self.start.angular_momentum) })
    }

    #[inline(always)]
    fn advance(&self, from: &Rotation<T>, s: T, rates: &FreeRates<T>, into: &mut Rotation<T>) {
        *into = rotation::turned(from, &rates.spin, s);
    }

    fn is_finite(&self, attitude: &Rotation<T>) -> bool {
        attitude.coords.iter().all(|x| x.is_finite())
    }

    fn observe(&self, t: T, attitude: &Rotation<T>) -> Result<Snapshot<T>, Broken> {
        Ok(Snapshot {
            time: t,
            position: self.start.position + self.start.velocity * t,
            velocity: self.start.velocity,
            orientation: self.rotational.orientation(attitude),
            angular_velocity: self.rotational.spin(attitude, &self.start.angular_momentum),
            angular_momentum: self.start.angular_momentum,
            stretch: (attitude.norm_squared() - 1.0).abs(),
        })
    }
}
