//! What every solver of the equations shares: a list of output times and the limits of a run.

use super::SolverError;
use super::equations::{DIMENSION, Equations, State};
use crate::interrupt;
use crate::model::{Snapshot, System};

/// Evaluations of the equations after which a solver gives up.
pub const MOST_EVALUATIONS: usize = 20_000_000;

/// A solution at the requested times.
#[derive(Clone, Debug)]
pub struct Run {
    /// One for each time.
    pub states: Vec<Snapshot>,
    /// Evaluations of the equations.
    pub evaluations: usize,
}

/// Goes from one state over a stretch of time to the next.
pub trait Solver {
    /// Name in messages.
    const NAME: &'static str;

    /// The state a `stretch` after the last one, both in units of the scene.
    ///
    /// # Errors
    /// What the solver says.
    fn advance(&mut self, stretch: f64) -> Result<State, String>;
}

/// Whether a solver may go on.
///
/// # Errors
/// Too many evaluations, or the user asks for the end.
pub fn may_go_on(equations: &Equations) -> Result<(), String> {
    if interrupt::requested() {
        return Err(SolverError::Interrupted.to_string());
    }
    let within = equations.evaluations() <= MOST_EVALUATIONS;
    within.then_some(()).ok_or_else(|| format!("more than {MOST_EVALUATIONS} evaluations"))
}

/// Takes a solver from output to output. Each stretch ends on a step of the solver: nothing is interpolated.
///
/// # Errors
/// [`SolverError::Times`], [`SolverError::NotFinite`], [`SolverError::NoConvergence`] and [`SolverError::Interrupted`].
pub fn along<S: Solver>(equations: &Equations, times: &[f64], solver: &mut S) -> Result<Run, SolverError> {
    let mut states = Vec::with_capacity(times.len());
    let (mut state, mut reached) = (equations.start(), 0.0);
    for time in times {
        while *time > reached {
            // No step lies across a jump.
            let end = equations.enter(reached).map_or(*time, |jump| jump.min(*time));
            equations.set_clock(reached);
            state = solver.advance((end - reached) / equations.units().time).map_err(|reason| {
                if interrupt::requested() {
                    return SolverError::Interrupted;
                }
                let evaluations = equations.evaluations();
                SolverError::NoConvergence { method: S::NAME, time: reached, evaluations, reason }
            })?;
            reached = end;
        }
        if !state.iter().all(|x| x.is_finite()) {
            return Err(SolverError::NotFinite { method: S::NAME, time: reached });
        }
        states.push(equations.observe(*time, &state));
    }
    Ok(Run { states, evaluations: equations.evaluations() })
}

/// The last of increasing times [s]; 0 where there are none.
///
/// # Errors
/// [`SolverError::Times`].
pub fn increasing(times: &[f64]) -> Result<f64, SolverError> {
    let mut previous = 0.0;
    for (index, time) in times.iter().enumerate() {
        let later = if index == 0 { *time >= 0.0 } else { *time > previous };
        if !(later && time.is_finite()) {
            return Err(SolverError::Times { index, time: *time, previous });
        }
        previous = *time;
    }
    Ok(previous)
}

/// The equations of a system, once its start and the requested times are known to be sound.
///
/// # Errors
/// [`SolverError::Times`] and [`SolverError::NotFinite`].
pub fn checked<'a>(
    system: &'a System,
    times: &[f64],
    method: &'static str,
) -> Result<Equations<'a>, SolverError> {
    let last = increasing(times)?;
    let equations = Equations::new(system, if last > 0.0 { last } else { 1.0 });
    let (start, mut rate) = (equations.start(), [0.0; DIMENSION]);
    equations.rate(0.0, &start, &mut rate);
    if start.iter().chain(&rate).all(|x| x.is_finite()) {
        Ok(equations)
    } else {
        Err(SolverError::NotFinite { method, time: 0.0 })
    }
}
