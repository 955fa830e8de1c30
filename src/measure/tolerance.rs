//! Ladders of solvers that choose their own steps: which rungs say how the error follows the tolerance.

use super::{Evidence, Place, QuantityLadder};
use crate::measure::regression;
use crate::model::{Quantity, System};

/// Fewest rungs of a slope.
pub const FEWEST_TOLERANCES: usize = 4;
/// Evaluations at a tolerance over those at the next larger one, where tolerances rule.
const MORE_WORK: f64 = 1.1;
/// An error of this part of the body's size or of a radian is no convergence yet.
const COARSE: f64 = 0.3;
/// Most evaluations of a run after which a ladder is taken another rung down, …
const MOST_EVALUATIONS: u64 = 500_000;
/// … and most rungs.
const MOST_RUNGS: usize = 12;
/// Slopes between which a ladder needs no further rung.
const SETTLED: (f64, f64) = (0.5, 1.5);

/// The ladders by which such a solver is judged: where the body is at the end.
pub fn judged_by_tolerance(ladder: &QuantityLadder) -> bool {
    let asked = [Quantity::Position, Quantity::Orientation, Quantity::BodyPoint];
    ladder.place == Place::End && asked.contains(&ladder.quantity)
}

/// The rungs of such a ladder, and why some say nothing.
#[derive(Clone, Debug, Default)]
pub struct Governed {
    /// (tolerance, error) where the tolerance rules the steps and the error stands clear of the floor and below the size of the
    /// motion.
    pub rungs: Vec<(f64, f64)>,
    /// Rungs whose error is as large as the motion.
    pub coarse: usize,
    /// Rungs at the floor of rounding and reference.
    pub at_floor: usize,
    /// Rungs where the stored times, which cut steps, or the solver's first guess rule: the next smaller tolerance makes no more
    /// work.
    pub ruled_otherwise: usize,
}

/// Sorts the rungs of a ladder.
pub fn governed(evidence: &Evidence, ladder: &QuantityLadder, system: &System, power: u32) -> Governed {
    let scale = if ladder.quantity == Quantity::Orientation { 1.0 } else { system.body.extent() };
    let work = |rung: usize| evidence.rungs.get(rung).map(|rung| rung.outcome.evaluations as f64);
    let governs = |index: usize| match (work(index), work(index + 1)) {
        (Some(own), Some(next)) => next >= MORE_WORK * own,
        _ => true,
    };
    let mut governed = Governed::default();
    for (index, (step, error, floor)) in ladder.rungs.iter().enumerate() {
        if *error <= 10.0 * floor {
            governed.at_floor += 1;
        } else if *error < COARSE * scale && governs(index) {
            governed.rungs.push((step.powi(power as i32), *error));
        } else if *error < COARSE * scale {
            governed.ruled_otherwise += 1;
        } else {
            governed.coarse += 1;
        }
    }
    governed
}

/// Whether a further rung would change nothing: every slope is read, the error is at its floor, or the work is enough.
pub(super) fn settled(evidence: &Evidence, system: &System, power: u32) -> bool {
    let dear = evidence.rungs.last().is_none_or(|rung| rung.outcome.evaluations > MOST_EVALUATIONS);
    if dear || evidence.rungs.len() >= MOST_RUNGS {
        return true;
    }
    evidence.ladders.iter().filter(|ladder| judged_by_tolerance(ladder)).all(|ladder| {
        let at_floor = ladder.rungs.last().is_some_and(|(_, error, floor)| *error <= 10.0 * floor);
        let clear = governed(evidence, ladder, system, power).rungs;
        let fit = if clear.len() >= FEWEST_TOLERANCES { regression::fit_power(&clear) } else { None };
        at_floor || fit.is_some_and(|fit| fit.slope >= SETTLED.0 && fit.slope <= SETTLED.1)
    })
}
