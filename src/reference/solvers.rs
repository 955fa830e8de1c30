//! The solutions of two solvers of other crates, or of one that stands in for the other.
//!
//! Where one solver fails, a second run of the other at a hundred times its tolerance takes its place.

use super::ReferenceError;
use super::sources::{Role, Source};
use crate::model::System;
use crate::ode::run::Run;
use crate::ode::{SolverError, dop853, tsit45};

/// How much coarser the second run is where a solver has failed.
const COARSER: f64 = 100.0;

/// The better solver's solution, the second one, and where they come from.
pub(super) struct Pair {
    pub best: Run,
    pub second: Run,
    pub sources: Vec<Source>,
}

type Solve = fn(&System, &[f64], f64) -> Result<Run, SolverError>;

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
        (Err(first), Err(second)) => Err(both(first, second)),
    }
}

fn both(first: SolverError, second: SolverError) -> ReferenceError {
    ReferenceError::Both { first: Box::new(first.into()), second: Box::new(second.into()) }
}

/// A second, coarser run of the method that works, in place of the one that failed.
fn alone(
    system: &System,
    times: &[f64],
    method: &Method,
    best: Run,
    failed: &Method,
    error: SolverError,
) -> Result<Pair, ReferenceError> {
    let tolerance = method.tolerance * COARSER;
    let second = match (method.solve)(system, times, tolerance) {
        Ok(second) => second,
        Err(again) => return Err(both(error, again)),
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
        solve: |_, _, _| Err(SolverError::NotFinite { method: "failing", time: 0.5 }),
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
