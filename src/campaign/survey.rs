//! All that a report shows: a campaign, and what is measured beside it.

use std::collections::HashMap;

#[cfg(feature = "cli")]
use rayon::prelude::*;

use super::motions::add_motions;
use super::reduction::add_reductions;
use super::rows::ranking_reads;
use super::scaling::{Sizes, add_scaling};
use super::{Campaign, SECONDS_A_COST, add_costs};
use crate::journal::Journal;
use crate::record::{Measurement, Records};
#[cfg(feature = "cli")]
use crate::record::{Request, stability::Map};
use crate::scenes::{self, Scene};
use crate::schemes;
use crate::simulate::Contestant;
#[cfg(feature = "cli")]
use crate::study::{precision, stability};

/// Scenes in which every scheme is measured: free, held at a point under gravity, and under springs.
const EVERY_SCHEME: [&str; 3] = ["free-asymmetric", "heavy-asymmetric-top", "tether-springs"];

/// Cells along either axis of a map of growth.
#[cfg(feature = "cli")]
const CELLS: usize = 32;

/// What a survey covers.
///
/// A campaign is the grid alone. A survey adds how foreign programs stand beside one another, what a step costs, what a reduction
/// saves and, where that is asked for, the schemes beside the main ones and how costs grow.
pub struct Survey<'a> {
    /// Scenes, in the order of the report.
    pub scenes: Vec<Scene>,
    /// Schemes, in the order of the report.
    pub contestants: Vec<Contestant>,
    /// Whether every scheme of the list is measured in three scenes, and all but the main ones stand apart: in rankings and
    /// tables of verdicts, not in pictures.
    pub every_scheme: bool,
    /// The sizes that costs are measured against.
    pub sizes: Option<Sizes>,
    /// Whether the numbers that others published are computed again.
    pub published: bool,
    /// Whether the main schemes are measured in single, double and double-double precision.
    pub precision: bool,
    /// Whether the growth of a small displacement is mapped over step and damping, for the main schemes.
    pub growth: bool,
    /// Whether steps are timed.
    pub timed: bool,
    /// Finished rows on disk, where they are kept. Times are measured anew.
    pub journal: Option<&'a Journal>,
    /// Called as (task, done, of all) after every piece of work.
    pub progress: &'a (dyn Fn(Task, usize, usize) + Sync),
}

/// What a survey is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Runs schemes in scenes and judges them.
    Measuring,
    /// Runs foreign programs and schemes at equal steps.
    Comparing,
    /// Times steps, on one thread.
    Timing,
}

impl Task {
    /// The task in one word.
    pub fn word(self) -> &'static str {
        match self {
            Task::Measuring => "measuring",
            Task::Comparing => "comparing",
            Task::Timing => "timing",
        }
    }
}

