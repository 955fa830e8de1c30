//! The states that the figures of a problem are read from.

use super::PublishedError;
use super::data::{Figure, Problem};
use crate::model::Snapshot;
use crate::reference::precise::{self, AFFORDABLE};
use crate::scenes::Scene;
use crate::schemes::AdamsBashforthBody;
use crate::simulate::{Contestant, Form, Plan};

/// Multiply-adds of a truth: a hundred seconds of an asteroid's years, at most.
const MOST_WORK: f64 = 10.0 * AFFORDABLE;

/// A scene, and its truth at the times of the figures.
pub(super) struct Motion<'a> {
    pub scene: &'a Scene,
    truth: Vec<Snapshot>,
}

impl<'a> Motion<'a> {
    /// Solves the truth once for every time that a figure names.
    pub fn of(scene: &'a Scene, problem: &Problem) -> Result<Motion<'a>, PublishedError> {
        let mut times: Vec<f64> = problem.figures.iter().map(|figure| figure.time).chain([0.0]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        Ok(Motion { scene, truth: truth_at(scene, &times)? })
    }

    /// The truth at the start.
    pub fn start(&self) -> &Snapshot {
        &self.truth[0]
    }

    /// The truth at a figure's time.
    pub fn truth(&self, figure: &Figure) -> Result<&Snapshot, PublishedError> {
        self.truth
            .iter()
            .find(|state| state.time == figure.time)
            .ok_or_else(|| self.missing(figure, "its time is not among those of the truth"))
    }

    /// The state at a figure's time by whom it names.
    pub fn state(&self, figure: &Figure) -> Result<Snapshot, PublishedError> {
        if figure.scheme.is_none() {
            return Ok(*self.truth(figure)?);
        }
        let states = self.run(figure, figure.steps)?;
        states.last().copied().ok_or_else(|| self.missing(figure, "its run has no states"))
    }

    /// The states of a figure's run, the first, every so many steps, and the last.
    pub fn run(&self, figure: &Figure, every: u64) -> Result<Vec<Snapshot>, PublishedError> {
        let name = figure.scheme.as_deref().unwrap_or_default();
        let beside_the_list = Contestant::turning(AdamsBashforthBody::FIVE);
        let contestant = Contestant::all()
            .into_iter()
            .chain([beside_the_list])
            .find(|contestant| contestant.card.name == name)
            .ok_or_else(|| self.missing(figure, "it needs a scheme of the list"))?;
        let plan = Plan { step: figure.time / figure.steps as f64, steps: figure.steps, every };
        let trajectory = contestant.run(&self.scene.system, Form::Least, &plan);
        match trajectory.outcome.broken {
            None => Ok(trajectory.states),
            Some(why) => {
                Err(PublishedError::Broken { scene: self.scene.name.clone(), scheme: name.to_owned(), why })
            }
        }
    }

    pub fn missing(&self, figure: &Figure, why: &'static str) -> PublishedError {
        PublishedError::Figure { scene: self.scene.name.clone(), quantity: figure.quantity.clone(), why }
    }
}

/// The truth of a scene at increasing times [s].
pub(super) fn truth_at(scene: &Scene, times: &[f64]) -> Result<Vec<Snapshot>, PublishedError> {
    let motion = precise::solve(&scene.system, times, MOST_WORK)
        .map_err(|source| PublishedError::Truth { scene: scene.name.clone(), source })?;
    Ok(motion.moments.iter().map(precise::Moment::snapshot).collect())
}
