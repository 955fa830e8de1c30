//! The grid of runs: every scheme in every scene, measured first and judged second.
//!
//! Parallel over cells, never inside one; results are gathered by their place in the grid, so that one thread or
//! many give the same numbers to the last bit, timings aside.

pub(crate) mod cell;
mod against_time;
mod budget;
mod costs;
mod motions;
#[cfg(feature = "cli")]
mod peers;
mod reduction;
mod rows;
mod scaling;
mod survey;

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::gates::{self, Baseline};
use crate::interrupt;
use crate::journal;
use crate::measure::Bounds;
use crate::record::{Machine, Records, ReferenceEvidence, SCHEMA, to_digits};
use crate::reference::{Reference, ReferenceError, stored};
use crate::scenes::Scene;
use crate::simulate::Contestant;

pub use crate::journal::{Earlier, Journal, JournalError};
pub use budget::Estimate;
pub(crate) use cell::unmeasured;
pub(crate) use costs::{SECONDS_A_COST, add_costs, typical_step};
pub(crate) use motions::motion;
#[cfg(feature = "cli")]
pub(crate) use peers::add_peers;
pub use scaling::Sizes;
pub use survey::{Survey, Task};

use budget::Share;

/// Samples of a reference over the run.
const SAMPLES: usize = 256;
/// Digits of an estimate of time.
const SECONDS_DIGITS: usize = 2;

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
    /// Time for all of it, where the user has no more: ladders end earlier, and what stays undecided for that is said.
    pub budget: Option<Duration>,
    /// Called with what all runs are expected to take, where there is a budget.
    pub estimated: &'a (dyn Fn(Estimate) + Sync),
    /// Finished rows on disk, where they are kept.
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

/// A scene with what every scheme did in it.
type Row<'a> = (Prepared<'a>, Vec<Option<cell::Cell>>);

impl Campaign<'_> {
    /// A grid at its plainest: the constants of this version, nothing to draw, nobody to tell.
    pub fn of(scenes: Vec<Scene>, contestants: Vec<Contestant>) -> Campaign<'static> {
        Campaign {
            scenes,
            contestants,
            baseline: Baseline::built_in(),
            series: false,
            bounds: &|_, _| Bounds::default(),
            budget: None,
            estimated: &|_| (),
            journal: None,
            progress: &|_, _| (),
        }
    }

    /// Measures and judges the whole grid, or what there was time for.
    pub fn run(&self) -> Records {
        let all = self.scenes.len() * (self.contestants.len() + 1);
        let done = AtomicUsize::new(0);
        let tick = || (self.progress)(done.fetch_add(1, Ordering::Relaxed) + 1, all);
        let prepared = |scene| {
            let prepared = (!interrupt::requested()).then(|| prepare(scene));
            tick();
            // What was running when the user asked for the end is not whole.
            prepared.filter(|_| !interrupt::requested())
        };
        // A free thread takes one scene or cell at a time: one that took many at once could end long after the others.
        let scenes = self.scenes.par_iter().with_max_len(1);
        let gone_through: Vec<Option<Row>> = match self.budget {
            None => scenes.map(|scene| Some(self.row(prepared(scene)?, &[], &tick))).collect(),
            Some(budget) => {
                let begun = Instant::now();
                let prepared: Vec<Option<Prepared>> = scenes.map(prepared).collect();
                let (shares, estimate) = budget::shares(self, &prepared, (budget, begun));
                (self.estimated)(estimate);
                let rows = prepared.into_par_iter().zip(shares).with_max_len(1);
                rows.map(|(prepared, shares)| Some(self.row(prepared?, &shares, &tick))).collect()
            }
        };
        self.records(gone_through.into_iter().flatten().collect())
    }

    /// Every scheme in a scene, each within its share where there are shares.
    fn row<'a>(&self, prepared: Prepared<'a>, shares: &[Share], tick: &(dyn Fn() + Sync)) -> Row<'a> {
        let cells = self.contestants.par_iter().enumerate().with_max_len(1).map(|(index, contestant)| {
            let cell = self.cell(&prepared, contestant, shares.get(index).copied().unwrap_or_default());
            tick();
            cell
        });
        let cells = cells.collect();
        (prepared, cells)
    }

    fn cell(&self, prepared: &Prepared, contestant: &Contestant, share: Share) -> Option<cell::Cell> {
        let cell = match &prepared.scene.only_for_stability {
            Some(reason) => cell::refused(prepared.scene, contestant, reason),
            None => self.measured(prepared, contestant, share)?,
        };
        Some(cell::Cell { verdicts: gates::judge(&cell.evidence, &self.baseline), ..cell })
    }

    /// Measured now, or by an earlier run. A cell is found by all that determines it but the baseline.
    fn measured(&self, prepared: &Prepared, contestant: &Contestant, share: Share) -> Option<cell::Cell> {
        let reference = prepared.reference.as_ref()?.as_ref().ok()?;
        let (scene, card) = (prepared.scene, &contestant.card);
        let bounds = Bounds { afforded: share.finest, ..(self.bounds)(&scene.name, card.name) };
        let key = (&scene.name, scene.content(), contestant.identity(), bounds, &card.claims, self.series);
        let measure = || cell::measure(scene, reference, contestant, bounds, self.series);
        let mut cell = journal::row(self.journal, &key, measure)?;
        if let Some(left_out) = &mut Arc::make_mut(&mut cell.evidence).left_out {
            left_out.seconds = to_digits(share.seconds, SECONDS_DIGITS);
        }
        Some(cell)
    }

    fn records(&self, scenes: Vec<Row>) -> Records {
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
