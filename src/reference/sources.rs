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
    /// Is held against the best estimate; measures its error where nothing better is known.
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
    /// Method, "closed form", or "stored".
    pub name: String,
    /// Implementation, tolerance and work; or how it was made; or why it failed.
    pub detail: String,
    /// What it is there for.
    pub role: Role,
    /// Largest difference from the best estimate over the run; `None` for the best estimate itself. A check
    /// compares angular velocities only: its other entries are 0.
    pub disagreement: Option<Spread>,
}

impl Source {
    pub(super) fn failed(name: &str, detail: String) -> Source {
        Source { name: name.to_owned(), detail, role: Role::Failed, disagreement: None }
    }
}

/// The better solver's solution, the second one, and where they come from.
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
    pair(system, times, &DOP853, &TSIT45)
}

fn pair(system: &System, times: &[f64], first: &Method, second: &Method) -> Result<Pair, ReferenceError> {
    let solve = |method: &Method| (method.solve)(system, times, method.tolerance);
    match (solve(first), solve(second)) {
        (Ok(best), Ok(other)) => {
            let sources = vec![
                first.source(first.tolerance, &best, Role::Best),
                second.source(second.tolerance, &other, Role::Second),
            ];
            Ok(Pair { best, second: other, sources })
        }
        (Ok(best), Err(error)) => alone(system, times, first, best, second, error),
        (Err(error), Ok(best)) => alone(system, times, second, best, first, error),
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
        Source::failed(
            failed.name,
            format!("{error}; {} at a coarser tolerance stands in for it", method.name),
        ),
    ];
    Ok(Pair { best, second, sources })
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::model::Spin;
    use crate::model::body::Body;
    use crate::rotation::Rotation;

    const FAILING: Method = Method {
        name: "failing",
        written: "failing",
        tolerance: 1e-14,
        solve: |_, _, _| Err(ReferenceError::NotFinite { method: "failing", time: 0.5 }),
    };

    fn system() -> System {
        let inertia = Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 2.5));
        let body = Body::from_inertia(1.0, inertia, None, false).expect("a body");
        let spin = Spin::Velocity(Vector3::new(1.0, 1.0, 1.0));
        System::new(body, vec![], Vector3::zeros(), Rotation::identity(), Vector3::zeros(), spin)
            .expect("a system")
    }

    #[test]
    fn a_coarser_run_stands_in_for_a_solver_that_failed_and_the_sources_say_so() {
        for (first, second, works) in [(&FAILING, &TSIT45, "tsit45"), (&DOP853, &FAILING, "dop853")] {
            let pair = pair(&system(), &[0.0, 1.0], first, second).expect("a pair");
            let told: Vec<_> = pair.sources.iter().map(|s| (s.name.as_str(), s.role)).collect();
            let expected = [(works, Role::Best), (works, Role::Second), ("failing", Role::Failed)];
            assert_eq!(told, expected);
            assert!(pair.sources[1].detail.contains("tolerance 1e-1"), "{}", pair.sources[1].detail);
            assert!(pair.second.evaluations < pair.best.evaluations);
        }
        let neither = pair(&system(), &[0.0, 1.0], &FAILING, &FAILING);
        assert!(matches!(neither, Err(ReferenceError::Both { .. })));
    }
}
