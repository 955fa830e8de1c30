//! The times at which laws jump, and the laws between them.

use super::argument::Argument;
use super::parameter::Nature;
use super::{Forces, Law};
use crate::arithmetic::Real;
use crate::model::body::Body;

impl<T: Real> Law<T> {
    /// Times at which it sets in or ends [s].
    fn jumps(&self) -> impl Iterator<Item = T> {
        self.arguments().into_iter().filter_map(|(parameter, argument)| match (parameter.nature, argument) {
            (Nature::Jump, Argument::Number(time)) if time.is_finite() => Some(time),
            _ => None,
        })
    }

    /// The law as it is at a time, at all times: what jumps before has jumped for ever, what jumps later never does.
    fn as_at(&self, time: T) -> Law<T> {
        let ever = |jump: T| T::of(if jump <= time { f64::NEG_INFINITY } else { f64::INFINITY });
        self.map(|parameter, argument| match (parameter.nature, argument) {
            (Nature::Jump, Argument::Number(jump)) => Argument::Number(ever(jump)),
            (_, other) => other,
        })
    }
}

/// The laws between their jumps, each with the time that it ends at [s], the last without an end; none where no law jumps.
pub(super) fn pieces<T: Real>(laws: &[Law<T>], body: &Body<T>) -> Vec<(T, Forces<T>)> {
    let mut jumps: Vec<T> = laws.iter().flat_map(Law::jumps).filter(|time| *time > 0.0).collect();
    if jumps.is_empty() && !laws.iter().any(|law| law.jumps().next().is_some()) {
        return Vec::new();
    }
    jumps.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
    jumps.dedup();
    let starts = std::iter::once(T::zero()).chain(jumps.iter().copied());
    let ends = jumps.iter().copied().chain([T::of(f64::INFINITY)]);
    let forces = |start: T| Forces::new(laws.iter().map(|law| law.as_at(start)).collect(), body);
    starts.zip(ends).map(|(start, end)| (end, forces(start))).collect()
}
