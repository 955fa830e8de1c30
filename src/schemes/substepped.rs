//! Any scheme taken in `N` equal parts of every step.
//!
//! (1)  s(i+1) = S(t + i h/N, h/N, s(i)),  i = 0 … N − 1
//!
//! What engines call substeps. It is no method of its own: a step costs N times as much, and for a scheme of
//! order p its error is N⁻ᵖ of that of S at the same h.

use super::{Scheme, Step};
use crate::model::{Broken, Model};

/// One step of `scheme` in `parts` parts. The state behind those of the scheme holds the last of the parts before.
///
/// # Errors
/// A part cannot be made.
pub(super) fn substepped<M: Model, S: Scheme>(
    scheme: &S,
    parts: usize,
    model: &M,
    Step { t, h, from, to, work }: Step<M>,
) -> Result<(), Broken> {
    let part = h / parts as f64;
    // Out of the workspace, so that the scheme can have the rest; put back without an allocation.
    let mut before = work.states.remove(S::STATES);
    before.clone_from(from);
    let result = (0..parts).try_for_each(|i| {
        if i > 0 {
            std::mem::swap(&mut before, to);
        }
        let t = t + part * i as f64;
        scheme.step(model, Step { t, h: part, from: &before, to: &mut *to, work: &mut *work }) // (1)
    });
    work.states.push(before);
    result
}
