//! What is measured on a run, one file a metric.
//!
//! A metric reads the states of a run and those of its reference at the same times. It returns the value at the
//! end and the largest over the run; what does not apply to a scene is `None`, never a number.

pub(crate) mod climb;
pub(crate) mod copies;
pub(crate) mod drift;
mod energy;
pub(crate) mod flips;
pub(crate) mod invariance;
mod invariants;
pub(crate) mod ladder;
mod momentum;
pub(crate) mod order;
pub(crate) mod points;
mod precise;
mod price;
pub(crate) mod reversal;
mod rigidity;
pub(crate) mod symplecticity;

use crate::model::{PerQuantity, Quantity, Snapshot, System, difference, larger};
use crate::reference::Reference;
use crate::simulate::{Contestant, Form, Plan};

pub(crate) use crate::model::copies::CLEAR;
pub use climb::Bounds;
pub(crate) use climb::{GIANT_STEPS, climb, climb_within};
pub(crate) use drift::energy_drift_within;
pub(crate) use flips::{FlipFinder, flips, true_flips, tumbling_axis};
pub(crate) use invariance::other_worlds;
pub use ladder::{Climbed, Rung};
pub(crate) use ladder::{between, start_allows};
pub(crate) use order::{Asked, BELOW, Decision, Doubt, FEWEST, HIGHEST, Order, Run, SAME_TIME, decide};
pub(crate) use points::point_run;
pub(crate) use precise::decide_either;
pub(crate) use price::{Price, long_steps};
pub(crate) use reversal::reversal;
pub(crate) use symplecticity::symplecticity;

/// A run and its reference at the same times.
pub struct Sight<'a> {
    /// The scene.
    pub system: &'a System,
    /// The reference, whose times the states share.
    pub reference: &'a Reference,
    /// States of the run.
    pub states: &'a [Snapshot],
}

/// A metric's two values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// At the end.
    pub end: f64,
    /// The largest over the run.
    pub max: f64,
}

impl Reading {
    /// Nothing at the end and nothing on the way.
    const ZERO: Reading = Reading { end: 0.0, max: 0.0 };
    /// What a run that broke reads.
    const NAN: Reading = Reading { end: f64::NAN, max: f64::NAN };
}

/// One metric.
pub struct Metric {
    /// Name in records; `-end` or `-max` is appended.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// What it is, in words.
    pub what: &'static str,
    measure: fn(&Sight) -> Option<Reading>,
}

impl Metric {
    /// Measures; `None` where the metric does not apply.
    pub fn measure(&self, sight: &Sight) -> Option<Reading> {
        (self.measure)(sight)
    }
}

/// The metrics beside the six errors of [`Quantity`].
pub const ALL: [Metric; 8] = [
    momentum::MAGNITUDE,
    momentum::DIRECTION,
    energy::ROTATIONAL,
    energy::TOTAL,
    rigidity::RIGIDITY,
    invariants::KOVALEVSKAYA,
    invariants::VERTICAL_MOMENTUM,
    invariants::AXIAL_MOMENTUM,
];

/// Errors of the quantities over every common time.
pub fn errors(sight: &Sight) -> PerQuantity<Reading> {
    largest(sight.system, sight.states, &sight.reference.states)
}

/// How far two runs are apart at the end and at most.
fn largest(system: &System, a: &[Snapshot], b: &[Snapshot]) -> PerQuantity<Reading> {
    let mut readings = PerQuantity::all(Reading::ZERO);
    for (a, b) in a.iter().zip(b) {
        let apart = difference(&system.body, a, b);
        readings = readings.zip(apart).map(|(reading, end)| Reading { end, max: larger(reading.max, end) });
    }
    readings
}

/// What an error of a quantity is, in words.
pub fn describe(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Position => "distance of X_cm from the reference's",
        Quantity::Velocity => "length of the difference of U_cm",
        Quantity::Orientation => "angle of the relative rotation; of the axis for a rod",
        Quantity::AngularVelocity => "length of the difference of Omega",
        Quantity::AngularMomentum => "length of the difference of L",
        Quantity::BodyPoint => "largest distance of a body point from its place in the reference",
    }
}

/// The coarsest run of a ladder that follows the truth, to a tenth of the body's size: coarser ones may be unstable and
/// amplify every rounding. Where it solves implicit equations its first steps, `most` of them, are made by copies too: at the edge of
/// what an iteration solves it may break in one and not in another.
fn steady_rung<'a>(
    contestant: &Contestant,
    system: &System,
    rungs: &'a [Rung],
    most: u64,
) -> Option<&'a Rung> {
    let copies_end = |rung: &Rung| {
        let steps = rung.steps.min(most);
        let plan = Plan { step: rung.step, steps, every: steps };
        let run = |system: &System| contestant.run(system, Form::Least, &plan);
        let ends = |start: &System| run(start).outcome.broken.is_none();
        rung.outcome.solves == 0
            || copies::starts(system, &run(system).states, f64::EPSILON, false).iter().all(ends)
    };
    rungs.iter().filter(|rung| rung.follows(system)).find(|rung| copies_end(rung))
}

/// Least-squares slope of y against x.
pub(crate) fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let along: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    along / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

/// Reads a function of each state and its reference over the run.
fn read(sight: &Sight, value: impl Fn(&Snapshot, &Snapshot) -> Option<f64>) -> Option<Reading> {
    let mut reading = Reading::ZERO;
    for (state, truth) in sight.states.iter().zip(&sight.reference.states) {
        let value = value(state, truth)?.abs();
        reading = Reading { end: value, max: larger(reading.max, value) };
    }
    Some(reading)
}

/// The largest value of a function over the reference; `None` where it is zero or not finite.
fn scale(sight: &Sight, value: impl Fn(&Snapshot) -> f64) -> Option<f64> {
    let largest = sight.reference.states.iter().map(|s| value(s).abs()).fold(0.0, larger);
    (largest > 0.0 && largest.is_finite()).then_some(largest)
}
