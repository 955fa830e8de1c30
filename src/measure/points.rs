//! The note as written, on every mass point, beside the least model: do they agree, does the body stay rigid, is
//! L untouched?

use super::SHAKEN;
use super::moved_starts::shaken_bodies;
use crate::model::forces::Law;
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::rotation;
use crate::simulate::{Contestant, Form, Outcome, Plan};

/// Steps of the comparison.
const STEPS: u64 = 1000;
/// Radians turned a step, at most.
const TURN: f64 = 1.0 / 512.0;

/// A run of the point form and what it shows.
#[derive(Clone, Debug)]
pub struct PointRun {
    /// h [s].
    pub step: f64,
    /// Steps taken.
    pub steps: u64,
    /// Largest difference from the least model over the run, each quantity over its own scale.
    pub difference: f64,
    /// Largest change of a distance between points over the run, over the extent.
    pub stretch: f64,
    /// Largest change of L over |L|, for a body that no torque turns.
    pub momentum_change: Option<f64>,
    /// What the roundings of Σ X̃_k × F_k in every step may add to L by the end, over |L|: they have one sign for as long as the body
    /// hardly turns.
    pub torque_rounding: f64,
    /// What rounding does: the largest differences of either form from itself with start and points a few rounding units off, each
    /// quantity over its own scale.
    pub rounding: f64,
    /// Cost of the point form.
    pub outcome: Outcome,
}

/// Runs both forms for 1,000 steps; `None` where the body has no points or the scheme takes none.
pub fn point_run(contestant: &Contestant, system: &System, duration: f64, fastest: f64) -> Option<PointRun> {
    if !contestant.takes_points() || system.body.points.is_empty() {
        return None;
    }
    let steepest = if fastest > 0.0 { TURN / fastest } else { duration };
    let step = steepest.min(duration / STEPS as f64);
    let plan = Plan { step, steps: STEPS, every: 50 };
    let written = contestant.run(system, Form::Points, &plan);
    let least = contestant.run(system, Form::Least, &plan);
    let scales = scales(system, &least.states);
    let mut largest: f64 = 0.0;
    let (mut stretch, mut change): (f64, f64) = (0.0, 0.0);
    for (a, b) in written.states.iter().zip(&least.states) {
        let apart = difference(&system.body, a, b);
        largest = over(apart, &scales).fold(largest, super::larger);
        stretch = super::larger(stretch, a.stretch);
        change =
            super::larger(change, rotation::length(&(a.angular_momentum - system.start.angular_momentum)));
    }
    let of_form = |form, own: &[Snapshot]| rounding(contestant, system, form, &plan, own, &scales);
    let rounding = of_form(Form::Points, &written.states) + of_form(Form::Least, &least.states);
    let momentum = rotation::length(&system.start.angular_momentum);
    // Half a unit for each of K − 1 sums, of the K + 1 operations that the centre of mass is known by, and of seven in a term.
    let units = system.body.points.len() as f64 + 4.0;
    let torque_rounding = units * f64::EPSILON * weight_on_arms(system) * step * STEPS as f64 / momentum;
    Some(PointRun {
        step,
        steps: STEPS,
        difference: largest,
        stretch,
        momentum_change: (system.torque_free() && momentum > 0.0).then_some(change / momentum),
        torque_rounding,
        rounding,
        outcome: written.outcome,
    })
}

/// A form beside itself with start and points a few rounding units off: they differ by rounding alone.
fn rounding(
    contestant: &Contestant,
    system: &System,
    form: Form,
    plan: &Plan,
    own: &[Snapshot],
    scales: &PerQuantity<f64>,
) -> f64 {
    shaken_bodies(system, own, SHAKEN).fold(0.0, |largest, shaken| {
        let states = contestant.run(&shaken, form, plan).states;
        f64::max(largest, furthest(system, states.into_iter(), own, scales))
    })
}

/// Largest difference of any quantity over its scale.
fn furthest(
    system: &System,
    states: impl Iterator<Item = Snapshot>,
    own: &[Snapshot],
    scales: &PerQuantity<f64>,
) -> f64 {
    states.zip(own).flat_map(|(a, b)| over(difference(&system.body, &a, b), scales)).fold(0.0, super::larger)
}

/// Each value over its scale.
fn over(values: PerQuantity<f64>, scales: &PerQuantity<f64>) -> impl Iterator<Item = f64> {
    values.zip(*scales).into_iter().map(|(_, (value, scale))| value / scale)
}

/// Σ M_k |X̃_k| |g| [N m]: the size of the torques of gravity that cancel in their sum.
fn weight_on_arms(system: &System) -> f64 {
    let gravity: f64 = system
        .forces
        .laws()
        .iter()
        .map(
            |law| if let Law::Gravity(gravity) = law { rotation::length(&gravity.acceleration) } else { 0.0 },
        )
        .sum();
    let arms: f64 = system.body.points.iter().map(|p| p.mass * rotation::length(&p.position)).sum();
    gravity * arms
}

/// What each quantity is compared with: its largest value over the run, or the body's own size.
fn scales(system: &System, states: &[Snapshot]) -> PerQuantity<f64> {
    let largest = |value: fn(&Snapshot) -> f64| states.iter().map(value).fold(0.0, f64::max);
    let extent = system.body.extent();
    let position = largest(|s| rotation::length(&s.position)).max(extent);
    let momentum = largest(|s| rotation::length(&s.angular_momentum));
    let spin = largest(|s| rotation::length(&s.angular_velocity));
    let speed = largest(|s| rotation::length(&s.velocity)).max(spin * extent);
    let or_one = |scale: f64| if scale > 0.0 { scale } else { 1.0 };
    PerQuantity::of(|quantity| match quantity {
        Quantity::Position | Quantity::BodyPoint => or_one(position),
        Quantity::Velocity => or_one(speed),
        Quantity::Orientation => 1.0,
        Quantity::AngularVelocity => or_one(spin),
        Quantity::AngularMomentum => or_one(momentum),
    })
}
