//! A motion from jump to jump of its laws: each piece is analytic, and no step lies across a jump.

use super::problem::Problem;
use super::taylor::{self, Control, Course};
use crate::model::System;
use crate::model::forces::Forces;
use crate::ode::SolverError;

/// The variables at increasing `times` [s]; given up where a piece would take more than `most_work` multiply-adds.
pub(super) fn along(
    problem: &Problem,
    times: &[f64],
    control: &Control,
    most_work: f64,
) -> Result<Course, SolverError> {
    let pieces = problem.system().forces.pieces();
    if pieces.is_empty() {
        return taylor::along(problem, 0.0, times, control, most_work);
    }
    let mut whole = Course::default();
    let (mut state, mut start) = (problem.start.clone(), 0.0);
    for (end, forces) in pieces {
        let from = whole.states.len();
        let mut wanted: Vec<f64> = times[from..].iter().copied().take_while(|time| time <= end).collect();
        let shown = wanted.len();
        let goes_on = from + shown < times.len();
        if goes_on && wanted.last() != Some(end) {
            wanted.push(*end);
        }
        let system = within(problem.system(), forces);
        let course = taylor::along(&problem.of_piece(&system, &state), start, &wanted, control, most_work)?;
        whole.steps += course.steps;
        whole.switches += course.switches;
        if let Some(last) = course.states.last() {
            state.clone_from(last);
        }
        whole.states.extend(course.states.into_iter().take(shown));
        start = *end;
        if !goes_on {
            break;
        }
    }
    Ok(whole)
}

/// The same system under the laws of a piece.
fn within(system: &System, forces: &Forces) -> System {
    System { forces: forces.clone(), ..system.clone() }
}
