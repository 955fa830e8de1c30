//! The same run in other worlds: turned, mirrored, shifted, boosted, in other units of mass, length and time, and with the same
//! body told in another way (points in another order, one split in two, its inertia in place of them).
//!
//! A scheme that is a rule of mechanics and not of its coordinates gives the same motion to rounding. In units that are
//! powers of two every sum, product and root is the same but for the exponent, so that the numbers agree
//! to the last bit. (The exponents are multiples of four, so that roots of roots are exact too.)

use nalgebra::Vector3;

use super::moved_starts::shaken_bodies;
use super::rounding::{self, Adding, roundings};
use super::{Place, Rung, SHAKEN, larger, steady_rung};
use crate::model::body::Shape;
use crate::model::{Change, PerQuantity, Quantity, Snapshot, System, difference, retold};
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Steps of a run.
const STEPS: u64 = 256;
/// States of it that say how roundings grow.
const SAMPLES: u64 = 16;

/// How the turned world is turned.
const TURN: Vector3<f64> = Vector3::new(0.9, -1.3, 0.4);
/// Rounding of a moment of inertia, over the largest one: those of a sum over the points and of an eigenvalue.
const INERTIA_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A run in another world beside the run in the scene's own.
#[derive(Clone, Debug)]
pub struct OtherWorld {
    /// Name of the change.
    pub name: &'static str,
    /// Whether the arithmetic allows no difference at all.
    pub to_the_bit: bool,
    /// Largest difference at the end over its floor, of all quantities; NaN where the run broke.
    pub of_floor: f64,
    /// The quantity that it belongs to.
    pub quantity: Quantity,
    /// The difference itself.
    pub difference: f64,
    /// Steps of the run.
    pub steps: u64,
    /// Implicit equations that were solved in the scene's own world.
    pub solves: u64,
}

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
    let rounding = rounding(contestant, system, rung, steps);
    // The points, and what is summed over them, round to something else in every telling.
    let of_points = own_of_points.map(|own| {
        shaken_bodies(system, &[own], SHAKEN).fold(PerQuantity::all(0.0), |largest, shaken| {
            let Some(end) = run(&shaken, Form::Points, rung.step) else { return largest };
            largest.max(difference(&system.body, &own, &end))
        })
    });
    let compared = |world: World| {
        let own = if world.form == Form::Least { &own } else { own_of_points.as_ref()? };
        let step = rung.step * world.change.time;
        let other = run(&world.system, world.form, step).map(|end| world.change.undo(&end));
        let mut floors = floors(rung, &rounding, steps, &world);
        if let (Form::Points, Some(of_points)) = (world.form, &of_points) {
            floors = floors.max(*of_points);
        }
        Some(OtherWorld { steps, solves, ..compare(system, &world, own, other.as_ref(), &floors) })
    };
    let worlds = worlds(system, rung.step * steps as f64).into_iter().chain(told(system));
    worlds.filter_map(compared).collect()
}

/// What roundings become in this very run, of every step and of the inertia at its start: the ladder's floors are those of finer
/// runs, which may be steadier.
struct Rounding {
    of_steps: PerQuantity<f64>,
    of_inertia: PerQuantity<f64>,
}

fn rounding(contestant: &Contestant, system: &System, rung: &Rung, steps: u64) -> Rounding {
    let plan = Plan { step: rung.step, steps, every: (steps / SAMPLES).max(1) };
    let motion = contestant.run(system, Form::Least, &plan).states;
    let measured = rounding::Rounding::measure(contestant, system, &motion, &plan);
    let (growth, drawn) = (measured.growth(), measured.drawn_at(steps, Adding::Alike));
    let fastest = motion.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
    let turned = fastest * rung.step * steps as f64;
    let phase = turned + system.forces.fastest_clock() * rung.step * steps as f64;
    let roundings = roundings(system, steps, phase);
    // A moment is good to a few roundings of the largest one, and its part of Ω no better.
    let moments = system.body.moments;
    let condition = if system.body.shape == Shape::Extended { moments.max() / moments.min() } else { 1.0 };
    let of_inertia = INERTIA_ROUNDING * condition * (1.0 + turned);
    Rounding {
        of_steps: PerQuantity::of(|quantity| {
            drawn[quantity].max.max(growth[quantity].max * roundings[quantity])
        }),
        of_inertia: growth.map(|growth| growth.max * of_inertia),
    }
}

fn compare(
    system: &System,
    world: &World,
    own: &Snapshot,
    other: Option<&Snapshot>,
    floors: &PerQuantity<f64>,
) -> OtherWorld {
    let mut row = OtherWorld {
        name: world.name,
        to_the_bit: world.to_the_bit,
        of_floor: if other.is_some() { 0.0 } else { f64::NAN },
        quantity: Quantity::BodyPoint,
        difference: f64::NAN,
        steps: 0,
        solves: 0,
    };
    let Some(other) = other else { return row };
    if own == other {
        row.difference = 0.0;
        return row;
    }
    for (quantity, (value, floor)) in difference(&system.body, own, other).zip(*floors) {
        let ratio = if value == 0.0 { 0.0 } else { value / floor };
        if row.difference.is_nan() || ratio.is_nan() || ratio > row.of_floor {
            (row.quantity, row.difference) = (quantity, value);
        }
        row.of_floor = larger(row.of_floor, ratio);
    }
    row
}

/// The floors of the run's own ladder, and what larger positions and velocities in the other world round off.
fn floors(rung: &Rung, rounding: &Rounding, steps: u64, world: &World) -> PerQuantity<f64> {
    let change = &world.change;
    let told = if *change == Change::none() { rounding.of_inertia } else { PerQuantity::all(0.0) };
    let mut floors = PerQuantity::of(|quantity| {
        Place::Max.of(&rung.floors[quantity]).max(rounding.of_steps[quantity]) + told[quantity]
    });
    let per_step = f64::EPSILON * steps as f64;
    let boost = rotation::length(&change.boost);
    let shift = rotation::length(&change.shift) + boost * rung.step * steps as f64;
    floors[Quantity::Position] += per_step * shift;
    floors[Quantity::Velocity] += per_step * boost;
    floors[Quantity::BodyPoint] += per_step * shift;
    floors
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
