//! A body under neither force nor torque: only its orientation has to be stepped. L and U_cm are constant and
//! X_cm moves along a straight line, exactly.

use nalgebra::Vector3;

use super::forces::Forces;
use super::rotor::Rotor;
use super::system::{Rotational, Start};
use super::{Broken, Model, Motion, Rates, Snapshot};
use crate::rotation::{self, Rotation};

/// Orientation alone.
#[derive(Clone, Debug)]
pub struct Free {
    pub(super) rotational: Rotational,
    pub(super) start: Start,
}

impl Free {
    /// The same body with an L of its own in the state, for schemes that do not keep L by themselves.
    pub fn with_momentum(&self) -> Rotor {
        Rotor {
            rotational: self.rotational.clone(),
            start: self.start,
            forces: Forces::default(),
            pivot: None,
            center: Vector3::zeros(),
        }
    }
}

impl Rates for Vector3<f64> {
    #[inline]
    fn motion(self) -> Motion {
        Motion { spin: self, ..Motion::default() }
    }

    #[inline]
    fn of(motion: Motion) -> Vector3<f64> {
        motion.spin
    }
}

impl Model for Free {
    /// Takes principal axes to world axes.
    type State = Rotation;
    /// Ω [rad/s], world.
    type Rates = Vector3<f64>;

    fn start(&self) -> Rotation {
        self.rotational.attitude
    }

    #[inline(always)]
    fn rates(&self, _t: f64, attitude: &Rotation) -> Result<Vector3<f64>, Broken> {
        Ok(self.rotational.spin(attitude, &self.start.angular_momentum))
    }

    #[inline(always)]
    fn advance(&self, from: &Rotation, s: f64, spin: &Vector3<f64>, into: &mut Rotation) {
        *into = rotation::turned(from, spin, s);
    }

    fn is_finite(&self, attitude: &Rotation) -> bool {
        attitude.coords.iter().all(|x| x.is_finite())
    }

    fn observe(&self, t: f64, attitude: &Rotation) -> Result<Snapshot, Broken> {
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
