//! What a reduction saves: a step on every mass point beside one on the least model, timed alone on the machine.

use super::costs::typical_step;
use crate::record::Records;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form};
use crate::study::cost::{self, Course};

/// Time that each form of each scene is timed for [s].
const SECONDS: f64 = 0.02;

/// Times both forms of the first main scheme, Peskin's, on every scene whose body has points, and puts the ratio of their costs
/// into the scenes. To be called while nothing else runs.
pub(super) fn add_reductions(records: &mut Records, scenes: &[Scene]) {
    let Some(contestant) = Contestant::main().into_iter().next() else { return };
    let pointed = |scene: &&Scene| {
        let points = &scene.system.body.points;
        !points.is_empty() && contestant.refusal(&scene.system).is_none()
    };
    let scenes: Vec<&Scene> = scenes.iter().filter(pointed).collect();
    let courses: Vec<Course> = scenes
        .iter()
        .flat_map(|scene| {
            [Form::Points, Form::Least].map(|form| Course {
                contestant: &contestant,
                system: &scene.system,
                form,
                step: typical_step(scene),
                seconds: SECONDS,
            })
        })
        .collect();
    let costs = cost::measure(&courses);
    for (scene, pair) in scenes.iter().zip(costs.as_chunks().0) {
        let [Some(written), Some(least)] = pair else { continue };
        for row in records.scenes.iter_mut().filter(|row| row.name == scene.name) {
            row.reduction_speedup = Some(written.nanoseconds_per_step / least.nanoseconds_per_step);
        }
    }
}
