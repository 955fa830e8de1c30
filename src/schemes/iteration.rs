//! The iteration that implicit schemes share: repeated until nothing changes but rounding.

use crate::model::{Broken, Model};

/// Change of an iterate, relative, that is rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Change that must be reached; below it the iteration goes on for as long as it improves.
const TOLERANCE: f64 = 1e-12;
/// Iterations without a smaller change than any before that end it. One or two are no end: changes of an iterate that
/// circles its limit fall by turns.
const STALE: u32 = 3;
/// Iterations at most.
const MOST: u32 = 100;

/// Repeats `improve`, which returns how far it has moved its iterate, until that is rounding, or is below 1e-12
/// and falls no more. The model is told, so that a harness can count the work.
///
/// # Errors
/// [`Broken::NoConvergence`], or what `improve` cannot do.
pub(super) fn until_settled<M: Model>(
    model: &M,
    mut improve: impl FnMut() -> Result<f64, Broken>,
) -> Result<(), Broken> {
    let (mut smallest, mut stale) = (f64::INFINITY, 0);
    for iteration in 1..=MOST {
        let change = improve()?;
        stale = if change < smallest { 0 } else { stale + 1 };
        smallest = smallest.min(change);
        if change <= ROUNDING || (change <= TOLERANCE && stale >= STALE) {
            model.solved(iteration);
            return Ok(());
        }
    }
    Err(Broken::NoConvergence { iterations: MOST, residual: smallest, tolerance: TOLERANCE })
}
