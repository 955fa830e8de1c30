//! The solutions that a reference rests on: two solvers, or one that stands in for the other.
//!
//! Where one solver fails, a second run of the other at a hundred times its tolerance takes its place.

use super::run::Run;
use super::{ReferenceError, dop853, tsit45};
use crate::model::System;

/// A value for each of [`crate::model::Quantity::ALL`], in its order and units.
pub type Spread = [f64; 6];

/// How much coarser the second run is where a solver has failed.
const COARSER: f64 = 100.0;

/// What a source is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The best estimate where nothing better is known.
    Best,
    /// Measures the error of the best estimate.
    Second,
    /// Replaces the best estimate at the times it has.
    Exact,
    /// Knows a part of the motion only, and is compared with that part.
    Check,
    /// Gave no solution.
    Failed,
}

impl Role {
    /// Name in records.
    pub fn name(self) -> &'static str {
        match self {
            Role::Best => "best estimate",
            Role::Second => "second source",
            Role::Exact => "exact at its times",
            Role::Check => "check",
            Role::Failed => "failed",
        }
    }
}

/// One of the solutions that a reference rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Method, or "stored".
    pub name: String,
    /// Implementation, tolerance and work; or how it was made; or why it failed.
    pub detail: String,
    /// What it is there for.
    pub role: Role,
    /// Largest difference from the best estimate over the run; `None` for the best estimate itself. A check
    /// compares angular velocities only: its other entries are 0.
    pub disagreement: Option<Spread>,
}

/// The best estimate, the second solution, and where they come from.
pub(super) struct Pair {
    pub best: Run,
    pub second: Run,
    pub sources: Vec<Source>,
}

type Solve = fn(&System, &[f64], f64) -> Result<Run, ReferenceError>;

/// A solver, and how it is written.
struct Method {
    name: &'static str,
    written: &'static str,
    tolerance: f64,
    solve: Solve,
}

const DOP853: Method = Method {
    name: "dop853",
    written: "differential-equations dop853",
    tolerance: dop853::TOLERANCE,
    solve: dop853::solve,
};

const TSIT45: Method =
    Method { name: "tsit45", written: "diffsol tsit45", tolerance: tsit45::TOLERANCE, solve: tsit45::solve };

impl Method {
    fn source(&self, tolerance: f64, run: &Run, role: Role) -> Source {
        let detail = format!("{}, tolerance {tolerance:e}, {} evaluations", self.written, run.evaluations);
        Source { name: self.name.to_owned(), detail, role, disagreement: None }
    }
}

pub(super) fn two_solutions(system: &System, times: &[f64]) -> Result<Pair, ReferenceError> {
    let solve = |method: &Method, tolerance| (method.solve)(system, times, tolerance);
    match (solve(&DOP853, DOP853.tolerance), solve(&TSIT45, TSIT45.tolerance)) {
        (Ok(best), Ok(second)) => {
            let sources = vec![
                DOP853.source(DOP853.tolerance, &best, Role::Best),
                TSIT45.source(TSIT45.tolerance, &second, Role::Second),
            ];
            Ok(Pair { best, second, sources })
        }
        (Ok(best), Err(error)) => alone(system, times, &DOP853, best, &TSIT45, error),
        (Err(error), Ok(best)) => alone(system, times, &TSIT45, best, &DOP853, error),
        (Err(first), Err(second)) => {
            Err(ReferenceError::Both { first: Box::new(first), second: Box::new(second) })
        }
    }
}

/// A second, coarser run of the method that works, in place of the one that failed.
fn alone(
    system: &System,
    times: &[f64],
    method: &Method,
    best: Run,
    failed: &Method,
    error: ReferenceError,
) -> Result<Pair, ReferenceError> {
    let tolerance = method.tolerance * COARSER;
    let second = match (method.solve)(system, times, tolerance) {
        Ok(second) => second,
        Err(again) => return Err(ReferenceError::Both { first: Box::new(error), second: Box::new(again) }),
    };
    let sources = vec![
        method.source(method.tolerance, &best, Role::Best),
        method.source(tolerance, &second, Role::Second),
        Source {
            name: failed.name.to_owned(),
            detail: format!("{error}; {} at a coarser tolerance stands in for it", method.name),
            role: Role::Failed,
            disagreement: None,
        },
    ];
    Ok(Pair { best, second, sources })
}
