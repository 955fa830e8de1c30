//! The iteration that implicit schemes share: repeated until nothing changes but rounding.

use crate::arithmetic::Real;
use crate::model::{Broken, Model};

/// Change of an iterate, relative, that is rounding.
#[inline]
fn rounding<T: Real>() -> f64 {
    4.0 * T::UNIT
}

/// Change that must be reached in f64, relative.
pub(crate) const SOLVED_TO: f64 = 1e-12;

/// The same in an arithmetic; below it the iteration goes on for as long as it improves.
#[inline]
pub(super) fn tolerance<T: Real>() -> f64 {
    SOLVED_TO * (T::UNIT / f64::EPSILON)
}

/// Iterations without a smaller change than any before that end it. One or two are no end: changes of an iterate that
/// circles its limit fall by turns.
const STALE: u32 = 3;

/// Iterations at most: a hundred, and more where more digits are asked for, in proportion to them.
#[inline]
fn most<T: Real>() -> u32 {
    let digits = tolerance::<T>().log10() / tolerance::<f64>().log10();
    (100.0 * digits.max(1.0)).round() as u32
}

/// Repeats `improve`, which returns how far it has moved its iterate, until that is rounding, or is below the tolerance
/// and falls no more. The model counts the iterations.
///
/// # Errors
/// [`Broken::NoConvergence`], or what `improve` cannot do.
#[inline]
pub(super) fn until_settled<M: Model>(
    model: &M,
    mut improve: impl FnMut() -> Result<M::Real, Broken>,
) -> Result<(), Broken> {
    let (rounding, tolerance) = (rounding::<M::Real>(), tolerance::<M::Real>());
    let (mut smallest, mut stale, mut residual) = (f64::INFINITY, 0, f64::INFINITY);
    let most = most::<M::Real>();
    for iteration in 1..=most {
        let change = improve()?.to_f64();
        stale = if change < smallest { 0 } else { stale + 1 };
        (smallest, residual) = (smallest.min(change), change);
        if change <= rounding || (change <= tolerance && stale >= STALE) {
            model.solved(iteration);
            return Ok(());
        }
    }
    // What still falls after the last one has converged slowly.
    if residual <= tolerance {
        model.solved(most);
        return Ok(());
    }
    Err(Broken::NoConvergence { iterations: most, residual, tolerance })
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
        assert_eq!(improved(&[1.0, 1e-9, rounding::<f64>()]), (3, Ok(())));
        assert_eq!(improved(&[1.0, 1e-13]), (5, Ok(())));
        assert_eq!(improved(&[1.0, tolerance::<f64>()]), (5, Ok(())));
        // Two that are larger are no end where the next is smaller again.
        assert_eq!(improved(&[1e-13, 3e-13, 2e-13, 9e-14, 2e-13]), (7, Ok(())));
        assert_eq!(improved(&[1e-14, 1.0, 1.0, 1.0, 1e-13]), (5, Ok(())));
    }

    #[test]
    fn a_change_that_falls_below_the_tolerance_at_the_last_is_convergence() {
        // From 1 to 1e-14 in a hundred equal ratios.
        let slow: Vec<f64> = (0..100).map(|n| 10f64.powf(-14.0 * f64::from(n) / 99.0)).collect();
        assert_eq!(improved(&slow), (100, Ok(())));
    }

    #[test]
    fn a_change_that_stays_above_the_tolerance_is_no_convergence() {
        for residual in [1e-3, tolerance::<f64>().next_up()] {
            let expected = Err(Broken::NoConvergence { iterations: 100, residual, tolerance: 1e-12 });
            assert_eq!(improved(&[1.0, residual]), (100, expected));
        }
    }
}
