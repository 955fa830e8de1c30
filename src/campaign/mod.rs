//! The grid of runs: every scheme in every scene, measured first and judged second.
//!
//! Parallel over cells, never inside one; results are gathered by their place in the grid, so that one thread or
//! many give the same numbers to the last bit, timings aside.

pub(crate) mod cell;
mod against_time;
mod costs;
mod journal;
mod motions;
#[cfg(feature = "cli")]
mod peers;
mod reduction;
mod rows;
mod scaling;
mod survey;

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::gates::{self, Baseline};
use crate::interrupt;
use crate::measure::Bounds;
use crate::record::{Machine, Records, ReferenceEvidence, SCHEMA};
use crate::reference::{Reference, ReferenceError, stored};
use crate::scenes::Scene;
use crate::simulate::Contestant;

pub(crate) use cell::unmeasured;
pub(crate) use costs::{SECONDS_A_COST, add_costs, typical_step};
pub use journal::Journal;
pub(crate) use motions::motion;
#[cfg(feature = "cli")]
pub(crate) use peers::add_peers;
pub use scaling::Sizes;
pub use survey::{Survey, Task};

/// Samples of a reference over the run.
const SAMPLES: usize = 256;

/// What a campaign covers.
pub struct Campaign<'a> {
    /// Scenes, in the order of the report.
    pub scenes: Vec<Scene>,
    /// Schemes, in the order of the report.
    pub contestants: Vec<Contestant>,
    /// Error constants on record.
    pub baseline: Baseline,
    /// Whether to keep quantities against time, for drawing.
    pub series: bool,
    /// The bounds of the runs of a scheme in a scene.
    pub bounds: &'a (dyn Fn(&str, &str) -> Bounds + Sync),
    /// Finished cells on disk, where they are kept.
    pub journal: Option<&'a Journal>,
    /// Called as (done, of all) after every piece of work.
    pub progress: &'a (dyn Fn(usize, usize) + Sync),
}

/// A scene with the reference that its runs are compared with.
struct Prepared<'a> {
    scene: &'a Scene,
    /// `None` where no claim is judged.
    reference: Option<Result<Reference, ReferenceError>>,
}

