//! Runs of very many steps of a free body: how its energy changes, how roundings grow, and which axis the spin ends on.
//!
//! Roundings that are independent grow as √n, those that all go one way as n. A scheme whose energy drifts by itself is neither.

use super::failure::Axis;
use super::theory;
use super::truth::settled_axis;
use crate::measure::slope;
use crate::model::{Snapshot, System};
use crate::record::stability::{EnergyRate, LongRun, LongRunClass};
use crate::rotation;
use crate::scenes::Scene;
use crate::schemes;
use crate::simulate::{Contestant, Form, Plan};

/// Scenes of the long runs: three different moments, and two equal ones.
pub(super) const SCENES: [&str; 2] = ["free-asymmetric", "free-oblate"];
/// Radians turned a step.
const TURN: f64 = 0.05;
/// Samples a decade of steps.
const SAMPLES_A_DECADE: f64 = 16.0;
/// Steps of the run that fills in the first decades.
const SHORT: u64 = 4096;
/// Relative change of the energy that is rounding whatever the scheme: 1e8 steps of a rounding each, all one way.
const ROUNDING_A_STEP: f64 = f64::EPSILON;
/// Change of the energy from which on it is no small drift any more.
const SATURATED: f64 = 0.05;

/// The long run of a scheme in a scene; `None` where it cannot take it.
pub fn long_run(scene: &str, contestant: &Contestant, steps: u64) -> Option<LongRun> {
    let scene = Scene::find(scene).ok()?;
    let system = &scene.system;
    if contestant.refusal(system).is_some() || contestant.is_foreign() {
        return None;
    }
    let spin = system.body.inverse_inertia()
        * system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
    let step = TURN / rotation::length(&spin);
    let first = 0.5 * spin.dot(&(system.body.inertia * spin));
    let mut samples = Samples { first, at_step: Vec::new(), change: Vec::new(), next: 1.0, step };
    let short = Plan { step, steps: SHORT.min(steps), every: 1 };
    contestant.stream(system, Form::Least, &short, &mut |state| samples.push(state));
    let every = (steps / 8192).max(1);
    let mut last = Vec::new();
    let plan = Plan { step, steps, every };
    let outcome = contestant.stream(system, Form::Least, &plan, &mut |state| {
        samples.push(state);
        // The last eighth says where the spin has settled.
        if state.time > 0.875 * step * steps as f64 {
            last.push(*state);
        }
    });
    let power = growth_power(&samples);
    Some(LongRun {
        scene: scene.name.clone(),
        scheme: contestant.card.name.to_owned(),
        look: schemes::look(contestant.card.name),
        step_s: step,
        radians_per_step: TURN,
        steps: outcome.steps,
        class: class(&samples, power, outcome.broken.is_some()),
        growth_power: power,
        final_axis: final_axis(system, &last),
        at_step: samples.at_step,
        energy_change: samples.change,
        why: outcome.broken.map(|broken| broken.to_string()),
        seconds: outcome.nanoseconds as f64 * 1e-9,
    })
}

/// Energies at steps that are equal in the logarithm.
struct Samples {
    first: f64,
    at_step: Vec<u64>,
    change: Vec<f64>,
    next: f64,
    step: f64,
}

impl Samples {
    fn push(&mut self, state: &Snapshot) {
        let n = (state.time / self.step).round();
        let last = self.at_step.last().map_or(0.0, |last| *last as f64);
        if n < self.next || n <= last {
            return;
        }
        let energy = 0.5 * state.angular_velocity.dot(&state.angular_momentum);
        let change = energy / self.first - 1.0;
        if change.is_finite() {
            self.at_step.push(n as u64);
            self.change.push(change);
        }
        self.next = n * 10f64.powf(1.0 / SAMPLES_A_DECADE);
    }
}

/// The power of n with which the envelope of the change grows over the last two decades.
fn growth_power(samples: &Samples) -> Option<f64> {
    let last = *samples.at_step.last()? as f64;
    let mut envelope = 0.0f64;
    let mut points = Vec::new();
    for (n, change) in samples.at_step.iter().zip(&samples.change) {
        envelope = envelope.max(change.abs());
        if *n as f64 >= last / 100.0 && envelope > 0.0 {
            points.push(((*n as f64).ln(), envelope.ln()));
        }
    }
    (points.len() > 8).then(|| slope(&points))
}

fn class(samples: &Samples, power: Option<f64>, broken: bool) -> LongRunClass {
    let largest = samples.change.iter().map(|change| change.abs()).fold(0.0, f64::max);
    let steps = samples.at_step.last().copied().unwrap_or(0) as f64;
    match power {
        _ if broken => LongRunClass::Broken,
        _ if largest > SATURATED => LongRunClass::Saturated,
        Some(power) if power < 0.2 => LongRunClass::Bounded,
        Some(power) if largest <= ROUNDING_A_STEP * steps.max(64.0) => {
            if power < 0.75 {
                LongRunClass::RoundingLikeRoot
            } else {
                LongRunClass::RoundingLikeN
            }
        }
        _ => LongRunClass::Secular,
    }
}

fn final_axis(system: &System, last: &[Snapshot]) -> String {
    settled_axis(system, last).map_or("none", Axis::word).to_owned()
}

/// Steps of the runs that are held against the law of the energy, in radians turned.
const LAW_TURNS: [f64; 6] = [0.4, 0.2, 0.1, 0.05, 0.025, 0.0125];
/// Largest relative change of the energy in such a run: the rate is that of the start.
const LAW_CHANGE: f64 = 1e-4;

/// Peskin's scheme on the symmetric body: measured drift rate of the energy beside the law.
pub fn energy_law() -> Vec<EnergyRate> {
    let Ok(scene) = Scene::find("free-oblate") else { return Vec::new() };
    let Some(contestant) = Contestant::main().into_iter().find(|c| c.card.name == "peskin-rk2") else {
        return Vec::new();
    };
    let system = &scene.system;
    let spin = system.body.inverse_inertia()
        * system.start.orientation.inverse_transform_vector(&system.start.angular_momentum);
    let one = |turn: f64| {
        let step = turn / rotation::length(&spin);
        let law = theory::energy_rate(system, step)?;
        let first = 0.5 * spin.dot(&(system.body.inertia * spin));
        let steps = (LAW_CHANGE * first / (law * step)).clamp(16.0, 2e6) as u64;
        let (mut start, mut end) = (None, 0.0);
        contestant.stream(system, Form::Least, &Plan { step, steps, every: steps }, &mut |state| {
            end = 0.5 * state.angular_velocity.dot(&state.angular_momentum);
            start.get_or_insert(end);
        });
        let measured = (end - start?) / (step * steps as f64);
        Some(EnergyRate {
            scene: scene.name.clone(),
            scheme: "peskin-rk2".to_owned(),
            step_s: step,
            measured_w: measured,
            law_w: law,
        })
    };
    LAW_TURNS.into_iter().filter_map(one).collect()
}
