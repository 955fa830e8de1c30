//! Many runs of a scene with its numbers varied, one row each.
//!
//! The numbers of the scene file are changed and the file is read again, so that a scene of a sweep is checked like any other:
//! a body that cannot be is a row that says so. The error is that of the end of the run against a reference of that very
//! scene, where there is one.

mod axis;
mod keys;

use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::interrupt;
use crate::journal::{self, Journal};
use crate::model::{Quantity, Snapshot, System, difference};
use crate::record::RunStatus;
use crate::reference::Reference;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Outcome, Plan};
use crate::study::ensemble::{Ensemble, Member};

pub use axis::Axis;
pub use keys::SceneText;

/// The key of the time step [s], which is not one of the scene file.
pub const STEP: &str = "step";
/// Samples of a reference: the fewest that there can be, of which the last is used.
const SAMPLES: usize = 4;
/// Scenes whose references are made before their runs: what a run that is killed may lose of them.
const TOGETHER: usize = 32;

/// A grid of scenes and steps.
pub struct Sweep {
    /// Name of the scene file in messages.
    pub file: String,
    /// The scene file.
    pub text: SceneText,
    /// What is varied; the last axis runs fastest.
    pub axes: Vec<Axis>,
    /// The step where it is not varied [s].
    pub step: f64,
    /// The quantity whose error is measured.
    pub quantity: Quantity,
    /// Whether errors are measured.
    pub with_errors: bool,
}

/// A run of a sweep.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Scheme.
    pub scheme: String,
    /// The number of every axis.
    pub values: Vec<f64>,
    /// h [s]: the nearest to the one asked for that divides the duration.
    pub step: f64,
    /// Steps taken.
    pub steps: u64,
    /// What came of the run.
    pub status: RunStatus,
    /// Why, where it is not whole.
    pub why: Option<String>,
    /// Error of the quantity at the end, in its unit.
    pub error: Option<f64>,
    /// Change of the energy from start to end over the largest kinetic energy seen; of the rotational energy where no torque
    /// acts, of the total where every law has a potential.
    pub energy: Option<f64>,
    /// Evaluations of the forces.
    pub evaluations: u64,
}

/// A place of the grid: its numbers and its scene, or why there is none.
struct Place {
    /// In the grid.
    index: usize,
    values: Vec<f64>,
    scene: Result<(Arc<Scene>, Plan), String>,
    /// The state at the end of the run, of the reference.
    truth: Option<Snapshot>,
}

/// A scene, or why there is none, and the state at the end of its motion.
type Solved = (Result<Arc<Scene>, String>, Option<Snapshot>);

impl Place {
    /// Why a scheme does not run there.
    fn refusal(&self, contestant: &Contestant) -> Option<String> {
        match &self.scene {
            Err(why) => Some(why.clone()),
            Ok((scene, _)) => contestant.refusal(&scene.system).map(|why| why.into_owned()),
        }
    }
}

/// A place that is run.
struct Asked<'a> {
    place: &'a Place,
    scene: &'a Scene,
    plan: Plan,
}

/// What is kept of a run.
#[derive(Clone, Default)]
struct Kept {
    first: Option<Snapshot>,
    last: Option<Snapshot>,
    kinetic: f64,
}

