//! The best estimate among all that is known of a motion, and how far the others are from it.
//!
//! In this order: the Taylor series in double-double arithmetic, with its own bound; a closed form, with what
//! roundings make of it; dop853. The others are held against the best. Of dop853 nothing but runs of its like is known:
//! its uncertainty at a time is the largest so far of
//!
//! 1. [`SPREAD`] times its difference from tsit45: two solutions may cross, their errors do not vanish there;
//! 2. its difference from runs that start a rounding off: what roundings of the constants, which both solvers share,
//!    have grown to.
//!
//! A source that is farther from the best estimate than both can be wrong by contradicts it, and the uncertainty is
//! then no smaller than that.

use super::ReferenceError;
use super::closed::{self, Closed};
#[cfg(feature = "solvers")]
use super::nudge::{DIRECTIONS, nudged_matrix};
use super::precise::{self, AFFORDABLE, Moment, Motion};
#[cfg(feature = "solvers")]
use super::solvers::{Pair, two_solutions};
use super::sources::{Role, Source};
use crate::model::{PerQuantity, Snapshot, System, difference};
#[cfg(feature = "solvers")]
use crate::ode::{dop853, run::Run};

/// Error of a closed form over its uncertainty that contradicts the best estimate.
const CLOSED_CONTRADICTS: f64 = 8.0;

/// Error of a solver over the spread of both that contradicts the best estimate. Both share the roundings of the
/// constants, so that their spread may be far too small, next to a separatrix most of all: measured up to 40.
#[cfg(feature = "solvers")]
const SOLVER_CONTRADICTS: f64 = 1000.0;

/// Error of dop853 over its difference from tsit45: two errors of one size may be alike by chance.
#[cfg(feature = "solvers")]
const SPREAD: f64 = 2.0;

/// Runs that start a rounding off.
#[cfg(feature = "solvers")]
const NUDGED: usize = 2;

/// The best estimate at each time, its uncertainty without the rounding of the numbers, and all sources.
pub(super) struct Best {
    pub states: Vec<Snapshot>,
    pub uncertainty: Vec<PerQuantity<f64>>,
    pub sources: Vec<Source>,
    /// The same to 31 digits, where the series is the best estimate.
    pub moments: Vec<Moment>,
}

/// All that can be known of `system` at `times` [s]; `rounding` tells that of a state.
pub(super) fn gather(
    system: &System,
    times: &[f64],
    rounding: &dyn Fn(&Snapshot) -> PerQuantity<f64>,
) -> Result<Best, ReferenceError> {
    let taylor = precise::solve(system, times, AFFORDABLE);
    #[cfg(feature = "solvers")]
    let pair = two_solutions(system, times);
    let closed = closed::solve(system, times);
    #[cfg(feature = "solvers")]
    let mut best = match (&taylor, &pair, closed.as_ref()) {
        (Ok(motion), _, _) => of_taylor(motion),
        (Err(_), Ok(_), Some(closed)) => of_closed(closed),
        (Err(_), Ok(pair), None) => of_solvers(system, times, pair),
        (Err(_), Err(error), _) => return Err(error.clone()),
    };
    #[cfg(not(feature = "solvers"))]
    let mut best = match (&taylor, closed.as_ref()) {
        (Ok(motion), _) => of_taylor(motion),
        (Err(_), Some(closed)) => of_closed(closed),
        (Err(error), None) => return Err(error.clone().into()),
    };
    let judge = Judge { system, rounding };
    match (taylor, closed) {
        (Ok(_), Some(closed)) => {
            let source = closed_source(&closed, Role::Second);
            let allowed = closed.uncertainty.iter().map(|u| u.map(|x| CLOSED_CONTRADICTS * x)).collect();
            judge.hold(&mut best, source, &closed.states, allowed, CLOSED_CONTRADICTS);
        }
        (Ok(_), None) => {}
        (Err(error), _) => best.sources.push(Source::failed("taylor", error.to_string())),
    }
    #[cfg(feature = "solvers")]
    match pair {
        Ok(pair) => judge.hold_solvers(&mut best, pair),
        Err(error) => best.sources.push(Source::failed("dop853, tsit45", error.to_string())),
    }
    Ok(best)
}

/// What dop853 and tsit45 alone know of it.
#[cfg(feature = "solvers")]
pub(super) fn by_solvers(
    system: &System,
    times: &[f64],
    rounding: &dyn Fn(&Snapshot) -> PerQuantity<f64>,
) -> Result<Best, ReferenceError> {
    let pair = two_solutions(system, times)?;
    let mut best = of_solvers(system, times, &pair);
    Judge { system, rounding }.hold_solvers(&mut best, pair);
    Ok(best)
}

