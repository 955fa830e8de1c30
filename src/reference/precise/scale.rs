//! Units of mass, length and time in which a scene's numbers are near one.

use nalgebra::Matrix3;

use crate::model::System;
use crate::ode::units::Units;

/// All are powers of two: scaling by them does not round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// Mass [kg].
    pub mass: f64,
    /// Length [m].
    pub length: f64,
    /// Time [s].
    pub time: f64,
    /// Size of a velocity, in these units.
    pub speed: f64,
    /// Size of an angular momentum, in these units.
    pub momentum: f64,
}

impl Scale {
    pub(super) fn of(system: &System, duration: f64) -> Scale {
        let units = Units::of(system, duration);
        let mass = f64::from_bits(system.body.mass.to_bits() & f64::INFINITY.to_bits());
        let Units { length, time, .. } = units;
        let scale = Scale { mass, length, time, speed: 1.0, momentum: 1.0 };
        Scale {
            speed: scale.plain(units.speed, [0, 1, -1]),
            momentum: scale.plain(units.inertia, [1, 2, 0]) * scale.plain(units.spin, [0, 0, -1]),
            ..scale
        }
    }

    /// A value in SI units of dimension kgᵃ mᵇ sᶜ, in units of the scene.
    pub(super) fn plain(&self, value: f64, dimension: [i32; 3]) -> f64 {
        value / self.unit(dimension)
    }

    /// kgᵃ mᵇ sᶜ of the scene in SI units.
    pub(super) fn unit(&self, [mass, length, time]: [i32; 3]) -> f64 {
        self.mass.powi(mass) * self.length.powi(length) * self.time.powi(time)
    }

    pub(super) fn inertia(&self, inertia: &Matrix3<f64>) -> Matrix3<f64> {
        inertia.map(|x| self.plain(x, [1, 2, 0]))
    }
}
