//! Whether the finest run of a ladder, where it broke, would have gone on in smaller steps: then it says that its steps are still too large,
//! as where a point passes close by an attracting centre, and nothing about the limit h → 0.

use super::Rung;
use crate::model::{Broken, System};
use crate::simulate::{Contestant, Form, Plan};

/// Halvings of h that are tried.
const HALVINGS: u32 = 12;
/// Steps of the ladder that must be passed: the one that broke and the next.
const PASSED: u64 = 2;

/// The largest step h/2, h/4, … that the scheme gets past the break in [s]; `None` where the run is whole or there is none. (Where a
/// force reads the time, its clock starts anew.)
pub(super) fn goes_on_in(contestant: &Contestant, system: &System, finest: &Rung) -> Option<f64> {
    let broken = finest.outcome.broken.as_ref()?;
    if !matches!(broken.why, Broken::NoConvergence { .. } | Broken::NotFinite) {
        return None;
    }
    let steps = finest.outcome.steps;
    let before = if steps == 0 {
        system.clone()
    } else {
        let plan = Plan { step: finest.step, steps, every: steps };
        system.started_at(contestant.run(system, Form::Least, &plan).states.last()?)
    };
    (1..=HALVINGS).map(|halvings| 1u64 << halvings).find_map(|parts| {
        let step = finest.step / parts as f64;
        let steps = PASSED * parts;
        let run = contestant.run(&before, Form::Least, &Plan { step, steps, every: steps });
        run.outcome.broken.is_none().then_some(step)
    })
}