impl Survey<'_> {
    /// Schemes in scenes and nothing beside them.
    pub fn of(scenes: Vec<Scene>, contestants: Vec<Contestant>) -> Survey<'static> {
        Survey {
            scenes,
            contestants,
            every_scheme: false,
            sizes: None,
            published: false,
            precision: false,
            growth: false,
            timed: true,
            journal: None,
            progress: &|_, _, _| (),
        }
    }

    /// The main schemes in every built-in scene, all schemes in three of them, and how costs grow.
    pub fn standard() -> Survey<'static> {
        let grid = Survey::of(scenes::built_in(), Contestant::main());
        let sizes = Some(Sizes::Usual);
        Survey { every_scheme: true, sizes, published: true, precision: true, growth: true, ..grid }
    }

    /// Measures, judges, compares and times, or as much of it as there is time for.
    ///
    /// Steps are timed on one thread when all else is done: nothing may run beside a clock. Schemes that stand apart are not timed.
    pub fn run(&self) -> Records {
        let grid = Campaign::of(self.scenes.clone(), self.contestants.clone());
        let mut records = self.measure(Campaign { series: true, ..grid });
        if self.every_scheme {
            self.add_every_scheme(&mut records);
        }
        add_motions(&mut records, &self.scenes, &self.contestants, self.journal);
        self.add_peers(&mut records);
        self.add_published(&mut records);
        self.add_precision(&mut records);
        self.add_growth(&mut records);
        if self.timed {
            self.add_times(&mut records);
        }
        records
    }

    /// What is asked for, as a capsule has it.
    #[cfg(feature = "cli")]
    pub fn request(&self) -> Request {
        Request {
            schemes: self.contestants.iter().map(|one| one.card.name.to_owned()).collect(),
            every_scheme: self.every_scheme,
            published: self.published,
            precision: self.precision,
            growth: self.growth,
        }
    }

    fn measure(&self, grid: Campaign) -> Records {
        let progress = |done, all| (self.progress)(Task::Measuring, done, all);
        Campaign { progress: &progress, journal: self.journal, ..grid }.run()
    }

    /// The schemes that the grid does not have, in the scenes of every scheme.
    fn add_every_scheme(&self, records: &mut Records) {
        let given = |other: &Contestant| self.contestants.iter().any(|own| own.card.name == other.card.name);
        let others: Vec<Contestant> = Contestant::everyone().into_iter().filter(|one| !given(one)).collect();
        if !others.is_empty() {
            let scenes = EVERY_SCHEME.iter().filter_map(|name| Scene::find(name).ok()).collect();
            let mut measured = self.measure(Campaign::of(scenes, others));
            shorten(&mut measured);
            records.take_in(measured);
        }
        for row in &mut records.schemes {
            row.apart = !schemes::MAIN.contains(&row.name.as_str());
        }
    }

    /// Foreign programs are run with the feature `cli`.
    #[cfg(not(feature = "cli"))]
    fn add_peers(&self, _: &mut Records) {}

    #[cfg(feature = "cli")]
    fn add_peers(&self, records: &mut Records) {
        let progress = |done, all| (self.progress)(Task::Comparing, done, all);
        super::add_peers(records, &self.scenes, &self.contestants, self.journal, &progress);
    }

    /// Published numbers are computed with the feature `cli`.
    #[cfg(not(feature = "cli"))]
    fn add_published(&self, _: &mut Records) {}

    /// What was measured is worth more than what is missing: where a published scene cannot be solved the records are not complete.
    #[cfg(feature = "cli")]
    fn add_published(&self, records: &mut Records) {
        if self.published {
            match crate::study::published::rows(self.journal) {
                Ok(rows) => records.published = rows,
                Err(_) => records.complete = false,
            }
        }
    }

    /// Precision is studied with the feature `cli`.
    #[cfg(not(feature = "cli"))]
    fn add_precision(&self, _: &mut Records) {}

    #[cfg(feature = "cli")]
    fn add_precision(&self, records: &mut Records) {
        if !self.precision {
            return;
        }
        let contestants = self.main();
        let scenes = precision::SCENES.iter().filter_map(|name| Scene::find(name).ok()).collect();
        match precision::rows(scenes, &contestants, self.journal) {
            Ok(rows) => records.precision = rows,
            Err(_) => records.complete = false,
        }
    }

    /// Growth is mapped with the feature `cli`.
    #[cfg(not(feature = "cli"))]
    fn add_growth(&self, _: &mut Records) {}

    #[cfg(feature = "cli")]
    fn add_growth(&self, records: &mut Records) {
        if self.growth {
            let map = |one: &Contestant| stability::growth(one, CELLS).map(Map::rounded);
            records.maps = self.main().par_iter().filter_map(map).collect();
        }
    }

    /// The main schemes among those of the grid.
    #[cfg(feature = "cli")]
    fn main(&self) -> Vec<Contestant> {
        let is_main = |one: &&Contestant| schemes::MAIN.contains(&one.card.name);
        self.contestants.iter().filter(is_main).cloned().collect()
    }

    fn add_times(&self, records: &mut Records) {
        let tell = |done| (self.progress)(Task::Timing, done, 3);
        tell(0);
        add_costs(records, &self.scenes, &self.contestants, SECONDS_A_COST);
        tell(1);
        add_reductions(records, &self.scenes);
        tell(2);
        if let Some(sizes) = self.sizes {
            add_scaling(records, sizes);
        }
        tell(3);
    }
}

/// Leaves of the schemes beside the main ones the errors that rankings read, and the others at the finest step, the last of its ladder.
fn shorten(records: &mut Records) {
    let key = |row: &Measurement| (row.scene.clone(), row.scheme.clone(), row.metric.clone());
    let last: HashMap<_, usize> =
        records.measurements.iter().enumerate().map(|(index, row)| (key(row), index)).collect();
    let mut index = 0;
    records.measurements.retain(|row| {
        let kept = ranking_reads(&row.metric) || last.get(&key(row)) == Some(&index);
        index += 1;
        kept
    });
}
