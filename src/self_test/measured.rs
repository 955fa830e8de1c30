//! Metrics that read something else than an error. A right scheme runs and a right gate judges what they say.

use nalgebra::Vector3;

use super::planted::{Measure, Plant, Row};
use crate::measure::{Evidence, QuantityLadder, Reading, Rung};
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::reference::Reference;
use crate::simulate::{Contestant, Form, Plan};

const FREE: &[&str] = &["free-asymmetric", "fast-sphere", "free-rod", "tether-springs"];

const SLOW: &[&str] = &["satellite-gravity-gradient"];

/// Wrong metrics.
pub(super) const METRICS: &[Row] = &[
    ("angle by 2 acos |w|", Plant::Metric(|s, a, b| over(a, b, |a, b| acos(s, a, b))), FREE),
    (
        "angle in degrees",
        Plant::Metric(|s, a, b| over(a, b, |a, b| scaled(s, a, b, 57.295_779_513_082_32))),
        FREE,
    ),
    ("angle of the half quaternion", Plant::Metric(|s, a, b| over(a, b, |a, b| scaled(s, a, b, 0.5))), FREE),
    ("the largest told as the last", Plant::Metric(largest_as_last), FREE),
    ("the last told as the largest", Plant::Metric(last_as_largest), FREE),
    ("the mean told as the largest", Plant::Metric(mean_as_largest), FREE),
    ("the reference one sample late", Plant::Metric(|s, a, b| plain(s, &a[1..], b)), FREE),
    ("the run one sample late", Plant::Metric(|s, a, b| plain(s, a, &b[1..])), FREE),
    ("the last sample left out", Plant::Metric(|s, a, b| plain(s, &a[..a.len() - 1], b)), FREE),
    ("the first half of the run alone", Plant::Metric(|s, a, b| plain(s, &a[..a.len() / 2], b)), FREE),
    (
        "components for lengths",
        Plant::Metric(|s, a, b| over(a, b, |a, b| components(s, a, b))),
        &["tether-springs", "gravity-drag"],
    ),
    ("an absolute threshold of 1e-6", Plant::Metric(|s, a, b| over(a, b, |a, b| thresholded(s, a, b))), SLOW),
    (
        "squares of errors",
        Plant::Metric(|s, a, b| over(a, b, |a, b| difference(&s.body, a, b).map(|e| e * e))),
        FREE,
    ),
    (
        "NaN taken for no error",
        Plant::Metric(|s, a, b| {
            over(a, b, |a, b| {
                difference(&s.body, a, b).map(|e| if e > 1e-3 { f64::NAN } else { 0.0 }.max(0.0))
            })
        }),
        FREE,
    ),
    (
        "quantities in another order",
        Plant::Metric(|s, a, b| {
            let mut r = plain(s, a, b);
            let (angle, spin) = (r[Quantity::Orientation], r[Quantity::AngularVelocity]);
            (r[Quantity::Orientation], r[Quantity::AngularVelocity]) = (spin, angle);
            r
        }),
        FREE,
    ),
    ("position relative to the path", Plant::Metric(relative_to_path), &["tether-springs", "gravity-drag"]),
    ("run compared with itself", Plant::Metric(|s, a, _| plain(s, a, a)), FREE),
];

fn over(
    run: &[Snapshot],
    truth: &[Snapshot],
    apart: impl Fn(&Snapshot, &Snapshot) -> PerQuantity<f64>,
) -> PerQuantity<Reading> {
    let mut readings = PerQuantity::all(Reading { end: 0.0, max: 0.0 });
    for (state, truth) in run.iter().zip(truth) {
        let apart = readings.zip(apart(state, truth));
        readings = apart.map(|(reading, end)| Reading { end, max: reading.max.max(end) });
    }
    readings
}

fn plain(system: &System, run: &[Snapshot], truth: &[Snapshot]) -> PerQuantity<Reading> {
    over(run, truth, |a, b| difference(&system.body, a, b))
}

