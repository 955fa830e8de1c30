//! Where methods fail: the largest usable step, how a scheme fails above it, and maps of both over two parameters.
//!
//! | file | what |
//! |---|---|
//! | `failure` | the classes of failure |
//! | `truth` | the motion that runs are held against |
//! | `trial` | one run, judged |
//! | `search` | the largest usable step |
//! | `bench` | the spring-held body at rest: linear stability, measured |
//! | `theory`, `amplification` | linear stability, computed; laws of energy, of sleeping and of flipping |
//! | `maps` | heat maps over two parameters |
//! | `long_run` | runs of very many steps |
//! | `kink` | the order across a bounce |
//! | `fails_where` | one line a scheme |
//!
//! A run that fails is a row or a cell like any other: nothing here ends because a scheme does.

mod amplification;
mod bench;
mod fails_where;
mod failure;
mod kink;
mod long_run;
mod maps;
mod search;
pub mod theory;
mod trial;
mod truth;

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::interrupt;
use crate::journal::{self, Journal};
use crate::record::stability::{FailsWhere, Limit, LinearLimit, SCHEMA, Stability};
use crate::reference::ReferenceError;
use crate::scenes::Scene;
use crate::simulate::Contestant;

pub use crate::record::stability::Meaning;
pub use bench::{Bench, Growth, NO_GROWTH};
pub use fails_where::{SCENES as LINE_SCENES, line};
pub use failure::{Axis, Failure};
pub use kink::kink_order;
pub use long_run::{energy_law, long_run};
pub use maps::{NAMES as MAP_NAMES, growth, map};
pub use search::limits;
pub use trial::{BOUNDED, ENERGY_KEPT, ORIENTATION_KEPT, Trial, attempt};
pub use truth::Truth;

/// Scenes with the spring-held body, the damped one first: a scheme that takes no damper is measured without it.
pub const LINEAR_SCENES: [&str; 2] = ["lagrange-top-pivot-spring", "lagrange-top-pivot-spring-undamped"];

/// What a study covers.
pub struct Study<'a> {
    /// Scenes whose largest usable steps are searched.
    pub scenes: Vec<Scene>,
    /// Schemes.
    pub contestants: Vec<Contestant>,
    /// Maps to draw: each by name, with its scheme.
    pub maps: Vec<(&'static str, Contestant)>,
    /// Cells along either axis of a map.
    pub cells: usize,
    /// Schemes of the long runs, …
    pub long: Vec<Contestant>,
    /// … and their steps.
    pub long_steps: u64,
    /// Finished rows on disk, where they are kept.
    pub journal: Option<&'a Journal>,
    /// Called as (done, of all) after every piece of work.
    pub progress: &'a (dyn Fn(usize, usize) + Sync),
}

