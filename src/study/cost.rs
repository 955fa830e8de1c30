//! What a step costs, measured so that the number can be held against another from the same table.
//!
//! Blocks of steps of about 40 µs are timed in the process, by the clock that stands around the steps alone: the model is made
//! and states are looked at outside it, and the last state is an output that no compiler may leave out. All courses are
//! run round robin, a block each, so that whatever slows the machine slows all of them; of each the least block counts, since
//! nothing makes a block faster than it is. The first course runs a second time under the same conditions: how far the two
//! results are apart says what a difference between two others is worth.
//!
//! Nothing here decides a claim: steps and evaluations are counted, and only counts are judged.

use std::hint::black_box;

use crate::interrupt;
use crate::model::System;
use crate::simulate::{Contestant, Form, Outcome, Plan};

/// Length of a block [ns].
const BLOCK: f64 = 40e3;
/// Most steps of a block: the loop checks its state at about as many, and a block holds one check.
const MOST_STEPS: u64 = 1024;

/// A scheme in a scene, in a form, at a step.
#[derive(Clone, Copy)]
pub struct Course<'a> {
    /// The scheme.
    pub contestant: &'a Contestant,
    /// The scene.
    pub system: &'a System,
    /// The form of the scene.
    pub form: Form,
    /// h [s].
    pub step: f64,
    /// Time to spend in the steps of the course [s].
    pub seconds: f64,
}

/// What a step of a course costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// The least block [ns a step].
    pub nanoseconds_per_step: f64,
    /// The median block [ns a step].
    pub median_nanoseconds_per_step: f64,
    /// Evaluations of the forces a step, counted.
    pub evaluations_per_step: f64,
    /// Steps of a block.
    pub steps: u64,
    /// Blocks timed.
    pub blocks: usize,
    /// Time spent in them [s].
    pub seconds: f64,
}

/// A course while it is measured.
struct Runner<'a> {
    course: Course<'a>,
    steps: u64,
    /// Nanoseconds a step of every block.
    blocks: Vec<f64>,
    nanoseconds: f64,
    evaluations_per_step: f64,
}

impl<'a> Runner<'a> {
    /// Finds the number of steps of a block; `None` where the run breaks in it.
    fn new(course: Course<'a>) -> Option<Runner<'a>> {
        let mut steps = 1;
        loop {
            let outcome = block(&course, steps)?;
            let nanoseconds = outcome.nanoseconds as f64;
            if nanoseconds >= BLOCK / 2.0 || steps >= MOST_STEPS {
                let fitting = (steps as f64 * BLOCK / nanoseconds.max(1.0)).round();
                let steps = (fitting.max(1.0) as u64).min(MOST_STEPS);
                let outcome = block(&course, steps)?;
                let evaluations_per_step = outcome.evaluations as f64 / steps as f64;
                return Some(Runner {
                    course,
                    steps,
                    blocks: Vec::new(),
                    nanoseconds: 0.0,
                    evaluations_per_step,
                });
            }
            steps *= 2;
        }
    }

    fn is_done(&self) -> bool {
        self.nanoseconds >= self.course.seconds * 1e9
    }

    /// Times one block. A run that broke before would have broken in [`Runner::new`]: runs repeat to the last bit.
    fn time(&mut self) {
        let nanoseconds = block(&self.course, self.steps).map_or(f64::INFINITY, |o| o.nanoseconds as f64);
        self.blocks.push(nanoseconds / self.steps as f64);
        self.nanoseconds += nanoseconds;
    }

    fn cost(mut self) -> Option<Cost> {
        self.blocks.sort_by(f64::total_cmp);
        let least = self.blocks.first().copied().filter(|least| *least > 0.0 && least.is_finite())?;
        Some(Cost {
            nanoseconds_per_step: least,
            median_nanoseconds_per_step: self.blocks[self.blocks.len() / 2],
            evaluations_per_step: self.evaluations_per_step,
            steps: self.steps,
            blocks: self.blocks.len(),
            seconds: self.nanoseconds / 1e9,
        })
    }
}

/// Runs a block; `None` where it breaks.
fn block(course: &Course, steps: u64) -> Option<Outcome> {
    let plan = Plan { step: course.step, steps, every: steps };
    let outcome = course.contestant.stream(course.system, course.form, &plan, &mut |state| {
        black_box(state);
    });
    outcome.broken.is_none().then_some(outcome)
}

/// Measures courses, and the first of them again at the end of the list: one more result than there are courses. `None` for
/// a course whose run breaks within a block. To be called while nothing else runs.
pub fn measure(courses: &[Course]) -> Vec<Option<Cost>> {
    let mut runners: Vec<Option<Runner>> =
        courses.iter().chain(courses.first()).map(|course| Runner::new(*course)).collect();
    while !interrupt::requested() {
        let mut ran = false;
        for runner in runners.iter_mut().flatten().filter(|runner| !runner.is_done()) {
            runner.time();
            ran = true;
        }
        if !ran {
            break;
        }
    }
    runners.into_iter().map(|runner| runner.and_then(Runner::cost)).collect()
}

/// How far the two measurements of the first course are apart, relative to the first.
pub fn noise(costs: &[Option<Cost>]) -> Option<f64> {
    let [Some(first), .., Some(again)] = costs else { return None };
    Some((again.nanoseconds_per_step / first.nanoseconds_per_step - 1.0).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::Scene;
    use crate::schemes::{Euler, PeskinRk2};

    #[test]
    fn steps_and_evaluations_are_counted_exactly_and_the_first_course_comes_twice() {
        let system = Scene::find("kovalevskaya").expect("built in").system;
        let contestants = [Contestant::new(PeskinRk2), Contestant::new(Euler)];
        let courses: Vec<Course> = contestants
            .iter()
            .map(|contestant| Course {
                contestant,
                system: &system,
                form: Form::Least,
                step: 1e-3,
                seconds: 1e-3,
            })
            .collect();
        let costs: Vec<Cost> =
            measure(&courses).into_iter().map(|cost| cost.expect("no run breaks")).collect();
        assert_eq!(costs.len(), 3);
        assert_eq!(costs.iter().map(|cost| cost.evaluations_per_step).collect::<Vec<_>>(), [2.0, 1.0, 2.0]);
        for cost in costs {
            assert!(cost.nanoseconds_per_step > 0.0 && cost.nanoseconds_per_step.is_finite());
            assert!(cost.nanoseconds_per_step <= cost.median_nanoseconds_per_step);
            assert!(cost.blocks >= 1 && (1..=MOST_STEPS).contains(&cost.steps));
        }
    }

    #[test]
    fn a_course_that_breaks_has_no_cost_and_holds_up_no_other() {
        let system = Scene::find("kovalevskaya").expect("built in").system;
        let contestant = Contestant::new(PeskinRk2);
        let course =
            Course { contestant: &contestant, system: &system, form: Form::Least, step: 1e-3, seconds: 1e-4 };
        let costs = measure(&[course, Course { step: f64::MAX, ..course }]);
        assert!(costs[0].is_some() && costs[1].is_none() && costs[2].is_some());
    }
}
