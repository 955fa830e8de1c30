//! The motion that runs are held against, at any time of the scene.

use nalgebra::Vector3;

use super::failure::Axis;
use super::theory;
use crate::measure::{FlipFinder, tumbling_axis};
use crate::model::body::Shape;
use crate::model::forces::Law;
use crate::model::{AnyModel, Snapshot, System};
use crate::ode::dop853;
use crate::reference::ReferenceError;
use crate::rotation::{self, Rotation};
use crate::scenes::Scene;

/// Fewest and most intervals of the truth.
const INTERVALS: (f64, f64) = (512.0, 16384.0);
/// Intervals a radian turned: between two of them the motion is a turn at a changing rate, good to 1e-3 rad.
const PER_RADIAN: f64 = 8.0;
/// Part of |L| along a principal axis from which a spin counts as settled on it.
pub(super) const SETTLED: f64 = 0.995;
/// Speed at the end over the largest, below which a motion has come to rest.
const AT_REST: f64 = 1e-2;

/// A motion at any time, with what runs are judged by.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The scene's body, forces and start.
    pub system: System,
    /// Duration [s].
    pub duration: f64,
    states: Vec<Snapshot>,
    energies: Vec<f64>,
    coupled: bool,
    /// What an energy error is counted in [J]: the largest kinetic energy or the span of the potential.
    pub scale: f64,
    /// Largest |Ω| [rad/s].
    pub fastest: f64,
    /// ω of the table: the fastest natural frequency, else the largest |Ω| [rad/s].
    pub omega: f64,
    /// Whether ω is a natural frequency.
    pub omega_is_natural: bool,
    /// Axis whose flips are watched, body axes.
    pub tumbling: Option<Vector3<f64>>,
    /// Flip times [s].
    pub flips: Vec<f64>,
    /// Axis that the spin ends on, if any.
    pub settled: Option<Axis>,
    /// Whether the motion has come to rest at the end.
    pub at_rest: bool,
    /// Whether a law puts energy in or has no potential, so that a run longer than the scene says nothing.
    pub driven: bool,
}

impl Truth {
    /// Solves the scene.
    ///
    /// # Errors
    /// The solver fails.
    pub fn of(scene: &Scene) -> Result<Truth, ReferenceError> {
        let system = scene.system.clone();
        let coarse = dop853::solve(&system, &even(scene.duration, 64), 1e-9)?;
        let fastest = largest_spin(&coarse.states);
        let natural = theory::natural_frequency(&system);
        let turned = scene.duration * fastest.max(natural.unwrap_or(0.0));
        let intervals = (turned * PER_RADIAN).clamp(INTERVALS.0, INTERVALS.1) as usize;
        let states = dop853::solve(&system, &even(scene.duration, intervals), 1e-12)?.states;
        Ok(Truth::from_states(system, scene.duration, states, natural))
    }

    fn from_states(system: System, duration: f64, states: Vec<Snapshot>, natural: Option<f64>) -> Truth {
        let coupled = !matches!(system.least(), AnyModel::Free(_) | AnyModel::Falling(_));
        let energies: Vec<f64> = states.iter().map(|state| energy(&system, coupled, state)).collect();
        let fastest = largest_spin(&states);
        let tumbling = tumbling_axis(&system);
        let flips = tumbling.map_or(Vec::new(), |axis| {
            let mut finder = FlipFinder::new(axis);
            states.iter().for_each(|state| finder.push(state));
            finder.times
        });
        let last_quarter = &states[states.len() * 3 / 4..];
        let speed =
            |state: &Snapshot| state.velocity.norm() + state.angular_velocity.norm() * system.body.extent();
        let largest = states.iter().map(speed).fold(0.0, f64::max);
        let at_rest = states.last().is_some_and(|last| speed(last) < AT_REST * largest);
        Truth {
            scale: scale(&system, coupled, &states, &energies),
            coupled,
            omega: natural.unwrap_or(fastest),
            omega_is_natural: natural.is_some(),
            settled: settled_axis(&system, last_quarter),
            driven: driven(&system, &states[0]),
            system,
            duration,
            energies,
            states,
            fastest,
            tumbling,
            flips,
            at_rest,
        }
    }

