//! The same run in other worlds: turned, mirrored, shifted, boosted, and in other units of mass, length and time.
//!
//! A scheme that is a rule of mechanics and not of its coordinates gives the same motion to rounding. In units that are
//! powers of two every sum, product and root is the same but for the exponent, so that the numbers agree
//! to the last bit. (The exponents are multiples of four, so that roots of roots are exact too.)

use nalgebra::Vector3;

use super::rounding::{rounding_growth, roundings};
use super::{Place, Rung, larger, steady_rung};
use crate::model::{Change, Quantity, Snapshot, System, difference};
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Steps of a run.
const STEPS: u64 = 256;
/// States of it that say how roundings grow.
const SAMPLES: u64 = 16;

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
}

/// A change of world and its name.
struct World {
    name: &'static str,
    change: Change,
    to_the_bit: bool,
}

/// Runs the scene in other worlds, for up to 256 steps of the coarsest run that follows the truth; empty where there is
/// none.
pub fn other_worlds(contestant: &Contestant, system: &System, rungs: &[Rung]) -> Vec<OtherWorld> {
    let Some(rung) = steady_rung(system, rungs) else { return Vec::new() };
    let steps = rung.steps.min(STEPS);
    let run = |system: &System, step: f64| {
        let run = contestant.run(system, Form::Least, &Plan { step, steps, every: steps });
        (run.outcome.broken.is_none()).then(|| run.states[run.states.len() - 1])
    };
    let Some(own) = run(system, rung.step) else { return Vec::new() };
    // The ladder's floors are those of finer runs, which may be steadier.
    let plan = Plan { step: rung.step, steps, every: (steps / SAMPLES).max(1) };
    let motion = contestant.run(system, Form::Least, &plan).states;
    let growth = rounding_growth(contestant, system, &motion, &plan);
    let turned = motion.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
    let roundings = roundings(system, steps, turned * rung.step * steps as f64);
    let growth: [f64; 6] = std::array::from_fn(|index| growth[index].max * roundings[index]);
    let compared = |world: World| {
        let change = &world.change;
        let other = run(&change.apply(system), rung.step * change.time).map(|end| change.undo(&end));
        let floors = floors(rung, &growth, steps, change);
        compare(system, &world, &own, other.as_ref(), &floors)
    };
    worlds(system, rung.step * steps as f64).into_iter().map(compared).collect()
}

fn compare(
    system: &System,
    world: &World,
    own: &Snapshot,
    other: Option<&Snapshot>,
    floors: &[f64; 6],
) -> OtherWorld {
    let mut row = OtherWorld {
        name: world.name,
        to_the_bit: world.to_the_bit,
        of_floor: if other.is_some() { 0.0 } else { f64::NAN },
        quantity: Quantity::BodyPoint,
        difference: f64::NAN,
    };
    let Some(other) = other else { return row };
    if own == other {
        row.difference = 0.0;
        return row;
    }
    for ((value, floor), quantity) in
        difference(&system.body, own, other).into_iter().zip(floors).zip(Quantity::ALL)
    {
        let ratio = if value == 0.0 { 0.0 } else { value / floor };
        if row.difference.is_nan() || ratio.is_nan() || ratio > row.of_floor {
            (row.quantity, row.difference) = (quantity, value);
        }
        row.of_floor = larger(row.of_floor, ratio);
    }
    row
}

/// The floors of the run's own ladder, and what larger positions and velocities in the other world round off.
fn floors(rung: &Rung, growth: &[f64; 6], steps: u64, change: &Change) -> [f64; 6] {
    let mut floors: [f64; 6] =
        std::array::from_fn(|index| Place::Max.of(&rung.floors[index]).max(growth[index]));
    let per_step = f64::EPSILON * steps as f64;
    let boost = rotation::length(&change.boost);
    let shift = rotation::length(&change.shift) + boost * rung.step * steps as f64;
    floors[0] += per_step * shift;
    floors[1] += per_step * boost;
    floors[5] += per_step * shift;
    floors
}

/// The changes that leave a scene's laws what they are. Shift and boost are of the size of the body and of its motion.
fn worlds(system: &System, duration: f64) -> Vec<World> {
    let none = Change::none();
    let rough = |name, change| World { name, change, to_the_bit: false };
    let extent = system.body.extent();
    let units = |mass: f64, length: f64, time: f64| Change { mass, length, time, ..none };
    let turn = rotation::turn(&Vector3::new(0.9, -1.3, 0.4));
    let mut worlds = vec![
        rough("turned", Change { turn, ..none }),
        rough("mirrored", units(1.0, -1.0, 1.0)),
        rough("shifted", Change { shift: Vector3::new(0.75, -1.25, 0.5) * extent, ..none }),
        World { name: "binary-units", change: units(16.0, 0.0625, 256.0), to_the_bit: true },
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
