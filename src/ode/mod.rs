//! The Euler equations as one system of ordinary differential equations, and the solvers of other crates that take it.
//!
//! References are solved with them, and the adaptive schemes under test are these solvers.

#[cfg(feature = "solvers")]
pub mod dop853;
pub mod equations;
pub mod run;
#[cfg(feature = "solvers")]
pub mod tsit45;
pub mod units;

/// A solution that a solver does not give.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolverError {
    /// Times that do not increase from 0 on.
    #[error(
        "output time {index} is {time} s after {previous} s: times must be finite and increase from 0 on"
    )]
    Times {
        /// Index of the time.
        index: usize,
        /// The time [s].
        time: f64,
        /// The one before [s].
        previous: f64,
    },
    /// A state with NaN or infinity.
    #[error("{method}: the state is not finite at t = {time} s")]
    NotFinite {
        /// Name of the solver.
        method: &'static str,
        /// Time [s].
        time: f64,
    },
    /// A solver that gave up.
    #[error("{method}: no convergence after t = {time} s and {evaluations} evaluations: {reason}")]
    NoConvergence {
        /// Name of the solver.
        method: &'static str,
        /// Last output time reached [s].
        time: f64,
        /// Evaluations of the equations.
        evaluations: usize,
        /// What the solver says.
        reason: String,
    },
    /// The user asked for the end.
    #[error("interrupted")]
    Interrupted,
}
