//! The reference by Dormand and Prince's method of order 8 (Hairer, Nørsett, Wanner, Solving ODEs I, II.5), as
//! the crate differential-equations has it.
//!
//! It reaches 1e-14 on a motion of a few turns and survives a tolerance of 1e-16. Its dense output is of order
//! 7 only, so every output time ends a step.

use differential_equations::methods::{DormandPrince, ExplicitRungeKutta, Ordinary};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status;

use super::SolverError;
use super::equations::{Equations, State};
use super::run::{self, Run, Solver};
use crate::model::System;

/// Relative and absolute tolerance, in units of the scene, at which the method is at its best.
pub const TOLERANCE: f64 = 1e-15;

/// The solution at increasing `times` [s], from t = 0 on.
///
/// # Errors
/// [`SolverError`]: times that do not increase, a state that is not finite, no convergence.
pub fn solve(system: &System, times: &[f64], tolerance: f64) -> Result<Run, SolverError> {
    let equations = run::checked(system, times, Dop853::NAME)?;
    let mut solver =
        Dop853 { equations: &equations, tolerance, state: equations.start(), step: 0.0, stepped: false };
    run::along(&equations, times, &mut solver)
}

struct Dop853<'a> {
    equations: &'a Equations<'a>,
    tolerance: f64,
    state: State,
    /// Step that the error control asks for.
    step: f64,
    stepped: bool,
}

impl ODE<f64, State> for Equations<'_> {
    fn diff(&self, s: f64, y: &State, rate: &mut State) {
        self.rate(s, y, rate);
    }
}

type Method = ExplicitRungeKutta<Ordinary, DormandPrince, f64, State, 8, 12, 16>;

impl Solver for Dop853<'_> {
    const NAME: &'static str = "dop853";

    fn advance(&mut self, stretch: f64) -> Result<State, String> {
        let mut method: Method =
            ExplicitRungeKutta::dop853().rtol(self.tolerance).atol(self.tolerance).max_steps(usize::MAX);
        if self.stepped {
            method = method.h0(self.step.min(stretch));
        }
        let problem = |error| format!("{error:?}");
        method.init(self.equations, 0.0, stretch, &self.state).map_err(problem)?;
        loop {
            let wanted = method.h();
            let left = stretch - method.t();
            // A last step up to a hundredth longer than wanted spares a sliver.
            let last = wanted * 1.01 >= left;
            if last {
                method.set_h(left);
            }
            method.step(self.equations).map_err(problem)?;
            run::may_go_on(self.equations)?;
            if last && !matches!(method.status(), Status::RejectedStep) {
                self.step = method.h().max(wanted);
                self.stepped = true;
                self.state = *method.y();
                return Ok(self.state);
            }
        }
    }
}
