//! The same run in other worlds: turned, mirrored, shifted, boosted, in other units of mass, length and time, and with the same
//! body told in another way (points in another order, one split in two, its inertia in place of them).
//!
//! A scheme that is a rule of mechanics and not of its coordinates gives the same motion to rounding. In units that are
//! powers of two every sum, product and root is the same but for the exponent, so that the numbers agree
//! to the last bit. (The exponents are multiples of four, so that roots of roots are exact too.)

use nalgebra::Vector3;

use super::copies;
use super::reversal::worst;
use super::{Rung, steady_rung};
use crate::model::{Change, PerQuantity, Quantity, System, difference, retold, sizes};
use crate::record::OtherWorld;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Steps of a run.
const STEPS: u64 = 256;

/// How the turned world is turned.
const TURN: Vector3<f64> = Vector3::new(0.9, -1.3, 0.4);

/// A world with its name.
struct World {
    name: &'static str,
    /// From the scene's own world to this one.
    change: Change,
    /// The scene in it.
    system: System,
    form: Form,
    to_the_bit: bool,
}

/// Runs the scene in other worlds, for up to 256 steps of the coarsest run that follows the truth however it rounds; empty where there is
/// none.
pub fn other_worlds(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Vec<OtherWorld> {
    let Some(rung) = steady_rung(contestant, system, rungs, STEPS) else { return Vec::new() };
    let steps = rung.steps.min(STEPS);
    let run = |system: &System, form: Form, step: f64| {
        let run = contestant.run(system, form, &Plan { step, steps, every: steps });
        if run.outcome.broken.is_none() { run.states.last().copied() } else { None }
    };
    let Some(own) = run(system, Form::Least, rung.step) else { return Vec::new() };
    let solves = (rung.outcome.solves as f64 * steps as f64 / rung.steps as f64).round() as u64;
    let own_of_points = if contestant.takes_points() { run(system, Form::Points, rung.step) } else { None };
    let rounding = |form| rounding(contestant, (system, form), &Plan { step: rung.step, steps, every: 1 });
    let of_least = rounding(Form::Least);
    let of_points = own_of_points.map(|_| rounding(Form::Points));
    let compared = |world: World| {
        let (own, rounding) = match world.form {
            Form::Least => (own, of_least),
            Form::Points => (own_of_points?, of_points?),
        };
        let other = run(&world.system, world.form, rung.step * world.change.time);
        let mut row = OtherWorld {
            name: world.name.to_owned(),
            to_the_bit: world.to_the_bit,
            steps,
            solves,
            ..OtherWorld::default()
        };
        if let Some(other) = other.map(|end| world.change.undo(&end)) {
            let off =
                if own == other { PerQuantity::all(0.0) } else { difference(&system.body, &own, &other) };
            (row.of_rounding, row.worst) = worst(off, shifted(rounding, rung.step, steps, &world.change));
        }
        Some(row)
    };
    let worlds = worlds(system, rung.step * steps as f64).into_iter().chain(told(system));
    worlds.filter_map(compared).collect()
}

/// What rounding does to the run.
fn rounding(contestant: &Contestant, (system, form): (&System, Form), plan: &Plan) -> PerQuantity<f64> {
    let motion = contestant.run(system, form, plan).states;
    let spread = copies::spread(contestant, (system, form), plan, &motion);
    copies::rounding(&spread, &sizes(system, &motion), plan.steps)
}

/// What larger positions and velocities in the other world round off besides.
fn shifted(mut rounding: PerQuantity<f64>, step: f64, steps: u64, change: &Change) -> PerQuantity<f64> {
    let per_step = f64::EPSILON * steps as f64;
    let boost = rotation::length(&change.boost);
    let shift = rotation::length(&change.shift) + boost * step * steps as f64;
    rounding[Quantity::Position] += per_step * shift;
    rounding[Quantity::Velocity] += per_step * boost;
    rounding[Quantity::BodyPoint] += per_step * shift;
    rounding
}

/// The same body told in other ways, on the least model and on the points.
fn told(system: &System) -> Vec<World> {
    let told = |name, told: Option<System>, form| {
        told.map(|system| World { name, change: Change::none(), system, form, to_the_bit: false })
    };
    [
        told("permuted", retold::permuted(system), Form::Least),
        told("split", retold::split(system), Form::Least),
        told("by-inertia", retold::by_inertia(system), Form::Least),
        told("permuted-points", retold::permuted(system), Form::Points),
        told("split-points", retold::split(system), Form::Points),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The changes that leave a scene's laws what they are. Shift and boost are of the size of the body and of its motion.
fn worlds(system: &System, duration: f64) -> Vec<World> {
    let none = Change::none();
    let changed = |name, change: Change, to_the_bit| World {
        name,
        change,
        system: change.apply(system),
        form: Form::Least,
        to_the_bit,
    };
    let rough = |name, change| changed(name, change, false);
    let extent = system.body.extent();
    let units = |mass: f64, length: f64, time: f64| Change { mass, length, time, ..none };
    let turn = rotation::turn(&TURN);
    let mut worlds = vec![
        rough("turned", Change { turn, ..none }),
        rough("mirrored", units(1.0, -1.0, 1.0)),
        rough("shifted", Change { shift: Vector3::new(0.75, -1.25, 0.5) * extent, ..none }),
        changed("binary-units", units(16.0, 0.0625, 256.0), true),
        rough("mass-1e10", units(1e10, 1.0, 1.0)),
        rough("mass-1e-10", units(1e-10, 1.0, 1.0)),
        rough("length-1e10", units(1.0, 1e10, 1.0)),
        rough("length-1e-10", units(1.0, 1e-10, 1.0)),
        rough("time-1e10", units(1.0, 1.0, 1e10)),
        rough("time-1e-10", units(1.0, 1.0, 1e-10)),
    ];
    if Change::may_boost(system) {
        let boost = Vector3::new(-0.5, 1.0, 0.25) * (extent / duration);
        worlds.push(rough("boosted", Change { boost, ..none }));
    }
    worlds
}
