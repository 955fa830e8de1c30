//! What an engine answers, and whether that is an answer: right id, right steps, right lengths, finite numbers.

use nalgebra::{Quaternion, Vector3};
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::error::Fault;
use super::precision::Precision;
use crate::model::{Snapshot, System};
use crate::rotation::{self, Rotation};
use crate::simulate::Plan;

/// Bytes of a reply besides its states …
const SLACK: u64 = 1 << 16;
/// … and of a state at the most: 13 numbers of 25 digits, six keys, and as much again.
const STATE_BYTES: u64 = 1 << 10;
/// Longest reply of all [bytes].
const MOST_BYTES: u64 = 1 << 30;
/// Length of an orientation, less one, up to which it is one: single precision that is not renormalised stays
/// below.
const UNIT: f64 = 1e-3;

/// A reply that keeps to the protocol.
#[derive(Debug)]
pub(super) enum Answer {
    /// The run.
    States(States),
    /// The engine cannot take the scene.
    Refused(String),
    /// The run broke.
    Failed {
        /// Why.
        why: String,
        /// In which step, where it says so.
        step: Option<u64>,
    },
}

/// The states of a run, and what it cost.
#[derive(Debug)]
pub(super) struct States {
    /// The first, every K-th and the last.
    pub states: Vec<Snapshot>,
    /// The engine's own time [ns].
    pub nanoseconds: Option<u64>,
    /// Evaluations of the forces; 0 where it does not say.
    pub evaluations: u64,
    /// What precision its numbers have.
    pub precision: Precision,
    /// Largest distance of the length of a quaternion from one, before it was normalised.
    pub off_unit: f64,
}

#[derive(Deserialize)]
struct Reply {
    id: Option<u64>,
    states: Option<Vec<State>>,
    refused: Option<String>,
    failed: Option<String>,
    step: Option<u64>,
    elapsed_ns: Option<f64>,
    evaluations: Option<f64>,
}

#[derive(Deserialize)]
struct State {
    step: u64,
    position: Vec<f64>,
    orientation: Vec<f64>,
    velocity: Vec<f64>,
    angular_velocity: Vec<f64>,
}

impl State {
    fn numbers(&self) -> impl Iterator<Item = f64> {
        [&self.position, &self.orientation, &self.velocity, &self.angular_velocity]
            .into_iter()
            .flatten()
            .copied()
    }

    /// How far its quaternion is off unit length.
    fn off_unit(&self) -> f64 {
        (self.orientation.iter().map(|x| x * x).sum::<f64>().sqrt() - 1.0).abs()
    }
}

/// Longest answer to a run [bytes].
pub(super) fn most_bytes(plan: &Plan) -> usize {
    (SLACK + STATE_BYTES.saturating_mul(steps_stored(plan).count)).min(MOST_BYTES) as usize
}

/// A line as an object.
pub(super) fn object<T: DeserializeOwned>(line: &[u8]) -> Result<T, Fault> {
    let why = match serde_json::from_slice(line) {
        Ok(value) => return Ok(value),
        Err(error) if error.is_data() => format!("the answer is not as the protocol has it: {error}"),
        Err(error) if error.is_eof() => format!("the answer is cut: {error}"),
        Err(error) => format!("the answer is not JSON: {error}"),
    };
    let text = String::from_utf8_lossy(&line[..line.len().min(1 << 16)]).into_owned();
    let not_a_number = ["NaN", "Infinity", "nan", "inf"].into_iter().find(|word| text.contains(word));
    let beginning: String = text.chars().take(60).collect();
    Err(Fault::Protocol(match not_a_number {
        Some(word) => format!("{why}; it holds {word}, which is not a finite number"),
        None => format!("{why}; it begins: {beginning}"),
    }))
}

