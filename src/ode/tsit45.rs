//! The reference by Tsitouras' method of order 5 (Tsitouras 2011), as diffsol has it.
//!
//! Its floor is about 1e-13, best at a tolerance of 1e-14. Every output time is a stop time of the solver:
//! nothing is interpolated.

use diffsol::{DiffsolError, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector};

use super::SolverError;
use super::equations::{DIMENSION, Equations, State};
use super::run::{self, Run, Solver};
use crate::model::System;

/// Relative and absolute tolerance, in units of the scene, at which the method is at its best.
pub const TOLERANCE: f64 = 1e-14;

type Matrix = diffsol::NalgebraMat<f64>;

/// The solution at increasing `times` [s], from t = 0 on.
///
/// # Errors
/// [`SolverError`]: times that do not increase, a state that is not finite, no convergence.
pub fn solve(system: &System, times: &[f64], tolerance: f64) -> Result<Run, SolverError> {
    const NAME: &str = "tsit45";
    let equations = run::checked(system, times, NAME)?;
    let refused = |error: DiffsolError| SolverError::NoConvergence {
        method: NAME,
        time: 0.0,
        evaluations: equations.evaluations(),
        reason: error.to_string(),
    };
    let start = equations.start();
    let problem = OdeBuilder::<Matrix>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(|y: &[f64], _: &[f64], s, rate: &mut [f64]| equations.rate(s, y, rate))
        .init(move |_: &[f64], _, y: &mut [f64]| y.copy_from_slice(&start), DIMENSION)
        .build()
        .map_err(refused)?;
    let method = problem.tsit45().map_err(refused)?;
    let equation = std::marker::PhantomData;
    run::along(&equations, times, &mut Tsit45 { equations: &equations, method, equation })
}

struct Tsit45<'a, E, S> {
    equations: &'a Equations<'a>,
    method: S,
    equation: std::marker::PhantomData<E>,
}

impl<'p, E, S> Solver for Tsit45<'_, E, S>
where
    E: OdeEquations<T = f64> + 'p,
    S: OdeSolverMethod<'p, E>,
{
    const NAME: &'static str = "tsit45";

    fn advance(&mut self, stretch: f64) -> Result<State, String> {
        let problem = |error: DiffsolError| error.to_string();
        let state = self.method.state_mut();
        *state.t = 0.0;
        // The rate at the end of the last step is that before a jump: it is not the rate after it.
        let mut rate = [0.0; DIMENSION];
        self.equations.rate(0.0, &components(state.y), &mut rate);
        rate.into_iter().enumerate().for_each(|(index, value)| state.dy.set_index(index, value));
        self.method.set_stop_time(stretch).map_err(problem)?;
        let (mut longest, mut before) = (0.0f64, 0.0);
        loop {
            let reason = self.method.step().map_err(problem)?;
            run::may_go_on(self.equations)?;
            let reached = self.method.state().t;
            if matches!(reason, OdeSolverStopReason::TstopReached) {
                break;
            }
            longest = reached - before;
            before = reached;
        }
        // The stop time has cut the step: the one before it is what the error control asked for.
        let state = self.method.state_mut();
        *state.h = state.h.max(longest);
        Ok(components(state.y))
    }
}

fn components(state: &impl Vector<T = f64>) -> State {
    std::array::from_fn(|index| state.get_index(index))
}
