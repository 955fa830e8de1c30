//! A reference and its uncertainty: what its sources disagree by.
//!
//! The best estimate is dop853, replaced by the stored solution at the times that it has. The uncertainty at a
//! time is the largest of
//!
//! 1. the largest difference of the two solvers so far: two solutions may cross, their errors do not vanish there;
//! 2. the difference of the best estimate from the stored solution at the next time that it has;
//! 3. the rounding of the numbers themselves;
//!
//! and at a stored time the third alone. Where one solver fails, a second run of the other at a hundred times its
//! tolerance stands in for it, and the sources say so.

use nalgebra::Vector3;

use super::run::Run;
use super::stored::{Solution, Stored};
use super::{ReferenceError, dop853, tsit45};
use crate::model::{Quantity, Snapshot, System, difference};
use crate::rotation;

/// A value for each of [`Quantity::ALL`], in its order and units.
pub type Spread = [f64; 6];

/// How much coarser the second run is where a solver has failed.
const COARSER: f64 = 100.0;

/// Rounding of a result, over its size: a few operations.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Difference from a stored solution, over the size of the quantity, that no solver's error explains.
const OTHER_SYSTEM: f64 = 1e-6;

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

/// A motion known as well as f64 allows, and how well that is.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// j T / samples for j = 0 … samples [s].
    pub times: Vec<f64>,
    /// Best estimate at each time.
    pub states: Vec<Snapshot>,
    /// Uncertainty at each time.
    pub uncertainty: Vec<Spread>,
    /// What it rests on.
    pub sources: Vec<Source>,
}

impl Reference {
    /// The motion of `system` over `duration` [s] at `samples` + 1 times; `samples` is a multiple of 4, so that the
    /// quarters are among them. `stored` is the stored solution of the same scene.
    ///
    /// # Errors
    /// [`ReferenceError`]: a grid that cannot be, no solver that converges, a stored solution of another system.
    pub fn of(
        system: &System,
        duration: f64,
        samples: usize,
        stored: Option<&Stored>,
    ) -> Result<Reference, ReferenceError> {
        if !(duration > 0.0 && duration.is_finite()) || samples == 0 || !samples.is_multiple_of(4) {
            return Err(ReferenceError::Grid { duration, samples });
        }
        let times: Vec<f64> = (0..=samples).map(|j| j as f64 * duration / samples as f64).collect();
        let pair = two_solutions(system, &times)?;
        let mut reference = combine(system, times, pair);
        if let Some(stored) = stored {
            reference.hold_against(system, stored)?;
        }
        Ok(reference)
    }

    /// Largest uncertainty over the run.
    pub fn largest_uncertainty(&self) -> Spread {
        self.uncertainty.iter().fold([0.0; 6], larger)
    }

    fn hold_against(&mut self, system: &System, stored: &Stored) -> Result<(), ReferenceError> {
        let (role, differences) = match stored.solution(system)? {
            Solution::Motion(states) => (Role::Exact, self.replace(system, stored, &states)?),
            Solution::Spin(spins) => (Role::Check, self.check_spins(system, stored, &spins)?),
        };
        let mut next = 1;
        for (index, apart) in &differences {
            let end = if role == Role::Exact { *index } else { index + 1 };
            self.widen(next..end, apart);
            next = index + 1;
        }
        if let Some((_, apart)) = differences.last() {
            self.widen(next..self.times.len(), apart);
        }
        let largest = differences.iter().map(|(_, apart)| apart).fold([0.0; 6], larger);
        self.sources.push(Source {
            name: "stored".to_owned(),
            detail: format!(
                "{}, {} digits, agreement {}, {} of {} times used",
                stored.origin,
                stored.digits,
                stored.agreement,
                differences.len(),
                stored.len()
            ),
            role,
            disagreement: (!differences.is_empty()).then_some(largest),
        });
        Ok(())
    }

