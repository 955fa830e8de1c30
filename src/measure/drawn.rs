//! Roundings drawn anew: the same motion in runs whose every rounding is another, and how far they end from one another.

use nalgebra::Vector3;

use super::moved_starts::{DIRECTIONS, shaken_starts};
use super::{Reading, largest};
use crate::model::{Change, PerQuantity, Snapshot, System};
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Turned worlds that the roundings of a ladder are drawn in: none of those that gates judge by.
const TURNS: [Vector3<f64>; 3] =
    [Vector3::new(1.2, 0.9, -0.5), Vector3::new(-0.7, 1.4, 1.1), Vector3::new(0.5, -0.4, -2.3)];

/// The largest differences of such runs.
pub(super) struct Drawn {
    /// Steps of the runs.
    pub steps: u64,
    /// In turned worlds.
    pub turned: PerQuantity<Reading>,
    /// Started a few rounding units off.
    pub shaken: PerQuantity<Reading>,
}

impl Drawn {
    /// Beside `own`, the run of the plan. A solver that chooses its own steps chooses others, and what it differs by is no rounding.
    pub fn of(
        contestant: &Contestant,
        system: &System,
        motion: &[Snapshot],
        plan: &Plan,
        own: &[Snapshot],
    ) -> Drawn {
        if contestant.card.tolerance_exponent() > 0 {
            let nothing = PerQuantity::all(Reading::ZERO);
            return Drawn { steps: plan.steps, turned: nothing, shaken: nothing };
        }
        let run = |system: &System| {
            let run = contestant.run(system, Form::Least, plan);
            run.outcome.broken.is_none().then_some(run.states)
        };
        let turned = TURNS.into_iter().filter_map(|turn| {
            let change = Change { turn: rotation::turn(&turn), ..Change::none() };
            Some(run(&change.apply(system))?.iter().map(|state| change.undo(state)).collect())
        });
        let shaken = shaken_starts(system, motion, DIRECTIONS).filter_map(|system| run(&system));
        Drawn {
            steps: plan.steps,
            turned: furthest(system, own, turned),
            shaken: furthest(system, own, shaken),
        }
    }
}

/// How far runs end from `own`, and get from it, at most.
fn furthest(
    system: &System,
    own: &[Snapshot],
    runs: impl Iterator<Item = Vec<Snapshot>>,
) -> PerQuantity<Reading> {
    runs.fold(PerQuantity::all(Reading::ZERO), |furthest, states| {
        furthest.zip(largest(system, &states, own)).map(|(furthest, by)| furthest.or(by))
    })
}
