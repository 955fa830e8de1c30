//! The whole run of a steady spin in a few steps: exact is exact at every step.

use super::Reading;
use super::ladder::Rung;
use super::rounding::{SOLVED_TO, TURNS, floors, rounding_growth, roundings};
use crate::model::{Change, PerQuantity, Quantity, Snapshot, System, difference};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan, Trajectory};

/// Numbers of steps, odd ones, that a whole run in steady spin is made in besides its ladder.
const GIANT_STEPS: [u64; 4] = [1, 3, 5, 7];
/// Relative difference of a run in a turned world from which on it is no rounding, whatever a giant step makes of it.
const NO_ROUNDING: f64 = 1e-3;

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
        let mut errors = PerQuantity::all(Reading::NAN);
        if let (None, Some(end)) = (&outcome.broken, states.last()) {
            let apart = difference(&system.body, end, &reference.states[last]);
            errors = apart.map(|value| Reading { end: value, max: value });
        }
        let measured = rounding(contestant, system, &plan, states.last());
        let floors = floors(system, reference, &own, roundings(system, steps, turned))
            .zip(measured)
            .map(|(floor, measured)| floor.or(Reading { end: measured, max: measured }));
        let rung =
            Rung { step: plan.step, steps, errors, floors, moved: errors, readings: Vec::new(), outcome };
        (!rung.is_open(system)).then_some(rung)
    };
    GIANT_STEPS.into_iter().filter_map(run).collect()
}

/// What rounding does to a run in giant steps: how far it ends from `own` in turned worlds, at most. Nothing where that is too
/// far for rounding, which then is a defect that the floor must not hide.
fn rounding(
    contestant: &Contestant,
    system: &System,
    plan: &Plan,
    own: Option<&Snapshot>,
) -> PerQuantity<f64> {
    let mut largest = PerQuantity::all(0.0);
    let Some(own) = own else { return largest };
    let spin = rotation::length(&own.angular_velocity);
    let mut whole = 0;
    for turn in TURNS {
        let change = Change { turn: rotation::turn(&turn), ..Change::none() };
        let run = contestant.run(&change.apply(system), Form::Least, plan);
        let Some(end) = run.states.last().filter(|_| run.outcome.broken.is_none()) else { continue };
        whole += 1;
        let apart = difference(&system.body, &change.undo(end), own);
        let turns_alike = apart[Quantity::AngularVelocity] <= NO_ROUNDING * spin;
        if turns_alike && apart[Quantity::Orientation] <= NO_ROUNDING {
            largest = largest.max(apart);
        }
        // Every world leaves the same of an implicit equation.
        let left = run.outcome.solves as f64 * SOLVED_TO;
        for (quantity, left) in [(Quantity::Orientation, left), (Quantity::AngularVelocity, left * spin)] {
            largest[quantity] = largest[quantity].max(left);
        }
    }
    // A step that can be made in no other world is made in this one by chance.
    if whole == 0 { PerQuantity::all(f64::INFINITY) } else { largest }
}
