//! What a figure measures, as numbers in its unit.

use nalgebra::Vector3;

use super::PublishedError;
use super::data::{Figure, Measure, Observation, numbers};
use super::motion::{Motion, truth_at};
use super::period;
use crate::model::{Snapshot, System};
use crate::rotation::{self, Rotation};

/// Times at which the position of a run is held against the truth: its error grows steadily.
const SAMPLES: usize = 64;

/// The numbers of a figure, as Polhode gives them now.
pub(super) fn values(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, PublishedError> {
    let all = match figure.measure {
        Measure::LargestErrors => largest_errors(figure, motion)?,
        Measure::EnergySwing => vec![energy_swing(figure, motion)?],
        Measure::RateErrorExtremes => rate_error_extremes(figure, motion)?,
        Measure::SpinPeriod
        | Measure::PrecessionPeriod
        | Measure::NutationPeriod
        | Measure::LibrationPeriod => vec![period::of(figure, motion)?],
        Measure::PositionError | Measure::RelativeError => errors(figure, motion)?,
        _ => of_state(figure, motion, &motion.state(figure)?)?,
    };
    let chosen: Option<Vec<f64>> = match figure.components.as_slice() {
        [] => Some(all),
        components => components.iter().map(|i| all.get(*i).copied()).collect(),
    };
    let mut chosen = chosen.ok_or_else(|| motion.missing(figure, "it has no such component"))?;
    chosen.iter_mut().zip(&figure.scales).for_each(|(value, scale)| *value /= scale);
    Ok(chosen)
}

/// What a single state says.
fn of_state(figure: &Figure, motion: &Motion, state: &Snapshot) -> Result<Vec<f64>, PublishedError> {
    let (system, start) = (&motion.scene.system, motion.start());
    let vector = |v: Vector3<f64>, factor: f64| vec![v.x * factor, v.y * factor, v.z * factor];
    let change = state.angular_momentum - start.angular_momentum;
    let arm = state.orientation * Vector3::from(figure.point);
    Ok(match figure.measure {
        Measure::Position => vector(state.position + arm, 1.0),
        Measure::Displacement => vector(state.position - start.position, 1.0),
        Measure::Velocity => vector(state.velocity + state.angular_velocity.cross(&arm), 1.0),
        Measure::AngularVelocity => vector(state.angular_velocity, figure.angle_unit()),
        Measure::BodyAngularVelocity => vector(in_body_axes(state), figure.angle_unit()),
        Measure::Quaternion => signed(figure, &state.orientation),
        Measure::InverseQuaternion => signed(figure, &state.orientation.inverse()),
        Measure::RodriguesParameters => vector(rodrigues(&state.orientation), 1.0),
        Measure::Residuals => {
            let observed = figure.observed.ok_or_else(|| motion.missing(figure, "it needs `observed`"))?;
            residuals(state, &observed)
        }
        Measure::AngleToSteadySpin => {
            let turned = rotation::turned(&start.orientation, &start.angular_velocity, state.time);
            vec![rotation::angle_between(&turned, &state.orientation) * figure.angle_unit()]
        }
        Measure::Energy => vec![energy(system, state)],
        Measure::EnergyRatio => vec![energy(system, state) / energy(system, start)],
        Measure::EnergyChange => vec![energy(system, state) - energy(system, start)],
        Measure::Momentum => vec![rotation::length(&state.angular_momentum)],
        Measure::MomentumChange => vec![rotation::length(&change)],
        _ => return Err(motion.missing(figure, "its measure is not one of a state")),
    })
}

/// Kinetic and potential energy; the kinetic alone where a law has no potential.
fn energy(system: &System, state: &Snapshot) -> f64 {
    system.kinetic_energy(state) + system.potential_energy(state).unwrap_or(0.0)
}

fn in_body_axes(state: &Snapshot) -> Vector3<f64> {
    state.orientation.inverse_transform_vector(&state.angular_velocity)
}

/// w, x, y, z, of the sign that is nearer to the printed one: both are the same rotation.
fn signed(figure: &Figure, rotation: &Rotation) -> Vec<f64> {
    let ours = [rotation.w, rotation.i, rotation.j, rotation.k];
    let printed = numbers(&figure.published).unwrap_or_default();
    let along: f64 = ours.iter().zip(&printed).map(|(a, b)| a * b).sum();
    ours.map(|x| if along < 0.0 { -x } else { x }).to_vec()
}

/// tan(θ/4) times the axis, θ in [0, π].
fn rodrigues(rotation: &Rotation) -> Vector3<f64> {
    let sign = if rotation.w < 0.0 { -1.0 } else { 1.0 };
    rotation.imag() * (sign / (1.0 + rotation.w.abs()))
}

/// ||Ω| over the observed one − 1|; the angles of Ω in body axes, and of each body axis, to the observed ones [deg].
fn residuals(state: &Snapshot, observed: &Observation) -> Vec<f64> {
    let [first, second, third] = observed.angles.map(f64::to_radians);
    let about = |axis: Vector3<f64>, angle: f64| rotation::turn(&(axis * angle));
    let attitude = about(Vector3::z(), first) * about(Vector3::x(), second) * about(Vector3::z(), third);
    let rates = Vector3::from(observed.rates.map(f64::to_radians));
    let ours = in_body_axes(state);
    let speed = (rotation::length(&ours) / rotation::length(&rates) - 1.0).abs();
    let apart = |a: Vector3<f64>, b: Vector3<f64>| rotation::angle_between_directions(&a, &b).to_degrees();
    let axis = |i: usize| {
        let axis = Vector3::ith(i, 1.0);
        apart(state.orientation * axis, attitude * axis)
    };
    vec![speed, apart(ours, rates), axis(0), axis(1), axis(2)]
}

/// Largest relative changes of energy and momentum over the run, and the largest distance from the truth at
/// [`SAMPLES`] times and the end.
fn largest_errors(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, PublishedError> {
    let states = motion.run(figure, 1)?;
    let (system, start) = (&motion.scene.system, motion.start());
    let (first, momentum) = (energy(system, start), rotation::length(&start.angular_momentum));
    let mut largest = [0.0_f64; 3];
    for state in &states {
        let change = state.angular_momentum - start.angular_momentum;
        largest[0] = largest[0].max((energy(system, state) - first).abs() / first);
        largest[1] = largest[1].max(rotation::length(&change) / momentum);
    }
    let mut sampled: Vec<&Snapshot> = states.iter().rev().step_by(states.len().div_ceil(SAMPLES)).collect();
    sampled.reverse();
    let times: Vec<f64> = sampled.iter().map(|state| state.time).collect();
    for (state, truth) in sampled.iter().zip(truth_at(motion.scene, &times)?) {
        largest[2] = largest[2].max(rotation::length(&(state.position - truth.position)));
    }
    Ok(largest.to_vec())
}

/// Largest |E − E(0)| over the run.
fn energy_swing(figure: &Figure, motion: &Motion) -> Result<f64, PublishedError> {
    let (system, states) = (&motion.scene.system, motion.run(figure, 1)?);
    let first = energy(system, motion.start());
    Ok(states.iter().map(|state| (energy(system, state) - first).abs()).fold(0.0, f64::max))
}

/// Error of X_cm at the end: its length, or component by component over the size of the displacement.
fn errors(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, PublishedError> {
    let (state, truth) = (motion.state(figure)?, motion.truth(figure)?);
    let apart = state.position - truth.position;
    if figure.measure == Measure::PositionError {
        return Ok(vec![rotation::length(&apart)]);
    }
    let size = truth.position - motion.start().position;
    Ok((0..3).map(|i| (apart[i] / size[i]).abs()).collect())
}

/// Least and largest error of a component of Ω in body axes over a window of time.
fn rate_error_extremes(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, PublishedError> {
    let component =
        figure.rate_component.ok_or_else(|| motion.missing(figure, "it needs `rate_component`"))?;
    let mut states = motion.run(figure, 1)?;
    states.retain(|state| state.time >= figure.from);
    let times: Vec<f64> = states.iter().map(|state| state.time).collect();
    let truth = truth_at(motion.scene, &times)?;
    let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
    for (state, truth) in states.iter().zip(&truth) {
        let error = in_body_axes(state)[component] - in_body_axes(truth)[component];
        (least, largest) = (least.min(error), largest.max(error));
    }
    Ok(vec![least, largest])
}