impl Study<'_> {
    /// Measures all of it, or what there was time for. Machine and time of writing are the caller's to fill in.
    pub fn run(&self) -> Stability {
        let all = self.scenes.len() * (self.contestants.len() + 1)
            + self.contestants.len()
            + self.maps.len()
            + 2 * self.long.len();
        let done = AtomicUsize::new(0);
        let tick = || (self.progress)(done.fetch_add(1, Ordering::Relaxed) + 1, all);
        let limits = self.limits(&tick);
        let linear = self.linear(&tick);
        // A line is made of all the limits of a scheme.
        let whole = !interrupt::requested();
        let fails_where = if whole { self.lines(&limits, &linear) } else { Vec::new() };
        let mut study = Stability {
            schema: SCHEMA.to_owned(),
            polhode: env!("CARGO_PKG_VERSION").to_owned(),
            limits,
            linear,
            fails_where,
            ..Stability::default()
        };
        for (name, contestant) in &self.maps {
            let key = ("map", name, contestant.identity(), self.cells);
            study
                .maps
                .extend(journal::row(self.journal, &key, || map(name, contestant, self.cells)).flatten());
            tick();
        }
        self.run_long(&mut study, &tick);
        study.complete = !interrupt::requested();
        study
    }

    fn linear(&self, tick: &(dyn Fn() + Sync)) -> Vec<LinearLimit> {
        let rows = self.contestants.par_iter().filter_map(|contestant| {
            let key = ("linear", contestant.identity());
            let row = journal::row(self.journal, &key, || linear_limit(contestant)).flatten();
            tick();
            row
        });
        rows.collect()
    }

    fn lines(&self, limits: &[Limit], linear: &[LinearLimit]) -> Vec<FailsWhere> {
        let one = |contestant: &Contestant| {
            let scheme = contestant.card.name;
            Some(FailsWhere { scheme: scheme.to_owned(), line: line(scheme, limits, linear)? })
        };
        self.contestants.iter().filter_map(one).collect()
    }

    fn limits(&self, tick: &(dyn Fn() + Sync)) -> Vec<Limit> {
        let truths: Vec<_> = self
            .scenes
            .par_iter()
            .map(|scene| {
                let truth = (!interrupt::requested()).then(|| Truth::of(scene));
                tick();
                truth
            })
            .collect();
        let cells: Vec<_> = self
            .scenes
            .iter()
            .zip(&truths)
            .flat_map(|(scene, truth)| self.contestants.iter().map(move |c| (scene, truth, c)))
            .collect();
        let rows = cells.par_iter().filter_map(|(scene, truth, contestant)| {
            let measure = |truth: &Result<Truth, ReferenceError>| match truth {
                Ok(truth) => search::limits(&scene.name, contestant, truth),
                Err(error) => search::without_truth(&scene.name, contestant, &error.to_string()),
            };
            let key = ("limits", &scene.name, scene.content(), contestant.identity());
            let rows = truth.as_ref().and_then(|truth| journal::row(self.journal, &key, || measure(truth)));
            tick();
            rows
        });
        rows.collect::<Vec<_>>().concat()
    }

    fn run_long(&self, study: &mut Stability, tick: &(dyn Fn() + Sync)) {
        if self.long.is_empty() || interrupt::requested() {
            return;
        }
        let cells: Vec<_> =
            long_run::SCENES.iter().flat_map(|scene| self.long.iter().map(move |c| (*scene, c))).collect();
        let runs = cells.par_iter().filter_map(|(scene, contestant)| {
            let key = ("long run", scene, contestant.identity(), self.long_steps);
            let row =
                journal::row(self.journal, &key, || long_run(scene, contestant, self.long_steps)).flatten();
            tick();
            row
        });
        study.long_runs = runs.collect();
        study.energy_law = journal::row(self.journal, &"energy law", energy_law).unwrap_or_default();
        let kinks = self.long.iter().filter_map(|contestant| {
            journal::row(self.journal, &("kink", contestant.identity()), || kink_order(contestant))
        });
        study.kink_orders = kinks.collect();
    }
}

/// The linear limit of a scheme, on the damped body or else on the undamped one; `None` where it takes neither.
pub fn linear_limit(contestant: &Contestant) -> Option<LinearLimit> {
    LINEAR_SCENES.iter().find_map(|name| {
        let scene = Scene::find(name).ok()?;
        linear_limit_in(name, &Bench::of(&scene.system)?, contestant)
    })
}

/// The linear limit of a scheme on the spring-held body of a scene; `None` where it cannot take it.
pub fn linear_limit_in(scene: &str, bench: &Bench, contestant: &Contestant) -> Option<LinearLimit> {
    if contestant.refusal(&bench.system).is_some() || contestant.is_foreign() {
        return None;
    }
    let scheme = contestant.card.name;
    let (h_omega, above) = bench.limit(contestant);
    let theory = theory::limit_of_a_body(bench.zeta, contestant, NO_GROWTH);
    let failure = match &above {
        None => "stable at every step tried".to_owned(),
        Some(Growth::Rate(_)) => "energy grows".to_owned(),
        Some(Growth::Broke(failure)) => failure.class().to_owned(),
    };
    Some(LinearLimit {
        scheme: scheme.to_owned(),
        scene: scene.to_owned(),
        omega_rad_s: bench.omega,
        zeta: bench.zeta,
        h_omega,
        theory_h_omega: theory.map(|(a, _)| a),
        theory: theory.map(|(_, amplification)| amplification.words()),
        failure,
        growth_per_step: match above {
            Some(Growth::Rate(rate)) if rate.is_finite() => Some(rate),
            _ => None,
        },
    })
}
