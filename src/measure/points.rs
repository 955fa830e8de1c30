//! The note as written, on every mass point, beside the least model: do they agree, does the body stay rigid, is
//! L untouched?

use super::copies;
use crate::model::forces::Law;
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::record::PointRun;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Steps of the comparison.
const STEPS: u64 = 1000;
/// Radians turned a step, at most.
const TURN: f64 = 1.0 / 512.0;

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
    // Where one form breaks before the other they are not one scheme.
    let mut largest: f64 = if written.states.len() == least.states.len() { 0.0 } else { f64::INFINITY };
    let (mut stretch, mut change): (f64, f64) = (0.0, 0.0);
    for (a, b) in written.states.iter().zip(&least.states) {
        let apart = difference(&system.body, a, b);
        largest = over(apart, &scales).fold(largest, super::larger);
        stretch = super::larger(stretch, a.stretch);
        change =
            super::larger(change, rotation::length(&(a.angular_momentum - system.start.angular_momentum)));
    }
    let of_form = |form, own: &[Snapshot]| {
        over(copies::spread(contestant, (system, form), &plan, own), &scales).fold(0.0, super::larger)
    };
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
    })
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
