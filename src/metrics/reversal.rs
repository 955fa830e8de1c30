//! There and back: a run with h, and one with −h from where it ended.
//!
//! A symmetric scheme, Φ₋ₕ Φₕ = 1, returns to its start to rounding; any other is off by its own error.

use super::{Rung, larger, steady_rung};
use crate::model::{Quantity, System, difference};
use crate::simulate::{Contestant, Form, Outcome, Plan};

/// Most steps of one way.
const STEPS: u64 = 4096;

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
    /// Whether an implicit equation was solved on the way.
    pub solves: u64,
}

/// Runs there and back in the steps of the coarsest run that follows the truth; `None` where there is none, where a force
/// depends on time, or where friction makes the way back amplify every rounding.
pub fn reversal(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Option<Reversal> {
    if system.forces.read_time() || (system.forces.read_velocity() && !system.forces.conservative()) {
        return None;
    }
    let rung = steady_rung(system, rungs)?;
    let steps = rung.steps.min(STEPS);
    let run =
        |system: &System, step: f64| contestant.run(system, Form::Least, &Plan { step, steps, every: steps });
    let there = run(system, rung.step);
    let turning_point = there.states.last()?;
    let back = run(&system.started_at(turning_point), -rung.step);
    let whole = |outcome: &Outcome| outcome.broken.is_none();
    let mut reversal = Reversal {
        steps,
        step: rung.step,
        of_floor: 0.0,
        quantity: Quantity::BodyPoint,
        distance: f64::NAN,
        solves: there.outcome.solves,
    };
    if !whole(&there.outcome) || !whole(&back.outcome) {
        return Some(Reversal { of_floor: f64::NAN, ..reversal });
    }
    let distances = difference(&system.body, back.states.last()?, there.states.first()?);
    for ((value, floor), quantity) in distances.into_iter().zip(&rung.floors).zip(Quantity::ALL) {
        // Twice as many steps, and their roundings, as in the run that the floor belongs to.
        let ratio = if value == 0.0 { 0.0 } else { value / (2.0 * floor.max) };
        if reversal.distance.is_nan() || ratio.is_nan() || ratio > reversal.of_floor {
            (reversal.quantity, reversal.distance) = (quantity, value);
        }
        reversal.of_floor = larger(reversal.of_floor, ratio);
    }
    Some(reversal)
}
