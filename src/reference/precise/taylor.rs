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

/// Steps after which their average tells the cost of the rest.
const ENOUGH: usize = 16;

/// The variables at increasing `times` [s], and the number of steps; given up where the steps so far tell that a run
/// would take more than `most_work` multiply-adds.
pub(super) fn along(
    problem: &Problem,
    times: &[f64],
    control: &Control,
    most_work: f64,
) -> Result<(Vec<Vec<DoubleDouble>>, usize), ReferenceError> {
    let order = control.order;
    let mut series = problem.tape.series(order);
    let (mut state, mut reached) = (problem.start.clone(), DoubleDouble::ZERO);
    let (mut states, mut steps) = (Vec::with_capacity(times.len()), 0);
    let work = (problem.tape.products() * order * order / 2).max(1) as f64;
    let last = times.last().map_or(0.0, |time| time / problem.scale.time);
    let mut wanted = times.iter().map(|time| time / problem.scale.time).peekable();
    while wanted.peek().is_some() {
        if interrupt::requested() {
            return Err(ReferenceError::Interrupted);
        }
        series.develop(&state);
        let norms = [order - 2, order - 1, order].map(|k| (k, series.largest(k, &problem.sizes)));
        let step = step(&norms, control);
        let seconds = reached.high * problem.scale.time;
        if !state.iter().all(|x| x.is_finite()) || step.is_nan() {
            return Err(ReferenceError::NotFinite { method: NAME, time: seconds });
        }
        let end = reached + step.into();
        let projected = if steps < ENOUGH { 0.0 } else { steps as f64 * work * last / reached.high };
        if end == reached || projected > most_work {
            let reason = format!("a step of {:e} s at order {order}", step * problem.scale.time);
            let (method, time, evaluations) = (NAME, seconds, steps);
            return Err(ReferenceError::NoConvergence { method, time, evaluations, reason });
        }
        while let Some(time) = wanted.next_if(|time| DoubleDouble::from(*time) <= end) {
            let mut shown = series.state(DoubleDouble::from(time) - reached);
            problem.normalize(&mut shown);
            states.push(shown);
        }
        state = series.state(step.into());
        problem.normalize(&mut state);
        (reached, steps) = (end, steps + 1);
    }
    Ok((states, steps))
}

/// (2), rounded to 24 bits so that times add up exactly.
fn step(norms: &[(usize, f64); 3], control: &Control) -> f64 {
    let of = |(k, norm): (usize, f64)| {
        if norm == 0.0 { LONGEST } else { (control.tolerance / norm).powf(1.0 / k as f64) }
    };
    let steps = norms.map(of);
    if steps.iter().any(|step| step.is_nan()) {
        return f64::NAN;
    }
    f64::from(steps.into_iter().fold(LONGEST, f64::min) as f32)
}
