//! Which scheme, which step, at what cost: the largest step of each scheme whose error stays below a tolerance.
//!
//! The error is the largest of the run at sixteen equal distances, not the one at the end, which can be small by luck; and a
//! step counts only if the steps below it are as good, down to half of it (see [`search`]). What was found is a run
//! that was made: every number of the table is measured at that step, nothing is read off a slope.

pub mod search;

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::measure::{self, Sight};
use crate::model::{Quantity, Snapshot, System};
use crate::reference::{Reference, ReferenceError, stored};
use crate::rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form, Plan, Precision};
use crate::study::cost::{self, Course};

use search::{Search, Unmet};

/// Distances of the run at whose ends the error is taken; every step found divides each of them.
pub const SAMPLES: usize = 16;
/// Time that each scheme is timed for [s].
const SECONDS_A_COST: f64 = 0.05;
/// Most steps that [`Question::at_step`] runs: a second of time for the cheapest schemes.
const MOST_STEPS: f64 = 1e6;
/// Durations that a run must hold out to be called stable …
const LONG: u64 = 4;
/// … and how many times the kinetic energy of a run at half the step it may reach on the way.
const ENERGY_FACTOR: f64 = 2.0;

/// What is asked.
#[derive(Clone, Debug)]
pub struct Question {
    /// The body under its forces.
    pub system: System,
    /// The run [s].
    pub duration: f64,
    /// What must be right.
    pub quantity: Quantity,
    /// Its largest error over the run, in its unit.
    pub tolerance: f64,
    /// Arithmetic of the runs.
    pub precision: Precision,
    reference: Reference,
}

/// A question that cannot be answered.
#[derive(Debug, thiserror::Error)]
pub enum QuestionError {
    /// No reference.
    #[error("there is no reference to measure errors against: {0}")]
    Reference(#[from] ReferenceError),
    /// The reference does not know the motion well enough.
    #[error(
        "the motion itself is known to {uncertainty:.1e} {unit} only, which cannot decide a tolerance of {tolerance:e} {unit}: \
         ask for {least:.1e} {unit} or more, or for a shorter duration"
    )]
    TooFine {
        /// What was asked for.
        tolerance: f64,
        /// Uncertainty of the reference.
        uncertainty: f64,
        /// The smallest tolerance that can be decided.
        least: f64,
        /// Unit of all three.
        unit: &'static str,
    },
}

/// The answers, and what the order of two costs is worth.
#[derive(Clone, Debug)]
pub struct Answers {
    /// One a scheme: those with a step first, the cheapest at the head; then the others, the nearest to the tolerance at the head.
    pub answers: Vec<Answer>,
    /// How far two measurements of the same cost were apart, relative; `None` where nothing was timed.
    pub noise: Option<f64>,
}

/// The answer for one scheme.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Name of the scheme.
    pub scheme: &'static str,
    /// The step, or why there is none.
    pub found: Result<Advice, Unmet>,
}

/// A step that meets the tolerance.
#[derive(Clone, Debug)]
pub struct Advice {
    /// h [s].
    pub step: f64,
    /// Steps of the duration.
    pub steps: u64,
    /// Largest error over the run, in the unit of the quantity.
    pub error: f64,
    /// Most radians turned in a step.
    pub turned: f64,
    /// Evaluations of the forces a simulated second.
    pub evaluations: f64,
    /// Cost of a simulated second [ns]; `None` where it was not timed.
    pub nanoseconds: Option<f64>,
    /// Energy at the end over that of the reference, less one: their difference over the largest kinetic energy.
    pub energy: f64,
    /// Whether a run of four durations does not break, nor reach twice the kinetic energy of one at half the step.
    pub stable: bool,
    /// Whether the scheme chooses its own steps: the step then stands for a tolerance of its own.
    pub own_steps: bool,
}

impl Question {
    /// A question about a scene.
    ///
    /// # Errors
    /// [`QuestionError`]: no reference, or one that is not good enough.
    pub fn new(
        scene: &Scene,
        duration: f64,
        quantity: Quantity,
        tolerance: f64,
    ) -> Result<Question, QuestionError> {
        let known = if scene.built_in && duration == scene.duration {
            stored::find(&scene.name).map_err(ReferenceError::from)?
        } else {
            None
        };
        let reference = Reference::of(&scene.system, duration, SAMPLES, known.as_ref())?;
        let uncertainty = reference.largest_uncertainty()[quantity];
        let least = uncertainty / search::CLEAR;
        if tolerance < least {
            let unit = quantity.unit();
            return Err(QuestionError::TooFine { tolerance, uncertainty, least, unit });
        }
        Ok(Question {
            system: scene.system.clone(),
            duration,
            quantity,
            tolerance,
            precision: Precision::F64,
            reference,
        })
    }

    /// The same question, of runs in an arithmetic.
    #[must_use]
    pub fn at(self, precision: Precision) -> Question {
        Question { precision, ..self }
    }

