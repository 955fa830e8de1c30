//! A Taylor series method for every smooth law and a pivot: order and step follow from the tolerance.
//!
//! With ε the tolerance, x_k the coefficients of order k of a step, each part over its size,
//!
//! ```text
//! (1)  p = ⌈1 − ½ ln ε⌉
//! (2)  h = min (ε/‖x_j‖)^(1/j)   over the last two orders j = p − 1, p
//! (3)  x(t + h) = Σ x_k hᵏ
//! ```
//!
//! (1) makes the cost over a stretch of time least where a coefficient costs as much as its order. (2) makes the last two terms ε; the first
//! one that is left out is smaller. Stored times do not cut steps: the polynomial of a step is evaluated at each of them.
//! A coefficient of order k sums k + 1 products where the equations have one, and counts as so many evaluations.
//!
//! Source: jorba2005, sections 3.1 and 3.2. The recurrences are written for these equations ([`equations`]) and laws ([`loads`]); a law with a
//! kink has no series and is refused.

mod equations;
mod fields;
mod loads;
mod pulls;
mod series;

use crate::arithmetic::{Registers, Row, Work};
use crate::interrupt;
use crate::model::System;
use crate::ode::SolverError;
use crate::ode::run::{self, MOST_EVALUATIONS, Run};
use crate::ode::units::Units;
use equations::{Expansion, MOVING, TURNING};
use series::CAPACITY;

const NAME: &str = "taylor";

/// Least order: below, the last two coefficients say nothing of a radius of convergence.
const LEAST_ORDER: usize = 3;

/// Why the method cannot take a system, if it cannot.
pub fn refusal(system: &System) -> Option<String> {
    let law = system.forces.laws().iter().find(|law| law.has_kink())?;
    Some(format!("the law {} has a kink or a jump, and no Taylor series there", law.name()))
}

/// The states at increasing `times` [s], from t = 0 on.
///
/// # Errors
/// [`SolverError`]: times that do not increase, a state that is not finite, a law with a kink, too many steps.
pub fn solve(system: &System, times: &[f64], tolerance: f64) -> Result<Run, SolverError> {
    let last = run::increasing(times)?;
    if let Some(reason) = refusal(system) {
        return Err(SolverError::NoConvergence { method: NAME, time: 0.0, evaluations: 0, reason });
    }
    let units = Units::of(system, if last > 0.0 { last } else { 1.0 });
    let pushed =
        system.forces.laws().iter().any(|law| !law.is_torque() && law.uniform_acceleration().is_none());
    if pushed && !system.body.pivoted {
        along(&mut Expansion::<MOVING>::new(system, &units), units.time, times, tolerance)
    } else {
        along(&mut Expansion::<TURNING>::new(system, &units), units.time, times, tolerance)
    }
}

/// The order for a tolerance (1).
fn order(tolerance: f64) -> usize {
    let order = (1.0 - 0.5 * tolerance.ln()).ceil();
    (order as usize).clamp(LEAST_ORDER, CAPACITY - 1)
}

/// The longest step for a tolerance (2), in units of the scene; infinite where the last two coefficients vanish.
fn longest<const L: usize>(expansion: &Expansion<L>, order: usize, tolerance: f64) -> f64 {
    let of_order = |j: usize| (tolerance / expansion.size(j)).powf(1.0 / j as f64);
    of_order(order - 1).min(of_order(order))
}

/// The coefficients of a step, in the widest registers that the machine has: the numbers are the same in all.
struct Growth<'a, 'b, const L: usize>(&'a mut Expansion<'b, L>, usize);

impl<const L: usize> Work<f64> for Growth<'_, '_, L> {
    type Output = ();

    #[inline(always)]
    fn with_rows<R: Row<Scalar = f64>>(self, _: R::Proof) {
        self.0.grow(self.1);
    }
}

/// Takes a series from step to step until the last of some times [s].
fn along<const L: usize>(
    expansion: &mut Expansion<L>,
    unit: f64,
    times: &[f64],
    tolerance: f64,
) -> Result<Run, SolverError> {
    let order = order(tolerance);
    let registers = Registers::widest();
    let mut run = Run { states: Vec::with_capacity(times.len()), evaluations: 0 };
    let mut times = times.iter().peekable();
    while let Some(next) = times.peek() {
        let time = expansion.time();
        registers.by_two(Growth(expansion, order));
        run.evaluations += order * (order + 1) / 2;
        if !(expansion.is_finite(order) && expansion.is_finite(0)) {
            return Err(SolverError::NotFinite { method: NAME, time: time * unit });
        }
        let end = time + longest(expansion, order, tolerance);
        let gave_up = |reason: String| SolverError::NoConvergence {
            method: NAME,
            time: time * unit,
            evaluations: run.evaluations,
            reason,
        };
        if end <= time && **next > time * unit {
            return Err(gave_up("the step is below the resolution of time".to_owned()));
        }
        if run.evaluations > MOST_EVALUATIONS {
            return Err(gave_up(format!("more than {MOST_EVALUATIONS} evaluations")));
        }
        if interrupt::requested() {
            return Err(SolverError::Interrupted);
        }
        while let Some(stored) = times.next_if(|stored| **stored / unit <= end) {
            run.states.push(expansion.observe(order, stored / unit - time, *stored));
        }
        if times.peek().is_some() {
            expansion.advance(order, end - time, end); // (3)
        }
    }
    Ok(run)
}