    /// Orientation and energy at a time of the scene.
    pub fn at(&self, time: f64) -> (Rotation, f64) {
        let last = self.states.len() - 1;
        let place = (time / self.duration * last as f64).clamp(0.0, last as f64);
        let index = (place.floor() as usize).min(last - 1);
        let part = place - index as f64;
        let (before, after) = (&self.states[index], &self.states[index + 1]);
        let gap = self.duration / last as f64;
        // The mean rate over the part: second order in the gap.
        let rate =
            before.angular_velocity + (after.angular_velocity - before.angular_velocity) * (0.5 * part);
        let orientation = rotation::turn(&(rate * (gap * part))) * before.orientation;
        (orientation, self.energies[index] * (1.0 - part) + self.energies[index + 1] * part)
    }

    /// The energy of a state that errors are counted in [J].
    pub fn energy(&self, state: &Snapshot) -> f64 {
        energy(&self.system, self.coupled, state)
    }

    /// Energy at t = 0 [J].
    pub fn first_energy(&self) -> f64 {
        self.energies[0]
    }
}

fn even(duration: f64, intervals: usize) -> Vec<f64> {
    (0..=intervals).map(|j| j as f64 * duration / intervals as f64).collect()
}

fn largest_spin(states: &[Snapshot]) -> f64 {
    states.iter().map(|state| rotation::length(&state.angular_velocity)).fold(0.0, f64::max)
}

/// The energy that a scheme should keep or follow [J]: of rotation alone where nothing couples it to the translation, which
/// would drown it.
fn energy(system: &System, coupled: bool, state: &Snapshot) -> f64 {
    if coupled {
        system.kinetic_energy(state) + system.potential_energy(state).unwrap_or(0.0)
    } else {
        system.rotational_energy(state)
    }
}

fn scale(system: &System, coupled: bool, states: &[Snapshot], energies: &[f64]) -> f64 {
    let kinetic = states.iter().map(|state| system.rotational_energy(state)).fold(0.0, f64::max);
    let kinetic = if coupled {
        states.iter().map(|state| system.kinetic_energy(state)).fold(kinetic, f64::max)
    } else {
        kinetic
    };
    let low = energies.iter().copied().fold(f64::INFINITY, f64::min);
    let high = energies.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    kinetic.max(high - low).max(f64::MIN_POSITIVE)
}

/// The principal axis that L stays on in all of these states.
pub(super) fn settled_axis(system: &System, states: &[Snapshot]) -> Option<Axis> {
    let parts = states.iter().map(|state| axis_parts(system, state));
    let least = parts.reduce(|a, b| a.inf(&b))?;
    axis_of(system, &least)
}

/// The axis along which this part of L is large enough.
pub(super) fn axis_of(system: &System, parts: &Vector3<f64>) -> Option<Axis> {
    if system.body.shape != Shape::Extended || system.body.symmetric() {
        return None;
    }
    let index = (0..3).find(|index| parts[*index] >= SETTLED)?;
    let moments = system.body.moments;
    Some(if index == moments.imin() {
        Axis::Smallest
    } else if index == moments.imax() {
        Axis::Largest
    } else {
        Axis::Middle
    })
}

/// |L_i|/|L| in principal axes.
pub(super) fn axis_parts(system: &System, state: &Snapshot) -> Vector3<f64> {
    let momentum = state.orientation.inverse_transform_vector(&state.angular_momentum);
    let momentum = system.body.principal.inverse_transform_vector(&momentum);
    momentum.abs() / rotation::length(&momentum).max(f64::MIN_POSITIVE)
}

fn driven(system: &System, first: &Snapshot) -> bool {
    // Without a potential, what a fall goes on to win cannot be told from what a scheme adds.
    let untold = system.potential_energy(first).is_none();
    untold || system.forces.laws().iter().any(Law::drives)
}