fn of_taylor(motion: &Motion) -> Best {
    let [(order, steps), (other, other_steps)] = motion.runs;
    let detail = format!(
        "our own, double-double arithmetic, order {order}, {steps} steps; bound from order {other}, {other_steps} steps"
    );
    Best {
        states: motion.moments.iter().map(precise::Moment::snapshot).collect(),
        uncertainty: motion.moments.iter().map(|moment| moment.error).collect(),
        moments: motion.moments.clone(),
        sources: vec![Source { name: "taylor".to_owned(), detail, role: Role::Best, disagreement: None }],
    }
}

fn of_closed(closed: &Closed) -> Best {
    let sources = vec![closed_source(closed, Role::Best)];
    let (states, uncertainty) = (closed.states.clone(), closed.uncertainty.clone());
    Best { states, uncertainty, sources, moments: Vec::new() }
}

fn closed_source(closed: &Closed, role: Role) -> Source {
    Source { name: "closed form".to_owned(), detail: closed.name.clone(), role, disagreement: None }
}

/// dop853, and what its like differ from it by.
#[cfg(feature = "solvers")]
fn of_solvers(system: &System, times: &[f64], pair: &Pair) -> Best {
    let others: Vec<Run> = DIRECTIONS[DIRECTIONS.len() - NUDGED..]
        .iter()
        .filter_map(|signs| dop853::solve(&nudged_matrix(system, signs), times, dop853::TOLERANCE).ok())
        .collect();
    let mut largest = PerQuantity::all(0.0);
    let uncertainty = pair.best.states.iter().enumerate().map(|(j, state)| {
        let spread = difference(&system.body, state, &pair.second.states[j]);
        largest = largest.max(spread.map(|x| SPREAD * x));
        for other in &others {
            largest = largest.max(difference(&system.body, state, &other.states[j]));
        }
        largest
    });
    let (states, uncertainty) = (pair.best.states.clone(), uncertainty.collect());
    Best { states, uncertainty, sources: Vec::new(), moments: Vec::new() }
}

struct Judge<'a> {
    system: &'a System,
    rounding: &'a dyn Fn(&Snapshot) -> PerQuantity<f64>,
}

impl Judge<'_> {
    /// Holds a source against the best estimate: more than `allowed` and so many roundings is a contradiction.
    fn hold(
        &self,
        best: &mut Best,
        source: Source,
        states: &[Snapshot],
        allowed: Vec<PerQuantity<f64>>,
        roundings: f64,
    ) {
        let (mut largest, mut contradiction) = (PerQuantity::all(0.0), PerQuantity::all(0.0));
        for (j, state) in states.iter().enumerate() {
            let apart = difference(&self.system.body, &best.states[j], state);
            let rounding = (self.rounding)(&best.states[j]);
            largest = largest.max(apart);
            let excess = PerQuantity::of(|quantity| {
                let told = best.uncertainty[j][quantity];
                let bound = allowed[j][quantity] + roundings * rounding[quantity] + told;
                if apart[quantity] > bound { apart[quantity] } else { 0.0 }
            });
            contradiction = contradiction.max(excess);
            best.uncertainty[j] = best.uncertainty[j].max(contradiction);
        }
        best.sources.push(Source { disagreement: Some(largest), ..source });
    }

    #[cfg(feature = "solvers")]
    fn hold_solvers(&self, best: &mut Best, pair: Pair) {
        let mut spread = PerQuantity::all(0.0);
        let states = pair.best.states.iter().zip(&pair.second.states);
        let spreads: Vec<PerQuantity<f64>> = states
            .map(|(a, b)| {
                spread = spread.max(difference(&self.system.body, a, b));
                spread
            })
            .collect();
        let alone = best.sources.iter().all(|source| source.role != Role::Best);
        for source in pair.sources {
            match source.role {
                Role::Best if alone => best.sources.push(source),
                Role::Best | Role::Second => {
                    let run = if source.role == Role::Best { &pair.best } else { &pair.second };
                    let allowed = spreads.iter().map(|s| s.map(|x| SOLVER_CONTRADICTS * x)).collect();
                    let source = Source { role: Role::Second, ..source };
                    self.hold(best, source, &run.states, allowed, SOLVER_CONTRADICTS);
                }
                _ => best.sources.push(source),
            }
        }
        best.sources.sort_by_key(|source| source.role != Role::Best);
    }
}
