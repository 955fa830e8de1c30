//! The note as written, on every mass point, beside the least model: do they agree, does the body stay rigid, is
//! L untouched?
//!
//! A scheme of the list runs in double-double, a program in f64. How a rounding grows is seen in copies in f64; its unit is that of the
//! arithmetic.

use super::copies;
use crate::arithmetic::{DoubleDouble, Real};
use crate::model::forces::Law;
use crate::model::{PerQuantity, Quantity, Snapshot, System, difference};
use crate::record::PointRun;
use crate::rotation;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Steps of the comparison in f64 …
const STEPS: u64 = 1000;
/// … and in double-double.
const PRECISE_STEPS: u64 = 128;
/// Radians turned a step, at most.
const TURN: f64 = 1.0 / 512.0;

/// Runs both forms; `None` where the body has no points or the scheme takes none.
pub fn point_run(contestant: &Contestant, system: &System, duration: f64, fastest: f64) -> Option<PointRun> {
    if !contestant.takes_points() || system.body.points.is_empty() {
        return None;
    }
    let steepest = if fastest > 0.0 { TURN / fastest } else { duration };
    let step = steepest.min(duration / STEPS as f64);
    let precise = || {
        let plan = Plan { step, steps: PRECISE_STEPS, every: PRECISE_STEPS / 16 };
        let own = System::<DoubleDouble>::of(system).ok().filter(|own| own.body.is_of_its_points())?;
        Some(both(contestant, system, &own, &plan))
    };
    let precise = if contestant.runs_in_double_double() { precise() } else { None };
    let plan = Plan { step, steps: STEPS, every: STEPS / 20 };
    Some(precise.unwrap_or_else(|| both(contestant, system, system, &plan)))
}

fn both<T: Arithmetic>(contestant: &Contestant, system: &System, own: &System<T>, plan: &Plan) -> PointRun {
    let run = |form| {
        let mut states = Vec::new();
        contestant.stream_in(own, form, plan, &mut |state| states.push(*state));
        states
    };
    let (written, least) = (run(Form::Points), run(Form::Least));
    let of_f64 = |form| contestant.run(system, form, plan).states;
    let (f64_written, f64_least) = (of_f64(Form::Points), of_f64(Form::Least));
    let scales = scales(system, &f64_least);
    // Where one form breaks before the other they are not one scheme.
    let mut largest: f64 = if written.len() == least.len() { 0.0 } else { f64::INFINITY };
    let (mut stretch, mut change): (f64, f64) = (0.0, 0.0);
    for (a, b) in written.iter().zip(&least) {
        let apart = difference(&own.body, a, b).map(T::to_f64);
        largest = over(apart, &scales).fold(largest, super::larger);
        stretch = super::larger(stretch, a.stretch.to_f64());
        let changed = rotation::length(&(a.angular_momentum - own.start.angular_momentum));
        change = super::larger(change, changed.to_f64());
    }
    let finer = T::UNIT / f64::UNIT;
    let of_form = |form, own: &[Snapshot]| {
        over(copies::spread(contestant, (system, form), plan, own), &scales).fold(0.0, super::larger)
    };
    let rounding = of_form(Form::Points, &f64_written) + of_form(Form::Least, &f64_least);
    let momentum = rotation::length(&system.start.angular_momentum);
    // Half a unit for each of K − 1 sums, of the K + 1 operations that the centre of mass is known by, and of seven in a term.
    let units = system.body.points.len() as f64 + 4.0;
    let duration = plan.step * plan.steps as f64;
    let torque_rounding = units * T::UNIT * gravity(system) * moment_of_mass(system) * duration / momentum;
    PointRun {
        step: plan.step,
        steps: plan.steps,
        unit: T::UNIT,
        difference: largest,
        stretch,
        momentum_change: (system.torque_free() && momentum > 0.0).then_some(change / momentum),
        torque_rounding,
        rounding: rounding * finer,
    }
}

/// Each value over its scale.
fn over(values: PerQuantity<f64>, scales: &PerQuantity<f64>) -> impl Iterator<Item = f64> {
    values.zip(*scales).into_iter().map(|(_, (value, scale))| value / scale)
}

/// |g| of all laws [m/s²].
fn gravity(system: &System) -> f64 {
    let laws = system.forces.laws().iter();
    laws.filter_map(Law::uniform_acceleration).map(|acceleration| rotation::length(&acceleration)).sum()
}

/// Σ M_k |X̃_k| [kg m]: the size of what cancels in a torque of gravity.
fn moment_of_mass(system: &System) -> f64 {
    system.body.points.iter().map(|p| p.mass * rotation::length(&p.position)).sum()
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
