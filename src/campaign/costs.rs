//! What a step of each scheme costs, measured alone on the machine: after a campaign, never in it.
//!
//! Scenes that ask the same work of a scheme (same model, laws and number of points) share a measurement. The time given to a
//! scheme and kind of scene is divided among those of the kind. Where a step is made of a varying number of evaluations, as in
//! an implicit scheme whose iterations depend on h, the cost of a step at another h follows the evaluations counted there.

use std::sync::Arc;

use super::rows::COST_DIGITS;
use crate::record::{CostRow, Records, to_digits};
use crate::rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form};
use crate::study::cost::{self, Cost, Course};

/// Radians turned in a step that is timed, at most.
const TURN: f64 = 0.05;
/// Steps of the whole run that is timed a part of, at least.
const STEPS: f64 = 512.0;

/// What decides the work of a step: model, laws, and mass points where a model visits them.
type Work = (&'static str, Vec<&'static str>, usize);

fn work(contestant: &Contestant, scene: &Scene, form: Form) -> Work {
    let model = if form == Form::Points { "points" } else { contestant.model(&scene.system) };
    let mut laws: Vec<&str> = scene.system.forces.laws().iter().map(|law| law.name()).collect();
    laws.sort_unstable();
    let visits = matches!(model, "points" | "forced");
    (model, laws, if visits { scene.system.body.points.len() } else { 0 })
}

/// The kind of a scene: torques alone and a pivot are the same equations.
fn kind(model: &str) -> &str {
    if matches!(model, "pivot" | "torque") { "torque or pivot" } else { model }
}

/// A course that is timed, with the place of its scene.
struct Timed<'a> {
    work: Work,
    scene: &'a Scene,
    contestant: &'a Contestant,
    form: Form,
}

/// The step that is timed [s]: small enough that nothing breaks, large enough that a rotation is one.
pub fn typical_step(scene: &Scene) -> f64 {
    let inertia = scene.system.body.inverse_inertia();
    let start = &scene.system.start;
    let spin = inertia * start.orientation.inverse_transform_vector(&start.angular_momentum);
    let fastest = rotation::length(&spin);
    let turning = if fastest > 0.0 { TURN / fastest } else { f64::INFINITY };
    turning.min(scene.duration / STEPS)
}

/// Every work of every scheme once, and the point form on the first body that has one.
fn courses<'a>(scenes: &'a [Scene], contestants: &'a [Contestant]) -> Vec<Timed<'a>> {
    let mut courses: Vec<Timed> = Vec::new();
    let pointed = scenes.iter().find(|scene| !scene.system.body.points.is_empty());
    for contestant in contestants.iter().filter(|contestant| !contestant.has_own_clock()) {
        let mut own: Vec<Timed> = Vec::new();
        let least = scenes.iter().map(|scene| (scene, Form::Least));
        let points = pointed.filter(|_| contestant.takes_points()).map(|scene| (scene, Form::Points));
        for (scene, form) in least.chain(points) {
            let work = work(contestant, scene, form);
            if contestant.refusal(&scene.system).is_none() && own.iter().all(|timed| timed.work != work) {
                own.push(Timed { work, scene, contestant, form });
            }
        }
        courses.extend(own);
    }
    courses
}

/// Time that each scheme is timed for in each kind of scene [s].
pub const SECONDS_A_COST: f64 = 0.25;

/// Times `contestants` in `scenes`, so many seconds a scheme and kind of scene, and puts the costs into the records: a row each,
/// and the cost of a step into every measurement of theirs. To be called while nothing else runs.
pub fn add_costs(records: &mut Records, scenes: &[Scene], contestants: &[Contestant], seconds: f64) {
    let timed = courses(scenes, contestants);
    let alike = |one: &Timed| {
        let same = |other: &&Timed| {
            other.contestant.card.name == one.contestant.card.name && kind(other.work.0) == kind(one.work.0)
        };
        timed.iter().filter(same).count()
    };
    let courses: Vec<Course> = timed
        .iter()
        .map(|one| Course {
            contestant: one.contestant,
            system: &one.scene.system,
            form: one.form,
            step: typical_step(one.scene),
            seconds: seconds / alike(one) as f64,
        })
        .collect();
    let costs = cost::measure(&courses);
    let again = timed.first();
    for (index, (one, cost)) in timed.iter().chain(again).zip(&costs).enumerate() {
        if let Some(cost) = cost {
            records.costs.push(row(one, cost, index == timed.len()));
        }
    }
    fill(records, scenes, contestants, &timed, &costs);
}

fn row(one: &Timed, cost: &Cost, again: bool) -> CostRow {
    CostRow {
        scheme: one.contestant.card.name.to_owned(),
        kind: kind(one.work.0).to_owned(),
        model: one.work.0.to_owned(),
        scene: one.scene.name.clone(),
        step_s: typical_step(one.scene),
        nanoseconds_per_step: cost.nanoseconds_per_step,
        median_nanoseconds_per_step: cost.median_nanoseconds_per_step,
        evaluations_per_step: cost.evaluations_per_step,
        steps_a_block: cost.steps,
        blocks: cost.blocks,
        seconds: cost.seconds,
        again,
    }
}

/// Gives every run the cost of its step.
fn fill(
    records: &mut Records,
    scenes: &[Scene],
    contestants: &[Contestant],
    timed: &[Timed],
    costs: &[Option<Cost>],
) {
    let find = |scene: &str, scheme: &str| {
        let scene = scenes.iter().find(|one| one.name == scene)?;
        let contestant = contestants.iter().find(|one| one.card.name == scheme)?;
        let work = work(contestant, scene, Form::Least);
        let same = |one: &Timed| one.contestant.card.name == scheme && one.work == work;
        costs.get(timed.iter().position(same)?).copied().flatten()
    };
    let mut known = ((String::new(), String::new()), None);
    for measurement in records.measurements.iter_mut().filter(|row| row.steps > 0) {
        if known.0 != (measurement.scene.clone(), measurement.scheme.clone()) {
            known.0 = (measurement.scene.clone(), measurement.scheme.clone());
            known.1 = find(&measurement.scene, &measurement.scheme);
        }
        let Some(cost) = known.1 else { continue };
        let evaluations = measurement.force_evaluations as f64 / measurement.steps as f64;
        let share =
            if cost.evaluations_per_step > 0.0 { evaluations / cost.evaluations_per_step } else { 1.0 };
        let cost = to_digits(cost.nanoseconds_per_step * share, COST_DIGITS);
        Arc::make_mut(measurement).nanoseconds_per_step = Some(cost);
    }
}
