//! The floor of an error: what rounding and the reference leave undecided.
//!
//! Rounding is measured: the start is moved a little in fixed directions, and the growth of the difference over the run says
//! what a rounding of each step becomes. n steps leave about √n roundings, but n of them where every step is the same and
//! rounds the same way: the rotation in a steady spin, the translation under a constant force. The rounding of h turns
//! the phase by u |Ω| T.
//!
//! In steps of many radians a rounding within the step may grow by powers of the angle before the step is over. There the
//! whole rounding is measured: the same run in turned worlds differs from itself by nothing else.

use nalgebra::Vector3;

use super::Reading;
use super::ladder::apart;
use crate::model::{Change, Snapshot, Start, System, difference};
use crate::reference::Reference;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Sizes of the displacements that measure how roundings grow, relative: the first that does not grow to the size of the motion.
const DISPLACEMENTS: [f64; 3] = [1e-7, 1e-10, 1e-13];
/// Part of the motion's size from which on a difference no longer grows as a small one would.
const SATURATED: f64 = 0.05;
/// Turned worlds that roundings are measured in: the largest of a few samples is too small as often as they are few.
pub(super) const TURNS: [Vector3<f64>; 5] = [
    Vector3::new(0.9, -1.3, 0.4),
    Vector3::new(-0.2, 0.7, 1.9),
    Vector3::new(2.1, 0.3, -0.8),
    Vector3::new(-1.1, -0.6, 0.5),
    Vector3::new(0.3, 1.6, -1.4),
];
/// Directions of displacement, and turned worlds.
const DIRECTIONS: usize = 3;
/// Relative difference of a run in a turned world from which on it is no rounding, whatever a giant step makes of it.
const NO_ROUNDING: f64 = 1e-3;
/// What the iteration of an implicit equation may leave, relative.
const SOLVED_TO: f64 = 1e-12;

/// How many times larger a relative displacement of the start is at the end and at its largest, per quantity. `motion` says how
/// large everything gets.
pub(super) fn rounding_growth(
    contestant: &Contestant,
    system: &System,
    motion: &[Snapshot],
    plan: &Plan,
) -> [Reading; 6] {
    let undisturbed = contestant.run(system, Form::Least, plan);
    let mut grown = [Reading { end: 0.0, max: 0.0 }; 6];
    for displacement in DISPLACEMENTS {
        grown = [Reading { end: 0.0, max: 0.0 }; 6];
        let mut largest: f64 = 0.0;
        for direction in 0..DIRECTIONS {
            let displaced = displaced(system, motion, direction, displacement);
            let moved = contestant.run(&displaced, Form::Least, plan);
            let by = apart(system, &moved.states, &undisturbed.states);
            largest = largest.max(by[2].max).max(by[0].max / reach(system, motion));
            for (reading, by) in grown.iter_mut().zip(by) {
                reading.end = reading.end.max(by.end / displacement);
                reading.max = reading.max.max(by.max / displacement);
            }
        }
        if largest < SATURATED {
            break;
        }
    }
    grown
}

/// How far the body gets [m].
fn reach(system: &System, motion: &[Snapshot]) -> f64 {
    motion.iter().map(|s| s.position.amax()).fold(system.body.extent(), f64::max)
}

/// The system started a little off in everything that rounding touches, in one of a few fixed directions.
fn displaced(system: &System, motion: &[Snapshot], direction: usize, displacement: f64) -> System {
    let directions: [Vector3<f64>; DIRECTIONS] =
        [Vector3::new(0.36, 0.48, 0.8), Vector3::new(0.8, -0.6, 0.0), Vector3::new(-0.48, -0.64, 0.6)];
    let along =
        |scale: f64, shift: usize| directions[(direction + shift) % DIRECTIONS] * (scale * displacement);
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    let change = Start {
        position: along(reach(system, motion), 1),
        velocity: along(largest(|s| s.velocity.amax()), 2),
        angular_momentum: along(largest(|s| s.angular_momentum.amax()), 1),
        orientation: system.start.orientation,
    };
    system.displaced(&along(1.0, 0), &change)
}

/// What the roundings of `steps` steps over `turned` radians add up to, relative, for each quantity.
pub(super) fn roundings(system: &System, steps: u64, turned: f64) -> [f64; 6] {
    let steps = steps as f64;
    let add = |alike: bool| f64::EPSILON * (if alike { steps } else { steps.sqrt() } + 0.5 * turned);
    let (constant_force, _) = system.constant_force();
    let (translation, rotation) = (add(constant_force), add(system.steady_spin()));
    [translation, translation, rotation, rotation, rotation, translation.max(rotation)]
}

/// The larger of the reference's uncertainty and what roundings become.
///
/// A body point is off by no more than the centre of mass and the body's size times the angle, and the two may have very different
/// roundings.
pub(super) fn floors(
    system: &System,
    reference: &Reference,
    growth: &[Reading; 6],
    roundings: [f64; 6],
) -> [Reading; 6] {
    let last = reference.uncertainty[reference.uncertainty.len() - 1];
    let mut floors = *growth;
    let size = 2.0 * system.body.extent();
    let of_point = |place: fn(&Reading) -> f64| {
        let of_parts = place(&growth[0]) * roundings[0] + size * place(&growth[2]) * roundings[2];
        of_parts.min(place(&growth[5]) * roundings[5]) / roundings[5]
    };
    floors[5] = Reading { end: of_point(|reading| reading.end), max: of_point(|reading| reading.max) };
    for (index, floor) in floors.iter_mut().enumerate() {
        let largest = reference.uncertainty.iter().map(|u| u[index]).fold(0.0, f64::max);
        *floor = Reading {
            end: (floor.end * roundings[index]).max(last[index]),
            max: (floor.max * roundings[index]).max(largest),
        };
    }
    floors
}

/// What rounding does to a run in giant steps: how far it ends from `own` in turned worlds, at most. Nothing where that is too
/// far for rounding, which then is a defect that the floor must not hide.
pub(super) fn of_giant_steps(
    contestant: &Contestant,
    system: &System,
    plan: &Plan,
    own: Option<&Snapshot>,
) -> [f64; 6] {
    let mut largest = [0.0; 6];
    let Some(own) = own else { return largest };
    let spin = rotation::length(&own.angular_velocity);
    for turn in TURNS {
        let change = Change { turn: rotation::turn(&turn), ..Change::none() };
        let run = contestant.run(&change.apply(system), Form::Least, plan);
        let Some(end) = run.states.last().filter(|_| run.outcome.broken.is_none()) else { continue };
        let apart = difference(&system.body, &change.undo(end), own);
        if apart[3] <= NO_ROUNDING * spin && apart[2] <= NO_ROUNDING {
            largest = std::array::from_fn(|index| largest[index].max(apart[index]));
        }
        // Every world leaves the same of an implicit equation.
        let left = run.outcome.solves as f64 * SOLVED_TO;
        (largest[2], largest[3]) = (largest[2].max(left), largest[3].max(left * spin));
    }
    largest
}
