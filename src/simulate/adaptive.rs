//! Runs of solvers that choose their own steps: a step of the plan stands for a tolerance, and every stored time ends a step.

use std::time::Instant;

use super::{Break, Contestant, Outcome, Plan};
use crate::model::{Broken, Snapshot, System};
use crate::schemes::adaptive::Adaptive;

pub(super) fn contestants() -> Vec<Contestant> {
    let contestant = |solver: Adaptive| {
        let card = solver.card.clone();
        Contestant::engine(card, solver.refusal, move |system, plan, store| run(&solver, system, plan, store))
    };
    Adaptive::ALL.map(contestant).into()
}

/// Solves for the times that a plan stores.
fn run(solver: &Adaptive, system: &System, plan: &Plan, store: &mut dyn FnMut(&Snapshot)) -> Outcome {
    let every = plan.every.max(1);
    let stored = (0..plan.steps).step_by(every as usize).chain([plan.steps]);
    let times: Vec<f64> = stored.map(|n| n as f64 * plan.step).collect();
    let begun = Instant::now();
    match solver.solve(system, &times, plan.step) {
        Ok(run) => {
            run.states.iter().for_each(store);
            Outcome {
                steps: plan.steps,
                evaluations: run.evaluations as u64,
                nanoseconds: begun.elapsed().as_nanos() as u64,
                ..Outcome::none_yet()
            }
        }
        Err(error) => {
            let why = Broken::Foreign(error.to_string().into());
            Outcome { broken: Some(Break { step: 0, time: 0.0, why }), ..Outcome::none_yet() }
        }
    }
}