    /// Asks every scheme, in parallel; then times those that meet the tolerance, alone. `progress` is called with the schemes that have
    /// answered and the schemes in all.
    pub fn ask(&self, contestants: &[Contestant], progress: &(dyn Fn(usize, usize) + Sync)) -> Answers {
        let own: Vec<Contestant> = contestants.iter().filter_map(|one| one.at(self.precision)).collect();
        let done = AtomicUsize::new(0);
        let answer = |contestant: &Contestant| {
            let found = self.ask_one(contestant);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, own.len());
            Answer { scheme: contestant.card.name, found }
        };
        let mut answers: Vec<Answer> = own.par_iter().map(answer).collect();
        let noise = self.time(&own, &mut answers);
        let refused = contestants.iter().filter(|one| one.at(self.precision).is_none());
        answers.extend(refused.map(|one| Answer {
            scheme: one.card.name,
            found: Err(Unmet::Refused(format!("runs in {} only", Precision::F64.name()))),
        }));
        let key = |answer: &Answer| match &answer.found {
            Ok(advice) => (false, advice.nanoseconds.unwrap_or(f64::MAX)),
            Err(unmet) => (true, unmet.nearest().map_or(f64::INFINITY, |nearest| nearest.error)),
        };
        answers.sort_by(|a, b| {
            let (a, b) = (key(a), key(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        Answers { answers, noise }
    }

    /// The run of a plan: the largest error of the quantity; infinite where the run breaks.
    fn error(&self, states: &[Snapshot]) -> f64 {
        let sight = Sight { system: &self.system, reference: &self.reference, states };
        measure::errors(&sight)[self.quantity].max
    }

    fn ask_one(&self, contestant: &Contestant) -> Result<Advice, Unmet> {
        if let Some(reason) = contestant.refusal(&self.system) {
            return Err(Unmet::Refused(reason.into_owned()));
        }
        let steps = Search::new(self, contestant).largest_step()?;
        Ok(self.in_steps(contestant, steps))
    }

    /// What a scheme does at a step near `step` [s], whether or not it meets the tolerance: the duration in a multiple of
    /// [`SAMPLES`] steps, the next larger one.
    ///
    /// # Errors
    /// [`Unmet::Refused`].
    pub fn at_step(&self, contestant: &Contestant, step: f64) -> Result<Advice, Unmet> {
        if let Some(reason) = contestant.refusal(&self.system) {
            return Err(Unmet::Refused(reason.into_owned()));
        }
        let samples = SAMPLES as f64;
        let steps = (self.duration / step / samples).ceil() * samples;
        if !(steps >= samples && steps <= MOST_STEPS) {
            return Err(Unmet::Refused(format!("{steps:.1e} steps of {step:e} s are not run here")));
        }
        Ok(self.in_steps(contestant, steps as u64))
    }

    fn in_steps(&self, contestant: &Contestant, steps: u64) -> Advice {
        let plan = Plan::over(self.duration, steps, SAMPLES as u64);
        let run = contestant.run(&self.system, Form::Least, &plan);
        let spins = self.reference.states.iter().map(|s| rotation::length(&s.angular_velocity));
        Advice {
            step: plan.step,
            steps,
            error: self.error(&run.states),
            turned: spins.fold(0.0, f64::max) * plan.step,
            evaluations: run.outcome.evaluations as f64 / self.duration,
            nanoseconds: contestant.is_foreign().then(|| run.outcome.nanoseconds as f64 / self.duration),
            energy: self.energy_error(&run.states),
            stable: self.is_stable(contestant, &plan),
            own_steps: contestant.chooses_steps(),
        }
    }

    /// Energy of the last state against the reference's, over the largest kinetic energy of the motion.
    fn energy_error(&self, states: &[Snapshot]) -> f64 {
        let total = |state: &Snapshot| {
            self.system.kinetic_energy(state) + self.system.potential_energy(state).unwrap_or(0.0)
        };
        let largest =
            self.reference.states.iter().map(|state| self.system.kinetic_energy(state)).fold(0.0, f64::max);
        let (Some(end), Some(truth)) = (states.last(), self.reference.states.last()) else { return 0.0 };
        if largest > 0.0 { (total(end) - total(truth)) / largest } else { 0.0 }
    }

    fn is_stable(&self, contestant: &Contestant, plan: &Plan) -> bool {
        let largest = |halving: u64| {
            let steps = plan.steps * LONG * halving;
            let plan = Plan::over(self.duration * LONG as f64, steps, SAMPLES as u64 * LONG);
            let mut largest: f64 = 0.0;
            let outcome = contestant.stream(&self.system, Form::Least, &plan, &mut |state| {
                largest = largest.max(self.system.kinetic_energy(state));
            });
            outcome.broken.is_none().then_some(largest)
        };
        largest(1).zip(largest(2)).is_some_and(|(at, below)| at <= ENERGY_FACTOR * below)
    }

    /// Times what was found; returns how far two measurements of the first were apart.
    fn time(&self, contestants: &[Contestant], answers: &mut [Answer]) -> Option<f64> {
        let mut timed: Vec<(&Contestant, &mut Advice)> = contestants
            .iter()
            .zip(answers)
            .filter_map(|(contestant, answer)| Some((contestant, answer.found.as_mut().ok()?)))
            .filter(|(contestant, _)| !contestant.has_own_clock())
            .collect();
        let courses: Vec<Course> = timed
            .iter()
            .map(|(contestant, advice)| Course {
                contestant,
                system: &self.system,
                form: Form::Least,
                step: advice.step,
                seconds: SECONDS_A_COST,
            })
            .collect();
        let costs = cost::measure(&courses);
        for ((_, advice), cost) in timed.iter_mut().zip(&costs) {
            advice.nanoseconds = cost.map(|cost| cost.nanoseconds_per_step / advice.step);
        }
        cost::noise(&costs)
    }
}
