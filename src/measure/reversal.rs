//! There and back: a run with h, and one with −h from where it ended.
//!
//! A symmetric scheme, Φ₋ₕ Φₕ = 1, returns to its start to rounding; any other is off by its own error.

use super::moved_starts::shaken_starts;
use super::{Rung, SHAKEN, larger, steady_rung};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::simulate::{Contestant, Form, Plan};

/// Most steps of one way.
const STEPS: u64 = 4096;
/// States of one way that say how large everything gets.
const SAMPLES: u64 = 16;

/// A run there and back.
#[derive(Clone, Debug)]
pub struct Reversal {
    /// Steps of one way.
    pub steps: u64,
    /// h [s].
    pub step: f64,
    /// Largest distance from the start over its floor, of all quantities; NaN where a run broke.
    pub of_floor: f64,
    /// The quantity that it belongs to.
    pub quantity: Quantity,
    /// The distance itself.
    pub distance: f64,
    /// Implicit equations that were solved on the way there.
    pub solves: u64,
    /// Angle that roundings of this very run leave open, where that was measured [rad].
    pub open: f64,
}

/// Runs there and back in the steps of the coarsest run that follows the truth; `None` where there is none, where a force
/// depends on time, or where friction makes the way back amplify every rounding.
pub fn reversal(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Option<Reversal> {
    if system.forces.read_time() || (system.forces.read_velocity() && !system.forces.conservative()) {
        return None;
    }
    let rung = steady_rung(contestant, system, rungs, STEPS)?;
    let steps = rung.steps.min(STEPS);
    let mut reversal = Reversal {
        steps,
        step: rung.step,
        of_floor: f64::NAN,
        quantity: Quantity::BodyPoint,
        distance: f64::NAN,
        solves: 0,
        open: 0.0,
    };
    let Some(own) = there_and_back(contestant, system, rung.step, steps) else { return Some(reversal) };
    reversal.solves = own.solves;
    // Twice as many steps, and their roundings, as in the run that the ladder's floor belongs to.
    let mut floors = rung.floors.map(|floor| 2.0 * floor.max);
    let off = difference(&system.body, &own.back, &own.start);
    if off.zip(floors).values().any(|(off, floor)| off > floor) {
        // The run itself says better: where its steps amplify a rounding there and again on the way back, no other does.
        let spread = spread(contestant, system, rung.step, steps, &own);
        floors = floors.max(spread);
        reversal.open = spread[Quantity::Orientation];
    }
    reversal.of_floor = 0.0;
    for (quantity, (value, floor)) in off.zip(floors) {
        let ratio = if value == 0.0 { 0.0 } else { value / floor };
        if reversal.distance.is_nan() || ratio.is_nan() || ratio > reversal.of_floor {
            (reversal.quantity, reversal.distance) = (quantity, value);
        }
        reversal.of_floor = larger(reversal.of_floor, ratio);
    }
    Some(reversal)
}

/// A way there and back.
struct Return {
    start: Snapshot,
    /// States of the way there.
    there: Vec<Snapshot>,
    back: Snapshot,
    solves: u64,
}

/// `None` where a run breaks.
fn there_and_back(contestant: &Contestant, system: &System, step: f64, steps: u64) -> Option<Return> {
    let run = |system: &System, step: f64, every: u64| {
        let run = contestant.run(system, Form::Least, &Plan { step, steps, every });
        run.outcome.broken.is_none().then_some(run)
    };
    let there = run(system, step, (steps / SAMPLES).max(1))?;
    let back = run(&system.started_at(there.states.last()?), -step, steps)?;
    let (start, back) = (*there.states.first()?, *back.states.last()?);
    Some(Return { start, back, solves: there.outcome.solves, there: there.states })
}

/// How far ways there and back that start a few rounding units off end from `own`, at most.
fn spread(contestant: &Contestant, system: &System, step: f64, steps: u64, own: &Return) -> PerQuantity<f64> {
    let mut largest = PerQuantity::all(0.0);
    for system in shaken_starts(system, &own.there, SHAKEN) {
        if let Some(other) = there_and_back(contestant, &system, step, steps) {
            largest = largest.max(difference(&system.body, &other.back, &own.back));
        }
    }
    largest
}
