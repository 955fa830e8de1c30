//! Any scheme taken in `N` equal parts of every step.
//!
//! (1)  s(i+1) = S(t + i h/N, h/N, s(i)),  i = 0 … N − 1
//!
//! What engines call substeps. It is no method of its own: a step costs N times as much, and for a scheme of
//! order p its error is N⁻ᵖ of that of S at the same h.

use std::marker::PhantomData;

use super::{Scheme, Workspace};
use crate::model::{Broken, Model};

/// The scheme `S` in `N` parts a step; the list gives each one that it holds a card.
#[derive(Clone, Copy, Debug)]
pub struct Substepped<S, const N: usize>(PhantomData<S>);

impl<S: Scheme, const N: usize> Substepped<S, N> {
    /// States that a step needs: those of `S`, and the last of the parts before.
    pub const STATES: usize = S::STATES + 1;

    /// One step in `N` parts.
    ///
    /// # Errors
    /// A part cannot be made.
    pub fn step<M: Model>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        work: &mut Workspace<M>,
    ) -> Result<(), Broken> {
        let part = h / N as f64;
        // Out of the workspace, so that S can have the rest; put back without an allocation.
        let mut before = work.states.remove(S::STATES);
        before.clone_from(from);
        let result = (0..N).try_for_each(|i| {
            if i > 0 {
                std::mem::swap(&mut before, to);
            }
            S::step(model, t + i as f64 * part, part, &before, to, work) // (1)
        });
        work.states.push(before);
        result
    }
}
