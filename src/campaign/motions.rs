//! Motions to be shown: the truth of a scene, and a few schemes at three steps beside it.

use std::sync::Arc;

use rayon::prelude::*;

use super::typical_step;
use crate::journal::{self, Journal};
use crate::model::body::Shape;
use crate::model::{Snapshot, System};
use crate::record::{Motion, Records, TIME_DIGITS, to_digits};
use crate::reference::Reference;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form, Plan};

/// Schemes that are shown in a scene: each adds 8 kB to the records of a scene.
const SCHEMES: usize = 2;
/// Intervals between the states that are shown.
const FRAMES: usize = 128;
/// Steps of the three runs; the coarsest is a state each.
const STEPS: [u64; 3] = [128, 512, 2048];
/// A state that is shown in typical steps: 0.4 rad at most, so that a turn between two states is unique.
const TYPICAL_STEPS: f64 = 8.0;
/// Digits of what is drawn: a tenth of a pixel.
const DIGITS: usize = 3;

/// Adds the motions of the scenes whose bodies turn.
pub(super) fn add_motions(
    records: &mut Records,
    scenes: &[Scene],
    contestants: &[Contestant],
    journal: Option<&Journal>,
) {
    let shown =
        |scene: &&Scene| scene.only_for_stability.is_none() && scene.system.body.shape != Shape::Point;
    let scenes: Vec<&Scene> = scenes.iter().filter(shown).collect();
    let known_as: Vec<String> = contestants.iter().map(Contestant::identity).collect();
    let rows = scenes.par_iter().with_max_len(1).filter_map(|scene| {
        let key = ("motion", &scene.name, scene.content(), &known_as);
        journal::row(journal, &key, || of_scene(scene, contestants))
    });
    let rows: Vec<Vec<Motion>> = rows.collect();
    records.motions.extend(rows.into_iter().flatten().map(Arc::new));
}

fn of_scene(scene: &Scene, contestants: &[Contestant]) -> Vec<Motion> {
    let system = &scene.system;
    let duration = (TYPICAL_STEPS * FRAMES as f64 * typical_step(scene)).min(scene.duration);
    let Ok(truth) = Reference::of(system, duration, FRAMES, None) else { return Vec::new() };
    let mut rows = vec![row(scene, "", 0.0, system, &truth.states)];
    let able = contestants.iter().filter(|one| one.refusal(system).is_none());
    for contestant in able.take(SCHEMES) {
        for steps in STEPS {
            let plan = Plan::over(duration, steps, FRAMES as u64);
            let run = contestant.run(system, Form::Least, &plan);
            if run.outcome.broken.is_none() && run.states.len() == FRAMES + 1 {
                rows.push(row(scene, contestant.card.name, plan.step, system, &run.states));
            }
        }
    }
    rows
}

fn row(scene: &Scene, scheme: &str, step: f64, system: &System, states: &[Snapshot]) -> Motion {
    let mut row = motion(system, states);
    (row.scene, row.scheme, row.step_s) = (scene.name.clone(), scheme.to_owned(), step);
    row.time_s.iter_mut().for_each(|time| *time = to_digits(*time, TIME_DIGITS));
    row.turn.iter_mut().chain(&mut row.spin).for_each(|value| *value = to_digits(*value, DIGITS));
    row
}

/// The motion of these states, without the names of scene and scheme.
pub(crate) fn motion(system: &System, states: &[Snapshot]) -> Motion {
    let body = &system.body;
    let turn = |state: &Snapshot| {
        let turn = state.orientation * body.principal;
        [turn.w, turn.i, turn.j, turn.k]
    };
    let spin = |state: &Snapshot| {
        let turn = state.orientation * body.principal;
        let spin = turn.inverse_transform_vector(&state.angular_velocity);
        [spin.x, spin.y, spin.z]
    };
    Motion {
        moments: body.moments.into(),
        time_s: states.iter().map(|state| state.time).collect(),
        turn: states.iter().flat_map(turn).collect(),
        spin: states.iter().flat_map(spin).collect(),
        ..Motion::default()
    }
}
