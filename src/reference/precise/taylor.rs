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
use super::stretch::{Stretch, Switch};
use super::tape::Series;
use crate::interrupt;
use crate::ode::SolverError;

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

/// The variables at increasing `times` [s], from a time on [s]; given up where the steps so far tell that a run would take more than
/// `most_work` multiply-adds.
pub(super) fn along(
    problem: &Problem,
    start: f64,
    times: &[f64],
    control: &Control,
    most_work: f64,
) -> Result<Course, SolverError> {
    let in_units = |time: &f64| time / problem.scale.time;
    let mut run = Run {
        problem,
        control,
        last: times.last().map_or(0.0, in_units),
        stretch: Stretch::new(problem, control.order),
        state: problem.start.clone(),
        reached: in_units(&start).into(),
        work: 0.0,
        standing: 0,
        course: Course::default(),
    };
    let mut wanted = times.iter().map(in_units).peekable();
    while wanted.peek().is_some() {
        if interrupt::requested() {
            return Err(SolverError::Interrupted);
        }
        let (stride, switch) = run.stride(most_work)?;
        let end = run.reached + stride;
        while let Some(time) = wanted.next_if(|time| DoubleDouble::from(*time) <= end) {
            let mut shown = run.stretch.series.state(DoubleDouble::from(time) - run.reached);
            problem.normalize(&mut shown);
            run.course.states.push(shown);
        }
        run.state = run.stretch.end(stride, switch);
        problem.normalize(&mut run.state);
        run.reached = end;
        run.course.steps += 1;
    }
    Ok(run.course)
}

/// A run on its way; times in units of the tape.
struct Run<'a> {
    problem: &'a Problem<'a>,
    control: &'a Control,
    last: f64,
    stretch: Stretch,
    state: Vec<DoubleDouble>,
    reached: DoubleDouble,
    /// Multiply-adds so far.
    work: f64,
    /// Steps in a row that took no time.
    standing: usize,
    course: Course,
}

impl Run<'_> {
    /// The next step, and what makes it end there.
    fn stride(&mut self, most_work: f64) -> Result<(DoubleDouble, Option<Switch>), SolverError> {
        let Some(switched) = self.stretch.develop(self.problem, &self.state) else {
            let contacts = self.stretch.contacts();
            return Err(self.given_up(format!("which of {contacts} points touch cannot be told")));
        };
        self.course.switches += switched;
        let step = step(&self.stretch.series, self.problem, self.control);
        let overflow = || SolverError::NotFinite { method: NAME, time: self.seconds() };
        if !self.state.iter().all(|x| x.is_finite()) || step.is_nan() {
            return Err(overflow());
        }
        let longest = step.min(self.last - self.reached.high);
        let switch = self.stretch.first_switch(longest).map_err(|_| overflow())?;
        let stride = switch.map_or(step.into(), |switch| switch.after);
        self.work += self.stretch.work();
        let rest = if self.course.steps < ENOUGH { 0.0 } else { self.last / self.reached.high };
        // Contacts that are made or lost at one moment, to a rounding, take no time.
        self.standing = if stride.high > STANDING * longest { 0 } else { self.standing + 1 };
        let stands = match switch {
            Some(_) => self.standing > 2 * self.stretch.contacts(),
            None => self.reached + stride == self.reached,
        };
        if stands || self.work * rest > most_work {
            let (seconds, order) = (stride.high * self.problem.scale.time, self.control.order);
            return Err(self.given_up(format!("a step of {seconds:e} s at order {order}")));
        }
        Ok((stride, switch))
    }

    fn seconds(&self) -> f64 {
        self.reached.high * self.problem.scale.time
    }

    fn given_up(&self, reason: String) -> SolverError {
        let (time, evaluations) = (self.seconds(), self.course.steps);
        SolverError::NoConvergence { method: NAME, time, evaluations, reason }
    }
}

/// Coefficients below this size lose digits of a double-double number to the end of its range.
const LOST: f64 = f64::MIN_POSITIVE / DoubleDouble::ROUNDING;

/// (2), rounded to 24 bits so that times add up exactly. Where the last coefficients have left the range of f64 the last one before them tells the
/// step. Those of a polynomial are zero, too, but after one that is not on its way there.
fn step(series: &Series, problem: &Problem, control: &Control) -> f64 {
    let order = control.order;
    let norm = |k: usize| (k, series.largest(k, &problem.sizes));
    let of = |(k, norm): (usize, f64)| {
        if norm == 0.0 { LONGEST } else { (control.tolerance / norm).powf(1.0 / k as f64) }
    };
    let last = [order - 2, order - 1, order].map(norm);
    let lost = last.iter().all(|(_, norm)| *norm < LOST);
    let before = || (1..order - 2).rev().map(norm).find(|(_, norm)| *norm > LOST);
    let leaving = if lost { before().filter(|(_, norm)| *norm < LOST.sqrt()) } else { None };
    let steps = if let Some(before) = leaving { [of(before); 3] } else { last.map(of) };
    if steps.iter().any(|step| step.is_nan()) {
        return f64::NAN;
    }
    f64::from(steps.into_iter().fold(LONGEST, f64::min) as f32)
}
