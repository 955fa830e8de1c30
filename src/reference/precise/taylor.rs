//! Taylor's method of any order, with the step from its last coefficients.
//!
//! ```text
//! (1) y(t + s) = Σ_{k ≤ p} yₖ sᵏ
//! (2) h = min_{k = p−2 … p} (tolerance / |yₖ|)^{1/k},  |·| the largest entry over its size
//! ```
//!
//! The first term left out is then about tolerance times h over the radius of convergence, which is e⁻² at the order
//! that costs least, p = −½ ln tolerance. States between steps come from the polynomial of the step: nothing is
//! interpolated, and no step is cut short but the last.
//!
//! Source: jorba2005, section 3.

use super::double_double::DoubleDouble;
use super::problem::Problem;
use super::stretch::Stretch;
use super::tape::Series;
use crate::interrupt;
use crate::reference::ReferenceError;

/// Name in messages.
const NAME: &str = "taylor";

/// Longest step, in units of the scene: of a motion that is a polynomial.
const LONGEST: f64 = 1e30;

/// How a run is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Control {
    /// p.
    pub order: usize,
    /// Largest of the last terms, over the sizes of the variables.
    pub tolerance: f64,
}

/// Part of a step that is no time at all.
const STANDING: f64 = 1e-24;

/// Steps after which their average tells the cost of the rest.
const ENOUGH: usize = 16;

/// The variables at the times of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Course {
    pub states: Vec<Vec<DoubleDouble>>,
    pub steps: usize,
    /// Contacts made or lost.
    pub switches: usize,
}

/// The variables at increasing `times` [s]; given up where the steps so far tell that a run would take more than
/// `most_work` multiply-adds.
pub(super) fn along(
    problem: &Problem,
    times: &[f64],
    control: &Control,
    most_work: f64,
) -> Result<Course, ReferenceError> {
    let mut stretch = Stretch::new(problem, control.order);
    let (mut state, mut reached) = (problem.start.clone(), DoubleDouble::ZERO);
    let (mut course, mut work, mut standing) = (Course::default(), 0.0, 0);
    let last = times.last().map_or(0.0, |time| time / problem.scale.time);
    let mut wanted = times.iter().map(|time| time / problem.scale.time).peekable();
    while wanted.peek().is_some() {
        if interrupt::requested() {
            return Err(ReferenceError::Interrupted);
        }
        let time = reached.high * problem.scale.time;
        let given_up = |reason: String| ReferenceError::NoConvergence {
            method: NAME,
            time,
            evaluations: course.steps,
            reason,
        };
        let switched = stretch.develop(problem, &state);
        let undecided = || given_up(format!("which of {} points touch cannot be told", stretch.contacts()));
        course.switches += switched.ok_or_else(undecided)?;
        let step = step(&stretch.series, problem, control);
        if !state.iter().all(|x| x.is_finite()) || step.is_nan() {
            return Err(ReferenceError::NotFinite { method: NAME, time });
        }
        let switch = stretch.first_switch(step.min(last - reached.high));
        let stride = switch.map_or(step.into(), |switch| switch.after);
        let end = reached + stride;
        work += stretch.work();
        let projected = if course.steps < ENOUGH { 0.0 } else { work * last / reached.high };
        // Contacts that are made or lost at one moment, to a rounding, take no time.
        standing = if stride.high > STANDING * step { 0 } else { standing + 1 };
        if end == reached && switch.is_none() || standing > 2 * stretch.contacts() || projected > most_work {
            let seconds = stride.high * problem.scale.time;
            return Err(given_up(format!("a step of {seconds:e} s at order {}", control.order)));
        }
        while let Some(time) = wanted.next_if(|time| DoubleDouble::from(*time) <= end) {
            let mut shown = stretch.series.state(DoubleDouble::from(time) - reached);
            problem.normalize(&mut shown);
            course.states.push(shown);
        }
        state = stretch.end(stride, switch);
        problem.normalize(&mut state);
        (reached, course.steps) = (end, course.steps + 1);
    }
    Ok(course)
}

/// (2), rounded to 24 bits so that times add up exactly.
fn step(series: &Series, problem: &Problem, control: &Control) -> f64 {
    let order = control.order;
    let norms = [order - 2, order - 1, order].map(|k| (k, series.largest(k, &problem.sizes)));
    let of = |(k, norm): (usize, f64)| {
        if norm == 0.0 { LONGEST } else { (control.tolerance / norm).powf(1.0 / k as f64) }
    };
    let steps = norms.map(of);
    if steps.iter().any(|step| step.is_nan()) {
        return f64::NAN;
    }
    f64::from(steps.into_iter().fold(LONGEST, f64::min) as f32)
}
