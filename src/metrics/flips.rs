//! Flips of a body that tumbles about its middle axis: the times at which the middle component of L in body
//! axes changes its sign.

use nalgebra::Vector3;

use crate::model::body::Shape;
use crate::model::{Snapshot, System};
use crate::rotation;
use crate::simulate::{Contestant, Plan};

/// Part of |L| along the middle axis from which a body counts as tumbling about it.
const TUMBLING: f64 = 0.9;
/// Coarsest and finest run: radians turned a step.
const TURNS: [f64; 5] = [0.02, 0.01, 0.005, 0.0025, 0.00125];

/// Flip times of one run.
#[derive(Clone, Debug, PartialEq)]
pub struct FlipRung {
    /// h [s].
    pub step: f64,
    /// Flip times [s].
    pub times: Vec<f64>,
}

/// Flips of a scheme beside those of the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Flips {
    /// Times in the reference [s].
    pub truth: Vec<f64>,
    /// Runs, step falling.
    pub rungs: Vec<FlipRung>,
}

/// The middle axis of a body that starts out tumbling about it freely, body axes; `None` for any other.
pub fn tumbling_axis(system: &System) -> Option<Vector3<f64>> {
    let body = &system.body;
    let (low, high) = (body.moments.imin(), body.moments.imax());
    if !system.torque_free() || body.shape != Shape::Extended || low == high {
        return None;
    }
    let middle = 3 - low - high;
    let distinct = |a: f64, b: f64| (a - b).abs() > 1e-6 * a.max(b);
    let (a, b, c) = (body.moments[low], body.moments[middle], body.moments[high]);
    let axis = body.principal * Vector3::ith(middle, 1.0);
    let part = system.start.orientation.inverse_transform_vector(&system.start.angular_momentum).dot(&axis);
    let tumbling = part.abs() > TUMBLING * rotation::length(&system.start.angular_momentum);
    (distinct(a, b) && distinct(b, c) && tumbling).then_some(axis)
}

/// Finds the times at which L along an axis of the body changes its sign, from states as they come, by cubic
/// Hermite interpolation between two of them: in body axes L' = L × Ω.
pub struct FlipFinder {
    axis: Vector3<f64>,
    last: Option<(f64, (f64, f64))>,
    /// Times found [s].
    pub times: Vec<f64>,
}

impl FlipFinder {
    /// A finder for flips of `axis`, body axes.
    pub fn new(axis: Vector3<f64>) -> FlipFinder {
        FlipFinder { axis, last: None, times: Vec::new() }
    }

    /// Takes the next state.
    pub fn push(&mut self, state: &Snapshot) {
        let momentum = state.orientation.inverse_transform_vector(&state.angular_momentum);
        let spin = state.orientation.inverse_transform_vector(&state.angular_velocity);
        let now = (momentum.dot(&self.axis), momentum.cross(&spin).dot(&self.axis));
        if let Some((time, before)) = self.last
            && before.0 != 0.0
            && before.0.signum() != now.0.signum()
        {
            self.times.push(hermite_root(time, state.time, before, now));
        }
        self.last = Some((state.time, now));
    }
}

/// Root of the cubic with these values and slopes at `t0` and `t1`, by bisection.
fn hermite_root(t0: f64, t1: f64, (v0, d0): (f64, f64), (v1, d1): (f64, f64)) -> f64 {
    let span = t1 - t0;
    let cubic = |x: f64| {
        let y = 1.0 - x;
        v0 * y * y * (1.0 + 2.0 * x) + d0 * span * x * y * y + v1 * x * x * (1.0 + 2.0 * y)
            - d1 * span * x * x * y
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if cubic(middle).signum() == v0.signum() { low = middle } else { high = middle }
    }
    t0 + span * 0.5 * (low + high)
}

/// Runs a scheme at five steps and finds its flips; `truth` are those of the reference.
pub fn flips(
    contestant: &Contestant,
    system: &System,
    duration: f64,
    fastest: f64,
    truth: Vec<f64>,
) -> Option<Flips> {
    let axis = tumbling_axis(system)?;
    let model = contestant.model(system);
    let rungs = TURNS.map(|turn| {
        let steps = (duration * fastest / turn).ceil() as u64;
        let plan = Plan { step: duration / steps as f64, steps, every: 1 };
        let mut finder = FlipFinder::new(axis);
        contestant.stream(&model, &plan, &mut |state| finder.push(state));
        FlipRung { step: plan.step, times: finder.times }
    });
    Some(Flips { truth, rungs: rungs.to_vec() })
}
