//! Drift of the rotational energy of a body that no torque turns: how far, how fast, and how that depends on h.
//!
//! E = ½ Ω·L with L exact. A scheme's energy error is an oscillation, bounded and of the scheme's order, on top
//! of a secular part whose rate has an order of its own; only long runs tell them apart.

use crate::model::System;
use crate::regression::{self, Fit, Ladder};
use crate::rotation;
use crate::simulate::{Contestant, Plan};

/// Steps of h: from this turn a step [rad] …
const COARSEST_TURN: f64 = 0.1;
/// … over this many halvings.
const RUNGS: i32 = 8;
/// Shortest run, in radians turned.
const SHORTEST: f64 = 100.0;
/// Samples of a run.
const SAMPLES: u64 = 512;

/// How a conserved quantity changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// By rounding only.
    Exact,
    /// By an oscillation that does not grow with time.
    Bounded,
    /// Steadily, at a rate that has an order in h.
    Secular,
    /// Faster than steadily, or without bound.
    Growing,
    /// None of these can be told.
    Undecided,
}

impl Class {
    /// The word that stands in records.
    pub fn word(self) -> &'static str {
        match self {
            Class::Exact => "exact",
            Class::Bounded => "bounded",
            Class::Secular => "secular",
            Class::Growing => "growing",
            Class::Undecided => "undecided",
        }
    }
}

/// One long run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyRung {
    /// h [s].
    pub step: f64,
    /// Steps taken.
    pub steps: u64,
    /// Secular rate of (E − E₀)/E₀ [1/s].
    pub rate: f64,
    /// What the rate may be wrong by: the difference of the rates over the first and last two thirds.
    pub uncertainty: f64,
    /// Largest |E − E₀|/E₀.
    pub level: f64,
    /// Largest E over L²/(2 I_min), the most that L allows.
    pub of_largest: f64,
    /// Rounding of E after this many steps, relative.
    pub rounding: f64,
    /// Evaluations of the forces.
    pub evaluations: u64,
}

/// The drift of the energy over a ladder of steps.
#[derive(Clone, Debug)]
pub struct EnergyDrift {
    /// Long runs, step falling.
    pub rungs: Vec<EnergyRung>,
    /// Kind of drift.
    pub class: Class,
    /// Order in h of the rate.
    pub order: Option<Fit>,
    /// Rung that stands for the ladder: the finest with a clear rate.
    pub shown: usize,
}

/// Measures the drift; `None` for a body under torque, without spin, or that breaks.
pub fn energy_drift(contestant: &Contestant, system: &System, duration: f64) -> Option<EnergyDrift> {
    let mut rotor = system.clone();
    if !system.torque_free() {
        return None;
    }
    rotor.forces = crate::model::forces::Forces::default();
    let model = rotor.least();
    let spin = rotation::length(&(rotor.body.inverse_inertia() * rotor.start.orientation.inverse_transform_vector(&rotor.start.angular_momentum)));
    if spin == 0.0 {
        return None;
    }
    let long = duration.max(SHORTEST / spin);
    let mut rungs = Vec::new();
    for halvings in 0..RUNGS {
        let fewest = (long * spin / COARSEST_TURN * 2f64.powi(halvings)).ceil() as u64;
        let steps = fewest.div_ceil(SAMPLES) * SAMPLES;
        let plan = Plan::over(long, steps, SAMPLES);
        let run = contestant.run(&model, &plan);
        if run.outcome.broken.is_some() {
            return None;
        }
        let time: Vec<f64> = run.states.iter().map(|s| s.time).collect();
        let energy: Vec<f64> = run.states.iter().map(|s| rotor.rotational_energy(s)).collect();
        rungs.push(rung(&rotor, &plan, &time, &energy, run.outcome.evaluations)?);
    }
    Some(classify(rungs, long))
}

fn rung(system: &System, plan: &Plan, time: &[f64], energy: &[f64], evaluations: u64) -> Option<EnergyRung> {
    let first = energy[0];
    let change: Vec<f64> = energy.iter().map(|e| (e - first) / first).collect();
    let third = time.len() / 3;
    let rate = regression::secular_rate(time, &change)?;
    let early = regression::secular_rate(&time[..2 * third], &change[..2 * third])?;
    let late = regression::secular_rate(&time[third..], &change[third..])?;
    let smallest = system.body.moments.iter().copied().filter(|moment| *moment > 0.0).fold(f64::INFINITY, f64::min);
    let most = rotation::length(&system.start.angular_momentum).powi(2) / (2.0 * smallest);
    Some(EnergyRung {
        step: plan.step,
        steps: plan.steps,
        rate,
        uncertainty: (early - late).abs(),
        level: change.iter().map(|c| c.abs()).fold(0.0, super::larger),
        of_largest: energy.iter().copied().fold(0.0, super::larger) / most,
        rounding: 4.0 * f64::EPSILON * (plan.steps as f64).sqrt(),
        evaluations,
    })
}

fn classify(rungs: Vec<EnergyRung>, long: f64) -> EnergyDrift {
    // A rate counts as clear at ten times its floor, so at three times its uncertainty.
    let ladder: Vec<_> = rungs
        .iter()
        .map(|r| (r.step, r.rate.abs(), (0.3 * r.uncertainty).max(r.rounding / long)))
        .collect();
    let shown = ladder.iter().rposition(|(_, rate, floor)| *rate > 10.0 * floor).unwrap_or(rungs.len() - 1);
    let fine = &rungs[rungs.len() / 2..];
    let bounded = fine.iter().all(|r| (r.rate * long).abs() < 0.1 * r.level);
    let (class, order) = match regression::find_window(&ladder) {
        _ if rungs.iter().all(|r| r.level <= 10.0 * r.rounding) => (Class::Exact, None),
        _ if fine.iter().any(|r| r.level > 1e3) => (Class::Growing, None),
        Ladder::Window { fit, .. } => (Class::Secular, Some(fit)),
        _ if bounded => (Class::Bounded, None),
        _ => (Class::Undecided, None),
    };
    EnergyDrift { rungs, class, order, shown }
}
