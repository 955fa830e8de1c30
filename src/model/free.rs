//! A body under neither force nor torque: only its orientation has to be stepped. L and U_cm are constant and
//! X_cm moves along a straight line, exactly.

use nalgebra::{Quaternion, Vector3};

use super::forces::Forces;
use super::moving_axes::{Moving, Stand};
use super::rotor::Rotor;
use super::system::{Rotational, Start};
use super::{Broken, Model, Shortcut, Snapshot, rates};
use crate::arithmetic::{Real, series};
use crate::rotation::{self, Rotation};

/// Orientation alone.
#[derive(Clone, Debug)]
pub struct Free<T: Real = f64> {
    pub(super) rotational: Rotational<T>,
    pub(super) start: Start<T>,
}

/// State of a free body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeState<T: Real = f64> {
    /// Takes principal axes to world axes.
    pub(super) attitude: Rotation<T>,
    /// Rᵀ L [kg m²/s], principal axes, as the step before came to it faster than through the attitude.
    pub(super) ahead: Option<[T; 3]>,
}

impl<T: Real> FreeState<T> {
    /// At an attitude, which takes principal axes to world axes.
    #[inline(always)]
    pub(crate) fn at(attitude: Rotation<T>) -> FreeState<T> {
        FreeState { attitude, ahead: None }
    }
}

impl<T: Real> Free<T> {
    /// The body in moving axes at a step.
    #[inline(always)]
    pub(crate) fn moving(&self, step: T) -> Moving<T> {
        let (momentum, inverse) = (self.start.angular_momentum, self.rotational.inverse_moments);
        Moving::new(momentum.into(), step * 0.5, inverse.into())
    }

    /// Largest square of the turn of half a step [rad²] from which a step of Peskin's scheme stays within the series of small angles; `None`
    /// where the start is beyond.
    ///
    /// The second stage's Ω is larger by |L|/I times the first one's turn at most, I the least moment.
    pub(crate) fn turns_little(&self, step: T) -> Option<T> {
        let fastest = self.rotational.inverse_moments.amax() * rotation::length(&self.start.angular_momentum);
        let more = (fastest * step * 0.5).abs() + 1.0;
        let largest = T::of(series::SMALL_SQUARE) / (more * more);
        let body = self.moving(step);
        let q = self.rotational.attitude;
        let start = body.square_of_half(body.seen_from([q.w, q.i, q.j, q.k]));
        (start <= largest).then_some(largest)
    }

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
    type State = FreeState<T>;
    type Rates = FreeRates<T>;

    fn start(&self) -> FreeState<T> {
        FreeState::at(self.rotational.attitude)
    }

    #[inline(always)]
    fn rates(&self, _t: T, state: &FreeState<T>) -> Result<FreeRates<T>, Broken> {
        Ok(FreeRates { spin: self.rotational.spin(&state.attitude, &self.start.angular_momentum) })
    }

    #[inline(always)]
    fn advance(&self, from: &FreeState<T>, s: T, rates: &FreeRates<T>, into: &mut FreeState<T>) {
        *into = FreeState::at(rotation::turned(&from.attitude, &rates.spin, s));
    }

    // Called once for many steps, and compiled once for all schemes.
    #[inline(never)]
    fn shortcut(&self, of: Shortcut, step: T, steps: u64, state: &mut FreeState<T>) -> Option<u64> {
        // The series of small angles end where f64 does.
        if T::UNIT != f64::UNIT {
            return None;
        }
        let body = self.moving(step);
        let q = state.attitude;
        let attitude = [q.w, q.i, q.j, q.k];
        let momentum = state.ahead.unwrap_or_else(|| body.seen_from(attitude));
        let mut now = Stand { attitude, momentum };
        let mut taken = 0;
        match of {
            Shortcut::PeskinRk2 => {
                let largest = self.turns_little(step)?;
                while taken < steps && body.square_of_half(now.momentum) <= largest {
                    now = body.peskin_rk2(now);
                    taken += 1;
                }
            }
            Shortcut::Rk4Quaternion => {
                while taken < steps {
                    now = body.rk4_quaternion(now);
                    taken += 1;
                }
            }
        }
        let [w, x, y, z] = now.attitude;
        let attitude = Rotation::new_unchecked(Quaternion::new(w, x, y, z));
        *state = FreeState { attitude, ahead: Some(now.momentum) };
        Some(taken)
    }

    fn is_finite(&self, state: &FreeState<T>) -> bool {
        state.attitude.coords.iter().all(|x| x.is_finite())
    }

    fn observe(&self, t: T, FreeState { attitude, .. }: &FreeState<T>) -> Result<Snapshot<T>, Broken> {
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
