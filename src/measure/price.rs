//! What the runs of a scheme in a scene cost, from short runs of it.

use std::time::Instant;

use super::climb::{Bounds, FEWEST_RUNGS, FINE, phase, steps};
use super::order::FEWEST;
use crate::model::System;
use crate::model::copies::COPIES;
use crate::reference::Reference;
use crate::simulate::{Contestant, Form, Plan};

/// Steps of a short run, at most.
const SHORT: u64 = 32;
/// What is measured beside the runs of a ladder costs as much as they do, at most: a run of an odd number of steps 3/8 of them, and long
/// runs as many steps as [`long_steps`] says.
const BESIDE: f64 = 2.0;

/// The runs of a ladder and what they cost.
#[derive(Clone, Debug)]
pub struct Price {
    /// Steps of the runs, rising.
    pub steps: Vec<u64>,
    /// A run, without its steps [s].
    of_run: f64,
    /// A step [s].
    of_step: f64,
}

impl Price {
    /// Runs a few steps. `order` and `bounds` are those of the ladder. What chooses its own steps, or does not take the scene, costs nothing here.
    pub fn of(
        contestant: &Contestant,
        system: &System,
        reference: &Reference,
        (order, bounds): (Option<u32>, Bounds),
    ) -> Price {
        let steps = steps(contestant, phase(system, reference), order.unwrap_or_default(), bounds);
        let Some(first) = steps.first().copied().filter(|_| !contestant.chooses_steps()) else {
            return Price { steps, of_run: 0.0, of_step: 0.0 };
        };
        let duration = reference.times[reference.times.len() - 1];
        let timed = |count: u64| {
            let plan = Plan { step: duration / first as f64, steps: count, every: count };
            let since = Instant::now();
            contestant.run(system, Form::Least, &plan);
            since.elapsed().as_secs_f64()
        };
        // The first run starts a program.
        timed(1);
        let few = timed(1);
        let short = first.min(SHORT);
        let of_step = ((timed(short) - few) / (short - 1) as f64).max(0.0);
        Price { steps, of_run: (few - of_step).max(0.0), of_step }
    }

    /// Fewest runs that decide anything.
    pub fn fewest(&self) -> usize {
        self.steps.len().min(FEWEST)
    }

    /// Runs after which a ladder ends, where they decide.
    pub fn usual(&self) -> usize {
        let fine =
            self.steps.iter().position(|steps| *steps >= FINE).map_or(self.steps.len(), |last| last + 1);
        fine.max(FEWEST_RUNGS).min(self.steps.len())
    }

    /// What so many runs cost, with their copies and what is measured beside them [s].
    pub fn seconds(&self, runs: usize) -> f64 {
        let steps: u64 = self.steps[..runs].iter().sum();
        BESIDE * (1 + COPIES) as f64 * (self.of_run * runs as f64 + self.of_step * steps as f64)
    }
}

/// Steps of all long runs together beside a ladder whose finest run has so many: half of those of the ladder and of its copies.
pub fn long_steps(finest: u64) -> u64 {
    (1 + COPIES as u64) * finest
}
