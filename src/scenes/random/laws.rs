//! Force laws by chance: none to five of them, with rates of about one on a unit body.

use super::Units;
use crate::model::forces::draw::{Draw, Surroundings};
use crate::model::forces::{Acts, Dimension, Law};

impl Units {
    /// The unit of a dimension.
    fn unit(&self, dimension: Dimension) -> f64 {
        match dimension {
            Dimension::Pure => 1.0,
            Dimension::Length => self.length,
            Dimension::Time => self.time,
            Dimension::Frequency => 1.0 / self.time,
            Dimension::Velocity => self.velocity(),
            Dimension::Acceleration => self.acceleration(),
            Dimension::Force => self.force(),
            Dimension::Torque => self.force() * self.length,
            Dimension::AngularMomentum => self.inertia() / self.time,
            Dimension::Stiffness => self.force() / self.length,
            Dimension::Damping => self.mass / self.time,
            Dimension::Central => self.length * self.length * self.acceleration(),
            Dimension::Gradient => 1.0 / (self.time * self.time),
        }
    }
}

/// The laws of a scene, with their numbers for a unit body.
pub(super) struct Mix {
    laws: Vec<Law>,
    /// Sum of the rates at which they change a motion.
    pub rate: f64,
    /// Whether a force has a kink.
    pub kink: bool,
}

impl Mix {
    /// No law.
    pub fn none() -> Mix {
        Mix { laws: Vec::new(), rate: 0.0, kink: false }
    }

    pub fn names(&self) -> Vec<&'static str> {
        self.laws.iter().map(Law::name).collect()
    }

    pub fn text(&self, units: &Units) -> String {
        let mut text = String::new();
        for law in &self.laws {
            text += &format!("\n[[forces]]\nlaw = \"{}\"\n", law.name());
            for (parameter, argument) in law.arguments() {
                if parameter.default.as_ref() == Some(&argument) {
                    continue;
                }
                let unit = units.unit(parameter.nature.dimension());
                let value = argument.map(|x| x * unit, |v| v * unit);
                text += &format!("{} = {value}\n", parameter.key_of(&value));
            }
        }
        text
    }
}

/// Draws the laws of a scene.
pub(super) fn draw(draw: &mut Draw, around: &Surroundings) -> Mix {
    let count = match draw.unit() {
        x if x < 0.2 => 0,
        x if x < 0.5 => 1,
        x if x < 0.7 => 2,
        x if x < 0.85 => 3,
        x if x < 0.95 => 4,
        _ => 5,
    };
    let mut drawn: Vec<(Law, f64)> = Vec::new();
    while drawn.len() < count {
        let law = Law::ALL[draw.below(Law::ALL.len())].random(draw, around);
        // A law stands once, but a body may be held in several places.
        drawn.extend(law.filter(|(law, _)| {
            law.acts() == Acts::OnPlace || drawn.iter().all(|(other, _)| other.name() != law.name())
        }));
    }
    let rate = drawn.iter().map(|(_, rate)| rate).sum();
    let laws: Vec<Law> = drawn.into_iter().map(|(law, _)| law).collect();
    Mix { rate, kink: laws.iter().any(Law::has_kink), laws }
}