impl Campaign<'_> {
    /// A grid at its plainest: the constants of this version, nothing to draw, nobody to tell.
    pub fn of(scenes: Vec<Scene>, contestants: Vec<Contestant>) -> Campaign<'static> {
        Campaign {
            scenes,
            contestants,
            baseline: Baseline::built_in(),
            series: false,
            bounds: &|_, _| Bounds::default(),
            journal: None,
            progress: &|_, _| (),
        }
    }

    /// Measures and judges the whole grid, or what there was time for.
    pub fn run(&self) -> Records {
        let all = self.scenes.len() * (self.contestants.len() + 1);
        let done = AtomicUsize::new(0);
        let tick = || (self.progress)(done.fetch_add(1, Ordering::Relaxed) + 1, all);
        // One scene or cell at a time to whoever is free: a thread that took many at once could be left alone with them.
        let gone_through = self.scenes.par_iter().with_max_len(1).map(|scene| {
            let prepared = (!interrupt::requested()).then(|| prepare(scene));
            tick();
            let prepared = prepared?;
            let cells = self.contestants.par_iter().with_max_len(1).map(|contestant| {
                let cell = if interrupt::requested() { None } else { self.cell(&prepared, contestant) };
                tick();
                // What was running when the user asked for the end is not a whole cell.
                cell.filter(|_| !interrupt::requested())
            });
            let cells: Vec<Option<cell::Cell>> = cells.collect();
            Some((prepared, cells))
        });
        let gone_through: Vec<Option<(Prepared, Vec<Option<cell::Cell>>)>> = gone_through.collect();
        self.records(gone_through.into_iter().flatten().collect())
    }

    fn cell(&self, prepared: &Prepared, contestant: &Contestant) -> Option<cell::Cell> {
        if let Some(reason) = &prepared.scene.only_for_stability {
            return Some(cell::refused(prepared.scene, contestant, reason));
        }
        let reference = prepared.reference.as_ref()?.as_ref().ok()?;
        let bounds = (self.bounds)(&prepared.scene.name, contestant.card.name);
        let measure =
            || cell::measure(prepared.scene, reference, contestant, bounds, &self.baseline, self.series);
        let Some(journal) = self.journal else { return Some(measure()) };
        let (scene, card) = (prepared.scene, &contestant.card);
        let known_as = contestant.program().map_or(String::new(), |program| program.name);
        let what = (&scene.name, scene.content(), card.name, known_as, bounds, &card.claims, self.series);
        let key = format!("{what:?}");
        if let Some(known) = journal.find(&key) {
            let verdicts = gates::judge(&known.evidence, &self.baseline);
            return Some(cell::Cell { verdicts, ..known.clone() });
        }
        let cell = measure();
        if !interrupt::requested() {
            journal.add(key, &cell);
        }
        Some(cell)
    }

    fn records(&self, scenes: Vec<(Prepared, Vec<Option<cell::Cell>>)>) -> Records {
        let mut records = Records {
            schema: SCHEMA.to_owned(),
            polhode: env!("CARGO_PKG_VERSION").to_owned(),
            machine: machine(),
            made_at: now(),
            complete: !interrupt::requested(),
            schemes: self.contestants.iter().map(|contestant| rows::scheme(&contestant.card)).collect(),
            engines: self.contestants.iter().filter_map(rows::engine).collect(),
            ..Records::default()
        };
        for (prepared, own) in scenes {
            let reduction =
                own.iter().flatten().find_map(|cell| Some(cell.evidence.points.as_ref()?.difference));
            let reference = prepared.reference.as_ref().and_then(|one| one.as_ref().ok());
            records.scenes.push(rows::scene(prepared.scene, reference, reduction));
            let reference = reference_evidence(&prepared);
            records.verdicts.extend(reference.as_ref().map(gates::judge_reference));
            records.references.extend(reference);
            for cell in own.into_iter().flatten() {
                records.measurements.extend(cell.measurements.into_iter().map(Arc::new));
                records.orders.extend(cell.orders);
                records.drifts.extend(cell.drifts);
                records.evidence.push(cell.evidence);
                records.verdicts.extend(cell.verdicts);
                records.series.extend(cell.series.into_iter().map(Arc::new));
            }
        }
        records
    }
}

fn prepare(scene: &Scene) -> Prepared<'_> {
    if scene.only_for_stability.is_some() {
        return Prepared { scene, reference: None };
    }
    let solution = if scene.built_in { stored::find(&scene.name) } else { Ok(None) };
    let reference = solution
        .map_err(ReferenceError::from)
        .and_then(|stored| Reference::of(&scene.system, scene.duration, SAMPLES, stored.as_ref()));
    Prepared { scene, reference: Some(reference) }
}

fn reference_evidence(prepared: &Prepared) -> Option<ReferenceEvidence> {
    let scene = prepared.scene;
    Some(match prepared.reference.as_ref()? {
        Ok(reference) => rows::reference(scene, reference),
        Err(error) => ReferenceEvidence {
            scene: scene.name.clone(),
            missing: Some(error.to_string()),
            ..ReferenceEvidence::default()
        },
    })
}

/// The machine that costs are measured on.
pub(crate) fn machine() -> Machine {
    Machine {
        os: std::env::consts::OS.to_owned(),
        architecture: std::env::consts::ARCH.to_owned(),
        processor: processor(),
        threads: rayon::current_num_threads(),
    }
}

/// The processor's name where the system tells it in a file, or nothing.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    line.and_then(|line| line.split(':').nth(1)).map(str::trim).unwrap_or_default().to_owned()
}

/// The time, RFC 3339, UTC; empty without the feature `cli`.
pub(crate) fn now() -> String {
    #[cfg(not(feature = "cli"))]
    return String::new();
    #[cfg(feature = "cli")]
    humantime::format_rfc3339_seconds(std::time::SystemTime::now()).to_string()
}
