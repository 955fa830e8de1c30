//! What is known of a system: its motion to many digits, and its condition.

use nalgebra::{Matrix3, Vector3};
use polhode::internals::reference::precise::{self, AFFORDABLE, Moment};
use polhode::internals::rotation;
use polhode::model::body::{Body, MassPoint};
use polhode::model::forces::{Forces, Gravity, Law};
use polhode::model::{Quantity, Snapshot, Spin, System, difference};

pub type V = Vector3<f64>;

/// A top at rest in the world at the origin, its pivot.
pub fn top(points: &[[f64; 4]], turn: V, momentum: V, gravity: V) -> System {
    let given: Vec<_> =
        points.iter().map(|[m, x, y, z]| MassPoint { mass: *m, position: V::new(*x, *y, *z) }).collect();
    let body = Body::from_points(&given, Some(V::zeros())).expect("a body").0;
    let orientation = rotation::turn(&turn);
    let position = orientation * body.center;
    let law = Law::Gravity(Gravity { acceleration: gravity });
    System::new(body, vec![law], position, orientation, V::zeros(), Spin::Momentum(momentum))
        .expect("a system")
}

pub const BLADES: [[f64; 4]; 4] =
    [[0.5, 0.5, 0.0, 1.0], [0.5, -0.5, 0.0, 1.0], [0.5, 0.0, 0.5, 1.0], [0.5, 0.0, -0.5, 1.0]];
pub const SIDEWAYS: [[f64; 4]; 4] =
    [[0.5, -1.0, 0.5, 0.0], [0.5, -1.0, -0.5, 0.0], [0.5, -1.0, 0.0, 0.5], [0.5, -1.0, 0.0, -0.5]];
pub const ROD: [[f64; 4]; 2] = [[1.0, 0.0, 0.0, 0.5], [2.0, 0.0, 0.0, 1.0]];

pub fn grid(duration: f64) -> Vec<f64> {
    (1..=64).map(|j| f64::from(j) * duration / 64.0).collect()
}

pub fn exact(system: &System, times: &[f64]) -> Vec<Snapshot> {
    let motion = precise::solve(system, times, 100.0 * AFFORDABLE).expect("a motion");
    motion.moments.iter().map(Moment::snapshot).collect()
}

/// The angle that a motion turns through, at most [rad].
pub fn turned(states: &[Snapshot], duration: f64) -> f64 {
    duration * states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max)
}

/// What the bounds of these tests are counted in: rounding units for every radian turned and one more, or for what a change
/// of one datum by a rounding unit makes of the motion, whichever is more. A closed form in f64 takes a dozen or two
/// of roundings, whose squares add up. Measured: up to 5.
pub const UNITS: f64 = 8.0;

/// Relative change by which a datum is moved; what comes of it is taken over it.
pub const CHANGE: f64 = 1e-12;

/// The angle turned through until each of `states`, from |Ω| [rad].
pub fn radians(states: &[Snapshot]) -> Vec<f64> {
    let (mut sum, mut before) = (0.0, 0.0);
    let passed = states.iter().map(|state| {
        sum += rotation::length(&state.angular_velocity) * (state.time - before);
        before = state.time;
        sum
    });
    passed.collect()
}

/// The same system with one datum off by [`CHANGE`] of itself: a part of L along a principal axis, a moment, gravity.
pub fn moved(system: &System) -> Vec<System> {
    let principal = system.start.orientation * system.body.principal;
    let momentum = principal.inverse_transform_vector(&system.start.angular_momentum);
    let axes = system.body.principal.to_rotation_matrix().into_inner();
    let mut all = Vec::new();
    for i in 0..3 {
        let mut other = system.clone();
        let more = V::ith(i, CHANGE * momentum[i]);
        other.start.angular_momentum += principal * more;
        all.push(other);
        let mut other = system.clone();
        let more = V::ith(i, CHANGE * system.body.moments[i]);
        other.body.inertia += axes * Matrix3::from_diagonal(&more) * axes.transpose();
        all.push(other);
    }
    if let [Law::Gravity(gravity)] = system.forces.laws() {
        let mut other = system.clone();
        let stronger = Law::Gravity(Gravity { acceleration: gravity.acceleration * (1.0 + CHANGE) });
        other.forces = Forces::new(vec![stronger], &system.body);
        all.push(other);
    }
    all
}

/// What a relative change of one datum by one unit becomes at each time: the largest angle over the change.
pub fn amplification(system: &System, states: &[Snapshot]) -> Vec<f64> {
    let times: Vec<f64> = states.iter().map(|s| s.time).collect();
    let mut largest = vec![0.0f64; times.len()];
    for other in moved(system) {
        for (j, (a, b)) in exact(&other, &times).iter().zip(states).enumerate() {
            largest[j] = largest[j].max(difference(&system.body, a, b)[Quantity::Orientation] / CHANGE);
        }
    }
    largest
}