/// Reads the answer to question `id`.
pub(super) fn read(line: &[u8], id: u64, system: &System, plan: &Plan) -> Result<Answer, Fault> {
    let reply: Reply = object(line)?;
    let against = |why: String| Err(Fault::Protocol(why));
    match reply.id {
        Some(given) if given == id => {}
        Some(given) => return against(format!("the answer has the id {given}, asked was {id}")),
        None => return against(format!("the answer has no id; asked was {id}")),
    }
    match (reply.states, reply.refused, reply.failed) {
        (Some(states), None, None) => Ok(Answer::States(States {
            precision: states.iter().flat_map(State::numbers).collect(),
            off_unit: states.iter().map(State::off_unit).fold(0.0, f64::max),
            states: snapshots(&states, system, plan)?,
            nanoseconds: count(reply.elapsed_ns, "elapsed_ns")?,
            evaluations: count(reply.evaluations, "evaluations")?.unwrap_or(0),
        })),
        (None, Some(why), None) => Ok(Answer::Refused(why)),
        (None, None, Some(why)) => Ok(Answer::Failed { why, step: reply.step }),
        _ => against("the answer has not one of \"states\", \"refused\" and \"failed\", alone".to_owned()),
    }
}

fn count(value: Option<f64>, key: &str) -> Result<Option<u64>, Fault> {
    match value {
        Some(value) if !(0.0..1e18).contains(&value) => {
            Err(Fault::Protocol(format!("\"{key}\" is {value}, not a number from 0 on")))
        }
        other => Ok(other.map(|value| value as u64)),
    }
}

/// The steps whose states are stored.
struct StepsStored {
    every: u64,
    steps: u64,
    count: u64,
}

fn steps_stored(plan: &Plan) -> StepsStored {
    let every = plan.every.max(1);
    StepsStored { every, steps: plan.steps, count: plan.steps.div_ceil(every) + 1 }
}

impl StepsStored {
    fn step(&self, index: u64) -> u64 {
        index.saturating_mul(self.every).min(self.steps)
    }
}

fn snapshots(states: &[State], system: &System, plan: &Plan) -> Result<Vec<Snapshot>, Fault> {
    let expected = steps_stored(plan);
    if states.len() as u64 != expected.count {
        return Err(Fault::Protocol(format!(
            "the answer has {} states; {} steps with every {} are {} states: the first, every K-th and the last",
            states.len(),
            plan.steps,
            expected.every,
            expected.count
        )));
    }
    states.iter().zip(0..).map(|(state, index)| snapshot(state, expected.step(index), system, plan)).collect()
}

fn snapshot(state: &State, step: u64, system: &System, plan: &Plan) -> Result<Snapshot, Fault> {
    if state.step != step {
        return Err(Fault::Protocol(format!("a state is of step {}, expected is step {step}", state.step)));
    }
    let vector = |values: &[f64], key| numbers::<3>(values, key, step).map(Vector3::from);
    let [w, x, y, z] = numbers::<4>(&state.orientation, "orientation", step)?;
    let quaternion = Quaternion::new(w, x, y, z);
    let length = quaternion.norm();
    if (length - 1.0).abs() > UNIT {
        return Err(Fault::Protocol(format!("the orientation of step {step} has length {length}, not 1")));
    }
    let orientation = Rotation::new_normalize(quaternion);
    let angular_velocity = vector(&state.angular_velocity, "angular_velocity")?;
    Ok(Snapshot {
        time: step as f64 * plan.step,
        position: vector(&state.position, "position")?,
        velocity: vector(&state.velocity, "velocity")?,
        orientation,
        angular_velocity,
        angular_momentum: momentum(system, &orientation, &angular_velocity),
        stretch: 0.0,
    })
}

/// L = R I Rᵀ Ω [kg m²/s], about the centre of mass or the pivot.
pub(super) fn momentum(system: &System, orientation: &Rotation, spin: &Vector3<f64>) -> Vector3<f64> {
    orientation * (system.body.inertia * orientation.inverse_transform_vector(spin))
}

fn numbers<const N: usize>(values: &[f64], key: &str, step: u64) -> Result<[f64; N], Fault> {
    let array: [f64; N] = values.try_into().map_err(|_| {
        Fault::Protocol(format!("{key} of step {step} has {} numbers, expected are {N}", values.len()))
    })?;
    match array.iter().find(|value| !value.is_finite()) {
        Some(value) => {
            Err(Fault::Protocol(format!("{key} of step {step} holds {value}, which is not finite")))
        }
        None => Ok(array),
    }
}

/// How far the first state is from where the run was to start: of the position, relative, and of the
/// orientation [rad].
pub(super) fn off_start(system: &System, first: &Snapshot) -> (f64, f64) {
    let start = &system.start;
    let size = rotation::length(&start.position).max(system.body.extent());
    (
        rotation::length(&(first.position - start.position)) / size,
        rotation::angle_between(&first.orientation, &start.orientation),
    )
}
