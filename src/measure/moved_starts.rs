//! Starts that are moved a little: by so much that their growth can be measured, or by so little that nothing changes but roundings.

use nalgebra::Vector3;

use crate::model::{Snapshot, Start, System, retold};
use crate::rotation;

/// Displacement that changes the last digits of everything and nothing else, relative.
const SHAKE: f64 = 4.0 * f64::EPSILON;
/// Directions of displacement.
pub(super) const DIRECTIONS: usize = 3;

/// The system started a few rounding units off, in so many ways: after the first step every rounding is another, and nothing else is.
pub(super) fn shaken_starts(
    system: &System,
    motion: &[Snapshot],
    ways: usize,
) -> impl Iterator<Item = System> {
    (0..ways).map(move |way| displaced(system, motion, way, SHAKE))
}

/// The same with every point of the body as far off: what is summed over them rounds to something else too.
pub(super) fn shaken_bodies(
    system: &System,
    motion: &[Snapshot],
    ways: usize,
) -> impl Iterator<Item = System> {
    (0..ways).map(move |way| {
        let moved = retold::moved(system, SHAKE, way);
        displaced(moved.as_ref().unwrap_or(system), motion, way, SHAKE)
    })
}

/// How far the body gets [m].
pub(super) fn reach(system: &System, motion: &[Snapshot]) -> f64 {
    motion.iter().map(|s| s.position.amax()).fold(system.body.extent(), f64::max)
}

/// The system started a little off in everything that rounding touches, in one of a few fixed directions and
/// their opposites.
pub(super) fn displaced(system: &System, motion: &[Snapshot], direction: usize, displacement: f64) -> System {
    let directions: [Vector3<f64>; DIRECTIONS] =
        [Vector3::new(0.36, 0.48, 0.8), Vector3::new(0.8, -0.6, 0.0), Vector3::new(-0.48, -0.64, 0.6)];
    let sign = if direction < DIRECTIONS { displacement } else { -displacement };
    let along = |scale: f64, shift: usize| directions[(direction + shift) % DIRECTIONS] * (scale * sign);
    let largest = |value: fn(&Snapshot) -> f64| motion.iter().map(value).fold(0.0, f64::max);
    // Forces that read the velocities of points round off as those do, though the centre of mass stand still.
    let of_points = system.forces.read_velocity();
    let fastest = largest(|s| rotation::length(&s.angular_velocity)) * system.body.extent();
    let velocity = largest(|s| s.velocity.amax()).max(if of_points { fastest } else { 0.0 });
    let change = Start {
        position: along(reach(system, motion), 1),
        velocity: along(velocity, 2),
        angular_momentum: along(largest(|s| s.angular_momentum.amax()), 1),
        orientation: system.start.orientation,
    };
    system.displaced(&along(1.0, 0), &change)
}