/// The angle times a factor.
fn scaled(system: &System, a: &Snapshot, b: &Snapshot, factor: f64) -> PerQuantity<f64> {
    let mut apart = difference(&system.body, a, b);
    apart[Quantity::Orientation] *= factor;
    apart
}

fn acos(system: &System, a: &Snapshot, b: &Snapshot) -> PerQuantity<f64> {
    let mut apart = difference(&system.body, a, b);
    apart[Quantity::Orientation] = 2.0 * (a.orientation.inverse() * b.orientation).w.abs().min(1.0).acos();
    apart
}

fn largest_as_last(system: &System, run: &[Snapshot], truth: &[Snapshot]) -> PerQuantity<Reading> {
    plain(system, run, truth).map(|reading| Reading { end: reading.max, ..reading })
}

fn last_as_largest(system: &System, run: &[Snapshot], truth: &[Snapshot]) -> PerQuantity<Reading> {
    plain(system, run, truth).map(|reading| Reading { max: reading.end, ..reading })
}

fn mean_as_largest(system: &System, run: &[Snapshot], truth: &[Snapshot]) -> PerQuantity<Reading> {
    let readings = plain(system, run, truth);
    PerQuantity::of(|quantity| {
        let apart = run.iter().zip(truth).map(|(a, b)| difference(&system.body, a, b)[quantity]);
        Reading { max: apart.sum::<f64>() / run.len() as f64, ..readings[quantity] }
    })
}

fn components(system: &System, a: &Snapshot, b: &Snapshot) -> PerQuantity<f64> {
    let mut apart = difference(&system.body, a, b);
    let largest = |a: Vector3<f64>, b: Vector3<f64>| (a - b).x.abs();
    apart[Quantity::Position] = largest(a.position, b.position);
    apart[Quantity::Velocity] = largest(a.velocity, b.velocity);
    apart
}

fn thresholded(system: &System, a: &Snapshot, b: &Snapshot) -> PerQuantity<f64> {
    difference(&system.body, a, b).map(|error| if error < 1e-6 { 0.0 } else { error })
}

fn relative_to_path(system: &System, run: &[Snapshot], truth: &[Snapshot]) -> PerQuantity<Reading> {
    let mut readings = plain(system, run, truth);
    let path = truth.iter().map(|s| s.position.norm()).fold(0.0, f64::max);
    let Reading { end, max } = readings[Quantity::Position];
    readings[Quantity::Position] = Reading { end: end / path, max: max / path };
    readings
}

/// The evidence of a ladder with its errors measured wrongly.
pub(super) fn mismeasured(
    contestant: &Contestant,
    system: &System,
    reference: &Reference,
    order: u32,
    mut evidence: Evidence,
    measure: Measure,
) -> Evidence {
    let (duration, samples) = (reference.times[reference.times.len() - 1], reference.times.len() as u64 - 1);
    for rung in evidence.rungs.iter_mut().chain(&mut evidence.giant_steps) {
        let plan = Plan::over(duration, rung.steps, samples.min(rung.steps));
        let states = contestant.run(system, Form::Least, &plan).states;
        let truth = if rung.steps < samples { ends(&reference.states) } else { reference.states.clone() };
        let states = if rung.steps < samples { ends(&states) } else { states };
        rung.errors = measure(system, &states, &truth);
    }
    for ladder in &mut evidence.ladders {
        let rungs = evidence.rungs.iter().zip(&ladder.rungs);
        let error = |run: &Rung| ladder.place.of(&run.errors[ladder.quantity]);
        let rungs = rungs.map(|(run, rung)| (rung.0, error(run), rung.2)).collect();
        *ladder = QuantityLadder::of(ladder.quantity, ladder.place, rungs, order);
    }
    evidence
}

/// The first and the last of some states.
fn ends(states: &[Snapshot]) -> Vec<Snapshot> {
    states.first().into_iter().chain(states.last()).copied().collect()
}
