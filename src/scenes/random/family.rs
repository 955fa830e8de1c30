//! Families of random scenes: ordinary ones, and those that are extreme in one respect.

use std::fmt;

use nalgebra::Vector3;

use super::Units;
use super::bodies::{Drawn, Start};
use crate::model::body::Shape;
use crate::model::forces::draw::Draw;
use crate::rotation;

/// Distances from the origin of the world [m].
const FAR: (f64, f64) = (1e4, 1e9);
/// A speed of the centre of mass [m/s].
const FAST: f64 = 1e6;
/// Ratio of the largest moment of inertia to the smallest.
const THIN: (f64, f64) = (1e3, 1e6);
/// Spin beside the middle axis, over the spin about it.
const BESIDE: (f64, f64) = (1e-6, 1e-3);
/// A tumbling body turns so many times as far as another.
const LONGER: f64 = 8.0;
/// Mass [kg], length [m] and time [s] of a molecule …
const MOLECULE: Units = Units { mass: 1e-26, length: 1e-10, time: 1e-13 };
/// … and of a planet.
const PLANET: Units = Units { mass: 1e24, length: 1e7, time: 1e5 };

/// In what respect random scenes are extreme.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// In none.
    #[default]
    Ordinary,
    /// A free body 1e4 to 1e9 m from the origin of the world.
    Far,
    /// A free body whose centre of mass moves at 1e6 m/s.
    Fast,
    /// Moments of inertia 1e3 to 1e6 apart.
    Thin,
    /// A free body that turns near its middle axis and flips many times.
    Tumbling,
    /// The size of a molecule, SI units.
    Molecule,
    /// The size of a planet, SI units.
    Planet,
}

impl Family {
    /// The extreme ones.
    pub const EXTREME: [Family; 6] =
        [Family::Far, Family::Fast, Family::Thin, Family::Tumbling, Family::Molecule, Family::Planet];

    /// The units of a scene, from those of an ordinary one; powers of two stay such.
    pub(super) fn units(self, ordinary: Units) -> Units {
        let power = |unit: f64| unit.log2().round().exp2();
        let scaled = |by: Units| Units {
            mass: ordinary.mass * power(by.mass),
            length: ordinary.length * power(by.length),
            time: ordinary.time * power(by.time),
        };
        match self {
            Family::Molecule => scaled(MOLECULE),
            Family::Planet => scaled(PLANET),
            _ => ordinary,
        }
    }

    /// A body.
    pub(super) fn body(self, draw: &mut Draw) -> Drawn {
        loop {
            let body = match self {
                Family::Thin => Drawn::squeezed(draw, THIN),
                _ => Drawn::draw(draw),
            };
            let extended = body.body.shape == Shape::Extended;
            let fits = match self {
                Family::Far | Family::Fast => !body.body.pivoted,
                Family::Tumbling => !body.body.pivoted && extended,
                _ => true,
            };
            if fits {
                return body;
            }
        }
    }

    /// The start of a body, from that of an ordinary scene.
    pub(super) fn start(self, ordinary: Start, body: &Drawn, units: &Units, draw: &mut Draw) -> Start {
        match self {
            Family::Far => {
                let distance = draw.logarithmic(FAR.0, FAR.1) / units.length;
                Start { position: Some(draw.vector(distance)), ..ordinary }
            }
            Family::Fast => Start { velocity: Some(draw.vector(FAST / units.velocity())), ..ordinary },
            Family::Tumbling => {
                let moments = body.body.moments;
                let middle = 3 - moments.imin() - moments.imax();
                let axis = if moments.imin() == moments.imax() { 0 } else { middle };
                let rate = ordinary.rate.max(1.0);
                let beside = draw.logarithmic(BESIDE.0, BESIDE.1) * rate;
                let spin = body.body.principal * Vector3::ith(axis, rate) + draw.vector(beside);
                Start { spin: ordinary.orientation * spin, rate: rotation::length(&spin), ..ordinary }
            }
            _ => ordinary,
        }
    }

    /// How many times as far a body turns as in an ordinary scene.
    pub(super) fn longer(self) -> f64 {
        if self == Family::Tumbling { LONGER } else { 1.0 }
    }
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Family::Ordinary => "random",
            Family::Far => "random-far",
            Family::Fast => "random-fast",
            Family::Thin => "random-thin",
            Family::Tumbling => "random-tumbling",
            Family::Molecule => "random-molecule",
            Family::Planet => "random-planet",
        })
    }
}