impl Sweep {
    /// Number of places of the grid.
    pub fn len(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of different scenes, each of which needs a reference of its own.
    pub fn scenes(&self) -> usize {
        self.axes.iter().filter(|axis| axis.key != STEP).map(|axis| axis.values.len()).product()
    }

    /// Runs every scheme at every place, the last axis fastest, scheme after scheme. Where the user asks for the end, the rows that are
    /// whole. `progress` is called with the runs that are done and the runs in all.
    pub fn run(
        &self,
        contestants: &[Contestant],
        journal: Option<&Journal>,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Vec<Row> {
        let (done, all) = (AtomicUsize::new(0), self.len() * contestants.len());
        let tick = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
        let scenes = self.scenes();
        let together = if self.with_errors { TOGETHER } else { scenes.max(1) };
        let mut rows: Vec<Vec<(usize, Row)>> = vec![Vec::new(); contestants.len()];
        for first in (0..scenes).step_by(together).take_while(|_| !interrupt::requested()) {
            let places = self.places(first..scenes.min(first + together));
            for (contestant, rows) in contestants.iter().zip(&mut rows) {
                rows.extend(self.rows(contestant, &places, (journal, &tick)));
            }
        }
        rows.iter_mut().for_each(|rows| rows.sort_by_key(|(place, _)| *place));
        rows.into_iter().flatten().map(|(_, row)| row).collect()
    }

    /// The places of some of the scenes.
    fn places(&self, scenes: Range<usize>) -> Vec<Place> {
        let first = scenes.start;
        // One reference a scene: places that differ in the step alone share it.
        let solved: Vec<Solved> = scenes
            .clone()
            .into_par_iter()
            .map(|index| {
                let scene = self.scene(&self.values(index, |key| key != STEP));
                let truth = scene.as_ref().ok().and_then(|scene| self.truth(scene));
                (scene.map(Arc::new), truth)
            })
            .collect();
        let at = self.axes.iter().position(|axis| axis.key == STEP);
        let place = |index: usize| {
            let values = self.values(index, |_| true);
            let step = at.map_or(self.step, |at| values[at]);
            let (scene, truth) = &solved[self.scene_index(index) - first];
            let scene = scene.clone().and_then(|scene| {
                let plan = plan(&scene, step)?;
                Ok((scene, plan))
            });
            Place { index, values, scene, truth: *truth }
        };
        let among = |index: &usize| scenes.contains(&self.scene_index(*index));
        (0..self.len()).take_while(|_| !interrupt::requested()).filter(among).map(place).collect()
    }

    /// Which scene a place has, among those that differ in more than the step.
    fn scene_index(&self, mut index: usize) -> usize {
        let (mut scene, mut stride) = (0, 1);
        for axis in self.axes.iter().rev() {
            let count = axis.values.len();
            if axis.key != STEP {
                scene += index % count * stride;
                stride *= count;
            }
            index /= count;
        }
        scene
    }

    /// The numbers of the wanted axes at a place among them, the last fastest.
    fn values(&self, mut index: usize, wanted: impl Fn(&str) -> bool) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::new();
        for axis in self.axes.iter().rev().filter(|axis| wanted(&axis.key)) {
            values.push(axis.values[index % axis.values.len()]);
            index /= axis.values.len();
        }
        values.reverse();
        values
    }

    fn scene(&self, values: &[f64]) -> Result<Scene, String> {
        if interrupt::requested() {
            return Err("interrupted".to_owned());
        }
        let mut text = self.text.clone();
        for (axis, value) in self.axes.iter().filter(|axis| axis.key != STEP).zip(values) {
            text.set(&axis.key, *value);
        }
        Scene::parse(&text.text(), &self.file).map_err(|error| error.to_string())
    }

    fn truth(&self, scene: &Scene) -> Option<Snapshot> {
        if !self.with_errors || interrupt::requested() {
            return None;
        }
        Reference::of(&scene.system, scene.duration, SAMPLES, None).ok()?.states.last().copied()
    }

    fn rows(
        &self,
        contestant: &Contestant,
        places: &[Place],
        (journal, tick): (Option<&Journal>, &(dyn Fn() + Sync)),
    ) -> Vec<(usize, Row)> {
        let (mut rows, mut asked) = (Vec::new(), Vec::new());
        if interrupt::requested() {
            return rows;
        }
        let (content, known_as) = (self.content(), contestant.identity());
        let key = |place: &Place| ("sweep", content, place.values.clone(), &known_as);
        for place in places {
            match (place.refusal(contestant), &place.scene, journal::known(journal, &key(place))) {
                (None, Ok((scene, plan)), None) => asked.push(Asked { place, scene, plan: *plan }),
                (_, _, Some(row)) => rows.push((place.index, row)),
                (why, ..) => {
                    rows.push((place.index, Row::refused(contestant, place, &why.unwrap_or_default())));
                }
            }
        }
        rows.iter().for_each(|_| tick());
        let members = asked.iter().map(|one| Member { system: one.scene.system.clone(), plan: one.plan });
        let see = |(index, kept): &mut (usize, Kept), state: &Snapshot| {
            kept.first.get_or_insert(*state);
            kept.last = Some(*state);
            kept.kinetic = kept.kinetic.max(asked[*index].scene.system.kinetic_energy(state));
        };
        let end = |index: usize, (_, kept): (usize, Kept), outcome: Outcome| {
            let place = asked[index].place;
            let row = || self.row(contestant, &asked[index], &kept, &outcome);
            let row = journal::row(journal, &key(place), row)?;
            tick();
            Some((place.index, row))
        };
        let ensemble = Ensemble::new(contestant, members.collect());
        rows.extend(ensemble.rows(|index| (index, Kept::default()), see, end).into_iter().flatten());
        rows
    }

    /// A fingerprint of what decides a row beside its numbers and its scheme.
    fn content(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.text.text().hash(&mut hasher);
        self.axes.iter().for_each(|axis| axis.key.hash(&mut hasher));
        self.step.to_bits().hash(&mut hasher);
        self.with_errors.then_some(self.quantity).hash(&mut hasher);
        hasher.finish()
    }

    fn row(&self, contestant: &Contestant, asked: &Asked, kept: &Kept, outcome: &Outcome) -> Row {
        let Asked { place, scene: Scene { system, .. }, plan } = asked;
        let whole = outcome.broken.is_none();
        let ends = kept.last.zip(place.truth).filter(|_| whole);
        let error = ends.map(|(end, truth)| difference(&system.body, &end, &truth)[self.quantity]);
        Row {
            scheme: contestant.card.name.to_owned(),
            values: place.values.clone(),
            step: plan.step,
            steps: outcome.steps,
            status: if whole { RunStatus::Ok } else { RunStatus::Broken },
            why: outcome.broken.as_ref().map(ToString::to_string),
            error: error.filter(|error| error.is_finite()),
            energy: if whole { energy_change(system, kept) } else { None },
            evaluations: outcome.evaluations,
        }
    }
}

impl Row {
    fn refused(contestant: &Contestant, place: &Place, why: &str) -> Row {
        Row {
            scheme: contestant.card.name.to_owned(),
            values: place.values.clone(),
            step: place.scene.as_ref().map_or(0.0, |(_, plan)| plan.step),
            steps: 0,
            status: RunStatus::NotApplicable,
            why: Some(why.to_owned()),
            error: None,
            energy: None,
            evaluations: 0,
        }
    }
}

/// The run whose step is nearest to the one asked for.
fn plan(scene: &Scene, step: f64) -> Result<Plan, String> {
    let steps = (scene.duration / step).round().max(1.0);
    if !(step > 0.0 && steps <= 1e12) {
        return Err(format!("a step of {step} s cannot be taken {} s long", scene.duration));
    }
    Ok(Plan { step: scene.duration / steps, steps: steps as u64, every: steps as u64 })
}

fn energy_change(system: &System, kept: &Kept) -> Option<f64> {
    let (first, last) = kept.first.zip(kept.last)?;
    let total = |state: &Snapshot| Some(system.kinetic_energy(state) + system.potential_energy(state)?);
    let change = if system.torque_free() {
        system.rotational_energy(&last) - system.rotational_energy(&first)
    } else if system.forces.conservative() {
        total(&last)? - total(&first)?
    } else {
        return None;
    };
    Some(change / kept.kinetic).filter(|change| change.is_finite())
}
