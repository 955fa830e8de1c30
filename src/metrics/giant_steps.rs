//! The whole run of a steady spin in a few steps: exact is exact at every step.

use super::Reading;
use super::ladder::Rung;
use super::rounding::{floors, of_giant_steps, rounding_growth, roundings};
use crate::model::{System, difference};
use crate::reference::Reference;
use crate::simulate::{Contestant, Form, Plan, Trajectory};

/// Numbers of steps, odd ones, that a whole run in steady spin is made in besides its ladder.
const GIANT_STEPS: [u64; 4] = [1, 3, 5, 7];

/// The whole run in a few steps, compared at its end. Steps that amplify a rounding to an angle that can be seen say nothing.
pub(super) fn giant_steps(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    turned: f64,
) -> Vec<Rung> {
    let last = reference.times.len() - 1;
    let run = |steps: u64| {
        let plan = Plan { step: reference.times[last] / steps as f64, steps, every: steps };
        let own = rounding_growth(contestant, system, &reference.states, &plan);
        let Trajectory { states, outcome } = contestant.run(system, Form::Least, &plan);
        let mut errors = [Reading { end: f64::NAN, max: f64::NAN }; 6];
        if let (None, Some(end)) = (&outcome.broken, states.last()) {
            let apart = difference(&system.body, end, &reference.states[last]);
            errors = apart.map(|value| Reading { end: value, max: value });
        }
        let measured = of_giant_steps(contestant, system, &plan, states.last());
        let mut floors = floors(system, reference, &own, roundings(system, steps, turned));
        for (floor, measured) in floors.iter_mut().zip(measured) {
            *floor = Reading { end: floor.end.max(measured), max: floor.max.max(measured) };
        }
        let rung =
            Rung { step: plan.step, steps, errors, floors, moved: errors, readings: Vec::new(), outcome };
        (!rung.is_open(system)).then_some(rung)
    };
    GIANT_STEPS.into_iter().filter_map(run).collect()
}
