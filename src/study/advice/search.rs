//! The search for the largest step that meets a tolerance.
//!
//! Errors do not fall evenly: a step may be lucky, its error small where two parts cancel, while one a little smaller is worse.
//! So a step is accepted only where
//!
//! 1. its error is below 0.8 of the tolerance, and
//! 2. so is that of every step of a grid of quarter halvings below it, down to half of it.
//!
//! The search halves the coarsest step until (1) and (2) hold, goes back up the grid while they do, and then bisects between
//! the last step that holds and the first that does not, to about a twentieth. Numbers of steps are multiples of the
//! [`SAMPLES`], so that every step divides the duration and all runs are seen at the same times.

use std::collections::BTreeMap;

use super::{Question, SAMPLES};
use crate::interrupt;
use crate::simulate::{Contestant, Form, Plan, Precision};

/// Part of the tolerance that an error may take.
pub const MARGIN: f64 = 0.8;
/// Part of the tolerance that may be the reference's own uncertainty.
pub const CLEAR: f64 = 0.1;
/// Most steps of a run, of one that chooses its own, and of a foreign program's.
const MOST_STEPS: u64 = 1 << 18;
const MOST_STEPS_IN_NAME: u64 = 1 << 14;
const MOST_FOREIGN_STEPS: u64 = 1 << 13;
/// Most steps in single precision: the roundings of so many steps add up to 1e-5 of the motion at least.
const MOST_STEPS_IN_SINGLE: u64 = 1 << 16;
/// Most steps times mass points of a scheme that runs on these alone: a tenth of a second.
const MOST_STEPS_OF_POINTS: u64 = 1 << 24;
/// Grid places of a halving.
const PLACES: u32 = 4;
/// Bisections of the last place.
const BISECTIONS: u32 = 2;

/// Why a scheme has no step.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Unmet {
    /// It cannot take the scene.
    #[error("{0}")]
    Refused(String),
    /// Every run broke.
    #[error("breaks: {0}")]
    Breaks(String),
    /// The steps ran out before the tolerance was met.
    #[error(
        "error {:.2e} at {} steps, the most that are tried; {asked:.2e} is asked, 0.8 of the tolerance",
        nearest.error,
        nearest.steps
    )]
    TooMany {
        /// The finest run.
        nearest: Nearest,
        /// The error that was asked for.
        asked: f64,
    },
    /// Smaller steps than that of the smallest error do worse.
    #[error(
        "error {:.2e} at best, at h = {:.3e} s ({} steps), and more at smaller steps; {asked:.2e} is asked, 0.8 of the tolerance",
        nearest.error,
        nearest.step,
        nearest.steps
    )]
    TooFine {
        /// The best run.
        nearest: Nearest,
        /// The error that was asked for.
        asked: f64,
    },
}

/// The run that comes nearest to a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Its largest error, in the unit of the quantity.
    pub error: f64,
    /// h [s].
    pub step: f64,
    /// Its steps.
    pub steps: u64,
}

impl Unmet {
    /// The run that comes nearest, where one came to its end.
    pub fn nearest(&self) -> Option<Nearest> {
        match self {
            Unmet::TooMany { nearest, .. } | Unmet::TooFine { nearest, .. } => Some(*nearest),
            Unmet::Refused(_) | Unmet::Breaks(_) => None,
        }
    }
}

/// A search with what it has found so far.
pub(super) struct Search<'a> {
    question: &'a Question,
    contestant: &'a Contestant,
    /// Error of each number of steps that was run; infinite where the run broke.
    errors: BTreeMap<u64, f64>,
    why_broken: Option<String>,
    most: u64,
}

impl<'a> Search<'a> {
    pub(super) fn new(question: &'a Question, contestant: &'a Contestant) -> Search<'a> {
        let points = question.system.body.points.len().max(1) as u64;
        let most = match contestant {
            _ if contestant.needs_points() => (MOST_STEPS_OF_POINTS / points).min(MOST_STEPS),
            _ if contestant.has_own_clock() => MOST_FOREIGN_STEPS,
            _ if contestant.chooses_steps() => MOST_STEPS_IN_NAME,
            _ if question.precision == Precision::F32 => MOST_STEPS_IN_SINGLE,
            _ => MOST_STEPS,
        };
        Search { question, contestant, errors: BTreeMap::new(), why_broken: None, most }
    }

    /// Steps of the largest step that holds.
    pub(super) fn largest_step(&mut self) -> Result<u64, Unmet> {
        let mut place = 0;
        while !self.holds_below(place) {
            place += PLACES;
            if grid(place + PLACES) > self.most || interrupt::requested() {
                return Err(self.unmet());
            }
        }
        while place > 0 && self.meets(grid(place - 1)) {
            place -= 1;
        }
        let (mut steps, mut fewer) = (grid(place), if place > 0 { grid(place - 1) } else { 0 });
        for _ in 0..BISECTIONS {
            let middle = rounded((steps + fewer) as f64 / 2.0);
            if fewer == 0 || middle <= fewer || middle >= steps {
                break;
            }
            if self.meets(middle) {
                steps = middle;
            } else {
                fewer = middle;
            }
        }
        Ok(steps)
    }

    /// Whether the tolerance is met at a place and at all below it down to half the step.
    fn holds_below(&mut self, place: u32) -> bool {
        // The two ends first: they decide most often.
        let ends = [place, place + PLACES];
        ends.into_iter().chain(place + 1..place + PLACES).all(|place| self.meets(grid(place)))
    }

    fn meets(&mut self, steps: u64) -> bool {
        self.error(steps) <= MARGIN * self.question.tolerance
    }

    fn error(&mut self, steps: u64) -> f64 {
        if let Some(error) = self.errors.get(&steps) {
            return *error;
        }
        let plan = Plan::over(self.question.duration, steps, SAMPLES as u64);
        let run = self.contestant.run(&self.question.system, Form::Least, &plan);
        let error = match &run.outcome.broken {
            None => Some(self.question.error(&run.states)).filter(|error| !error.is_nan()),
            Some(broken) => {
                self.why_broken = Some(broken.to_string());
                None
            }
        };
        let error = error.unwrap_or(f64::INFINITY);
        self.errors.insert(steps, error);
        error
    }

    fn unmet(&self) -> Unmet {
        let asked = MARGIN * self.question.tolerance;
        let nearest = |(steps, error): (u64, f64)| Nearest {
            error,
            step: self.question.duration / steps as f64,
            steps,
        };
        let runs = || self.errors.iter().map(|(steps, error)| (*steps, *error));
        let last = runs().next_back().unwrap_or((0, f64::INFINITY));
        let best = runs().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(last);
        match &self.why_broken {
            Some(why) if last.1.is_infinite() => Unmet::Breaks(why.clone()),
            _ if 2 * best.0 < last.0 => Unmet::TooFine { nearest: nearest(best), asked },
            _ => Unmet::TooMany { nearest: nearest(last), asked },
        }
    }
}

/// The number of steps at a place of the grid.
fn grid(place: u32) -> u64 {
    rounded(SAMPLES as f64 * 2f64.powf(f64::from(place) / f64::from(PLACES)))
}

/// The nearest multiple of the samples, one at least.
fn rounded(steps: f64) -> u64 {
    ((steps / SAMPLES as f64).round() as u64).max(1) * SAMPLES as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_of_steps_is_a_multiple_of_the_samples_and_halvings_are_exact() {
        for place in 0..60 {
            assert_eq!(grid(place) % SAMPLES as u64, 0);
            if place % PLACES == 0 {
                assert_eq!(grid(place), (SAMPLES as u64) << (place / PLACES));
            }
        }
    }
}
