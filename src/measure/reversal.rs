//! There and back: a run with h, and one with −h from where it ended.
//!
//! A symmetric scheme, Φ₋ₕ Φₕ = 1, returns to its start to rounding; any other is off by its own error. A scheme of the list goes there and
//! back in double-double, a program in f64, and so do the copies that show how a rounding grows: where positions are large, f64 takes back the
//! roundings of the way there to the last bit.

use super::copies::{rounding, starts_in};
use super::{CLEAR, Rung, steady_rung};
use crate::arithmetic::{DoubleDouble, Real};
use crate::model::{Broken, PerQuantity, Quantity, Snapshot, System, difference, larger, sizes};
use crate::record::Reversal;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Most steps of one way in f64 …
const STEPS: u64 = 4096;
/// … and in double-double.
const PRECISE_STEPS: u64 = 64;
/// States of one way that say how large everything gets.
const SAMPLES: u64 = 16;

/// Runs there and back in the steps of the coarsest run that follows the truth; `None` where there is none, where a force
/// depends on time, or where friction makes the way back amplify every rounding.
pub fn reversal(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Option<Reversal> {
    if system.forces.read_time() || (system.forces.read_velocity() && !system.forces.conservative()) {
        return None;
    }
    let precise = contestant.runs_in_double_double();
    let most = if precise { PRECISE_STEPS } else { STEPS };
    let rung = steady_rung(contestant, system, rungs, most)?;
    let steps = rung.steps.min(most);
    let reversal = Reversal { steps, step: rung.step, double_double: precise, ..Reversal::default() };
    let plan = (rung.step, steps);
    Some(if precise {
        measured(contestant, &System::<DoubleDouble>::of(system).ok()?, system, plan, reversal)
    } else {
        measured(contestant, system, system, plan, reversal)
    })
}

/// What a way there and back in an arithmetic misses its start by, over its rounding; `given` is the system in f64.
fn measured<T: Arithmetic>(
    contestant: &Contestant,
    system: &System<T>,
    given: &System,
    (step, steps): (f64, u64),
    reversal: Reversal,
) -> Reversal {
    let own = match there_and_back(contestant, system, step, steps) {
        Ok(own) => own,
        Err(why) => {
            return Reversal { unsolved: matches!(why, Some(Broken::NoConvergence { .. })), ..reversal };
        }
    };
    let there: Vec<Snapshot> = own.there.iter().map(Snapshot::nearest).collect();
    let apart = |a: &Snapshot<T>, b: &Snapshot<T>| difference(&system.body, a, b).map(Real::to_f64);
    let (off, sizes) = (apart(&own.back, &own.start), sizes(given, &there));
    let of = |spread: &PerQuantity<f64>| worst(off, rounding(spread, &sizes, (T::UNIT, own.evaluations)));
    let mut spread = PerQuantity::all(0.0);
    let (mut of_rounding, mut largest) = of(&spread);
    // Where a rounding of each evaluation explains the distance, a growth of roundings need not.
    if of_rounding.is_none_or(|of_rounding| of_rounding > CLEAR) {
        let starts = starts_in(system, (given, &there));
        // A copy that breaks is left out.
        let copies = starts.iter().filter_map(|start| there_and_back(contestant, start, step, steps).ok());
        // A copy of a symmetric scheme returns to where it started: the far end shows what the way makes of a rounding.
        let apart = |copy: Return<T>| {
            let ends = copy.there.last().zip(own.there.last()).map(|(copy, own)| apart(copy, own));
            ends.into_iter().fold(apart(&copy.back, &own.back), PerQuantity::max)
        };
        spread = copies.map(apart).fold(spread, PerQuantity::max);
        (of_rounding, largest) = of(&spread);
    }
    Reversal {
        solves: own.solves,
        open: spread[Quantity::Orientation],
        of_rounding,
        worst: largest,
        ..reversal
    }
}

/// A way there and back.
struct Return<T: Real = f64> {
    start: Snapshot<T>,
    /// States of the way there.
    there: Vec<Snapshot<T>>,
    back: Snapshot<T>,
    solves: u64,
    /// Evaluations of the rates and iterations of implicit equations, both ways.
    evaluations: u64,
}

/// Why a run breaks.
fn there_and_back<T: Arithmetic>(
    contestant: &Contestant,
    system: &System<T>,
    step: f64,
    steps: u64,
) -> Result<Return<T>, Option<Broken>> {
    let run = |system: &System<T>, step: f64, every: u64| {
        let mut states = Vec::new();
        let plan = Plan { step, steps, every };
        let outcome = contestant.stream_in(system, Form::Least, &plan, &mut |state| states.push(*state));
        match outcome.broken {
            Some(broken) => Err(Some(broken.why)),
            None => Ok((states, outcome)),
        }
    };
    let (there, out) = run(system, step, (steps / SAMPLES).max(1))?;
    let (way_back, home) = run(&system.started_at(there.last().ok_or(None)?), -step, steps)?;
    let (start, back) = (*there.first().ok_or(None)?, *way_back.last().ok_or(None)?);
    let evaluations = [&out, &home].map(|run| run.evaluations + run.iterations).iter().sum();
    Ok(Return { start, back, solves: out.solves, evaluations, there })
}

/// The largest of the differences over their roundings, with the quantity that it belongs to and the difference; `None` where one is NaN.
pub(super) fn worst(
    off: PerQuantity<f64>,
    rounding: PerQuantity<f64>,
) -> (Option<f64>, Option<(Quantity, f64)>) {
    let ratio = |(off, rounding): (f64, f64)| if off == 0.0 { 0.0 } else { off / rounding };
    let of = off.zip(rounding).map(ratio);
    let largest = of.values().copied().fold(0.0, larger);
    let worst =
        of.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(quantity, _)| (quantity, off[quantity]));
    let finite = largest.is_finite();
    (finite.then_some(largest), worst.filter(|_| finite))
}
