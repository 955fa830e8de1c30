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
#[inline]
pub(super) fn until_settled<M: Model>(
    model: &M,
    mut improve: impl FnMut() -> Result<f64, Broken>,
) -> Result<(), Broken> {
    let (mut smallest, mut stale, mut residual) = (f64::INFINITY, 0, f64::INFINITY);
    for iteration in 1..=MOST {
        let change = improve()?;
        stale = if change < smallest { 0 } else { stale + 1 };
        (smallest, residual) = (smallest.min(change), change);
        if change <= ROUNDING || (change <= TOLERANCE && stale >= STALE) {
            model.solved(iteration);
            return Ok(());
        }
    }
    Err(Broken::NoConvergence { iterations: MOST, residual, tolerance: TOLERANCE })
}

#[cfg(test)]
mod tests {
    use super::super::multipliers::tests::free_body;
    use super::*;

    /// How often an iterate is improved whose changes are these, the last again and again; and what comes of it.
    fn improved(changes: &[f64]) -> (usize, Result<(), Broken>) {
        let mut taken = 0;
        let result = until_settled(&free_body([1.0, 1.5, 2.25]), || {
            taken += 1;
            Ok(changes[(taken - 1).min(changes.len() - 1)])
        });
        (taken, result)
    }

    #[test]
    fn an_iteration_ends_at_rounding_or_where_three_small_changes_have_not_improved() {
        assert_eq!(improved(&[1.0, 1e-9, ROUNDING]), (3, Ok(())));
        assert_eq!(improved(&[1.0, 1e-13]), (5, Ok(())));
        assert_eq!(improved(&[1.0, TOLERANCE]), (5, Ok(())));
        // Two that are larger are no end where the next is smaller again.
        assert_eq!(improved(&[1e-13, 3e-13, 2e-13, 9e-14, 2e-13]), (7, Ok(())));
        assert_eq!(improved(&[1e-14, 1.0, 1.0, 1.0, 1e-13]), (5, Ok(())));
    }

    #[test]
    fn a_change_that_stays_above_the_tolerance_is_no_convergence() {
        for residual in [1e-3, TOLERANCE.next_up()] {
            let expected = Err(Broken::NoConvergence { iterations: MOST, residual, tolerance: TOLERANCE });
            assert_eq!(improved(&[1.0, residual]), (100, expected));
        }
    }
}