    fn widen(&mut self, range: std::ops::Range<usize>, apart: &Spread) {
        for uncertainty in self.uncertainty.get_mut(range).unwrap_or_default() {
            *uncertainty = larger(*uncertainty, apart);
        }
    }

    /// Puts the stored states in; returns where, and how far they were from the best estimate.
    fn replace(
        &mut self,
        system: &System,
        stored: &Stored,
        states: &[Snapshot],
    ) -> Result<Vec<(usize, Spread)>, ReferenceError> {
        let mut differences = Vec::new();
        for state in states {
            let Some(index) = self.index_of(state.time) else { continue };
            let apart = difference(&system.body, &self.states[index], state);
            let rounding = rounding(system, state);
            self.same_system(stored, index, &apart, &rounding)?;
            self.states[index] = Snapshot { time: self.times[index], ..*state };
            self.uncertainty[index] = rounding;
            differences.push((index, apart));
        }
        Ok(differences)
    }

    fn check_spins(
        &self,
        system: &System,
        stored: &Stored,
        spins: &[(f64, Vector3<f64>)],
    ) -> Result<Vec<(usize, Spread)>, ReferenceError> {
        let mut differences = Vec::new();
        for (time, spin) in spins {
            let Some(index) = self.index_of(*time) else { continue };
            let state = &self.states[index];
            let body_spin = state.orientation.inverse_transform_vector(&state.angular_velocity);
            let apart = [0.0, 0.0, 0.0, rotation::length(&(body_spin - spin)), 0.0, 0.0];
            self.same_system(stored, index, &apart, &rounding(system, state))?;
            differences.push((index, apart));
        }
        Ok(differences)
    }

    /// Index of a time, up to its rounding.
    fn index_of(&self, time: f64) -> Option<usize> {
        self.times.iter().position(|t| (t - time).abs() <= ROUNDING * time.abs())
    }

    fn same_system(
        &self,
        stored: &Stored,
        index: usize,
        apart: &Spread,
        rounding: &Spread,
    ) -> Result<(), ReferenceError> {
        for (i, quantity) in Quantity::ALL.into_iter().enumerate() {
            let bound = (rounding[i] * (OTHER_SYSTEM / ROUNDING)).max(1e3 * self.uncertainty[index][i]);
            if apart[i] > bound {
                return Err(ReferenceError::OtherSystem {
                    scene: stored.scene.clone(),
                    time: self.times[index],
                    quantity: quantity.name(),
                    unit: quantity.unit(),
                    difference: apart[i],
                    bound,
                });
            }
        }
        Ok(())
    }
}

/// The best estimate, the second solution, and where they come from.
struct Pair {
    best: Run,
    second: Run,
    sources: Vec<Source>,
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

fn two_solutions(system: &System, times: &[f64]) -> Result<Pair, ReferenceError> {
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

fn combine(system: &System, times: Vec<f64>, pair: Pair) -> Reference {
    let Pair { best, second, mut sources } = pair;
    let mut largest = [0.0; 6];
    let uncertainty = best
        .states
        .iter()
        .zip(&second.states)
        .map(|(a, b)| {
            largest = larger(largest, &difference(&system.body, a, b));
            larger(largest, &rounding(system, a))
        })
        .collect();
    if let Some(source) = sources.iter_mut().find(|source| source.role == Role::Second) {
        source.disagreement = Some(largest);
    }
    Reference { times, states: best.states, uncertainty, sources }
}

fn larger(a: Spread, b: &Spread) -> Spread {
    std::array::from_fn(|i| a[i].max(b[i]))
}

/// What the rounding of a state makes of each quantity.
fn rounding(system: &System, state: &Snapshot) -> Spread {
    let spin = rotation::length(&state.angular_velocity);
    let position = rotation::length(&state.position);
    let sizes = [
        position + rotation::length(&system.body.center),
        rotation::length(&state.velocity),
        1.0,
        spin,
        rotation::length(&state.angular_momentum),
        position + system.body.extent(),
    ];
    sizes.map(|size| ROUNDING * size)
}
