//! What is known of a system: its motion to many digits, and its condition.

use nalgebra::{Matrix3, Vector3};
use polhode::model::{Snapshot, System, difference};
use polhode::reference::precise::{self, AFFORDABLE, Moment};
use polhode::rotation;
use polhode::scenes::Scene;

pub type V = Vector3<f64>;

pub fn scene(name: &str) -> Scene {
    Scene::find(name).expect("a built-in scene")
}

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

/// |L|/I of the smallest moment above zero: |Ω| is no more than that. For a body as thin as 26 : 1 the formulas take the
/// difference of two such rates, which costs the 26.
pub fn fastest(system: &System) -> f64 {
    let moments = system.body.moments;
    let smallest = moments.iter().copied().filter(|x| *x > 0.0).fold(f64::INFINITY, f64::min);
    rotation::length(&system.start.angular_momentum) / smallest
}

/// What a relative change of L or of a moment by one unit becomes at each time, over 1 + |Ω| t and no less than 1.
pub fn condition(system: &System, states: &[Snapshot]) -> Vec<f64> {
    const CHANGE: f64 = 1e-12;
    let times: Vec<f64> = states.iter().map(|s| s.time).collect();
    let mut condition = vec![1.0f64; times.len()];
    for change in 0..6 {
        let mut other = system.clone();
        let principal = system.start.orientation * system.body.principal;
        let mut momentum = principal.inverse_transform_vector(&system.start.angular_momentum);
        let mut moments = system.body.moments;
        if change < 3 {
            momentum[change] *= 1.0 + CHANGE
        } else {
            moments[change - 3] *= 1.0 + CHANGE
        }
        other.start.angular_momentum = principal * momentum;
        let axes = system.body.principal.to_rotation_matrix().into_inner();
        other.body.inertia +=
            axes * Matrix3::from_diagonal(&(moments - system.body.moments)) * axes.transpose();
        for (j, (a, b)) in exact(&other, &times).iter().zip(states).enumerate() {
            let apart = difference(&system.body, a, b);
            let turned = 1.0 + rotation::length(&b.angular_velocity) * times[j];
            condition[j] = condition[j].max(apart[2] / CHANGE / turned);
        }
    }
    condition
}
