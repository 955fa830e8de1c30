//! Drift of the rotational energy of a body that no torque turns: how far, how fast, and how that depends on h.
//!
//! E = ½ Ω·L with L exact. A scheme's energy error is an oscillation with the polhode's period, bounded and of the
//! scheme's order, on top of a secular part whose rate has an order of its own; only runs over many periods
//! tell them apart, and only steps so small that the rate stays what it was at the start.

use crate::claim::{Claim, EnergyOfFreeBody};
use crate::measure::regression::{self, Fit, Ladder};
use crate::model::System;
use crate::model::body::Shape;
use crate::model::forces::Forces;
use crate::record::DriftClass;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Largest step, in radians turned.
const COARSEST_TURN: f64 = 0.1;
/// Ratio of successive steps once the rate is steady.
const RATIO: f64 = std::f64::consts::SQRT_2;
/// Rungs with a steady rate.
const RUNGS: usize = 6;
/// Difference of the rates over the first and last two thirds of a run, over the rate, below which it is steady.
const STEADY: f64 = 0.04;
/// Shortest run, in radians turned …
const SHORTEST: f64 = 100.0;
/// … in polhode periods, …
const PERIODS: f64 = 16.0;
/// … and the longest, in radians turned: what tumbles more slowly is not measured.
const LONGEST: f64 = 4000.0;
/// Successive runs without a rate that settle that there is none.
const FLAT: usize = 3;
/// Most steps of all runs together, where the scheme promises an order of the rate, …
const MOST_STEPS: u64 = 4_000_000;
/// … where it promises something else about its energy …
const MOST_STEPS_OTHERWISE: u64 = 1_000_000;
/// … and where it promises nothing.
const MOST_STEPS_UNASKED: u64 = 100_000;
/// Change of the energy, over the energy, from which on a run has gone elsewhere: its step is too large for its rate to mean anything.
const WILD: f64 = 1.0;
/// Energy over the most that L allows from which on it grows without bound. (That of a thin body may be ten thousand times the first.)
const WAY_PAST: f64 = 10.0;
/// Samples of a run.
const SAMPLES: u64 = 512;
/// Difference of two moments, over the largest, below which they are one.
const ONE_MOMENT: f64 = 1e-9;

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
    /// Largest (E − E₀)/E₀.
    pub gain: f64,
    /// Largest E over L²/(2 I_min), the most that L allows.
    pub of_largest: f64,
    /// Rounding of E after this many steps, relative.
    pub rounding: f64,
    /// Evaluations of the forces.
    pub evaluations: u64,
}

impl EnergyRung {
    /// Whether the energy oscillates clear of rounding and has not gone elsewhere, with no rate but what the averages leave of
    /// the oscillation.
    fn is_flat(&self, long: f64) -> bool {
        self.level > 100.0 * self.rounding
            && self.level < WILD
            && self.rate.abs() <= 3.0 * self.uncertainty
            && self.rate.abs() * long < 0.1 * self.level
    }
}

/// The drift of the energy over a ladder of steps.
#[derive(Clone, Debug)]
pub struct EnergyDrift {
    /// Long runs, step falling.
    pub rungs: Vec<EnergyRung>,
    /// Kind of drift.
    pub class: DriftClass,
    /// Order in h of the rate.
    pub order: Option<Fit>,
    /// Rung that stands for the ladder: the finest with a clear rate.
    pub shown: usize,
}

/// Measures the drift; `None` for a body under torque, without spin, too near the separatrix for many periods, or
/// that breaks.
pub fn energy_drift(contestant: &Contestant, system: &System, duration: f64) -> Option<EnergyDrift> {
    let mut rotor = system.clone();
    // Without steps of its own there is no order in h to a rate.
    if !system.torque_free() || contestant.card.tolerance_exponent() > 0 {
        return None;
    }
    rotor.forces = Forces::default();
    let momentum = rotor.start.orientation.inverse_transform_vector(&rotor.start.angular_momentum);
    let spin = rotation::length(&(rotor.body.inverse_inertia() * momentum));
    let periods = PERIODS * polhode_period(&rotor).unwrap_or(0.0);
    let long = periods.max(SHORTEST / spin).max(duration.min(LONGEST / spin));
    if spin == 0.0 || long * spin > LONGEST {
        return None;
    }
    let (mut rungs, mut steady, mut flat, mut taken) = (Vec::<EnergyRung>::new(), 0, 0, 0);
    let claimed =
        contestant.card.claims.iter().find_map(|c| if let Claim::Energy(e) = c { Some(*e) } else { None });
    let most = match claimed {
        Some(EnergyOfFreeBody::GrowsSecularly { .. } | EnergyOfFreeBody::Secular { .. }) => MOST_STEPS,
        Some(_) => MOST_STEPS_OTHERWISE,
        None => MOST_STEPS_UNASKED,
    };
    let mut turn = COARSEST_TURN;
    while steady < RUNGS && flat < FLAT {
        let steps = ((long * spin / turn).ceil() as u64).div_ceil(SAMPLES) * SAMPLES;
        taken += steps;
        if taken > most {
            break;
        }
        let rung = run_rung(contestant, &rotor, long, steps)?;
        let exact = rung.level <= 10.0 * rung.rounding;
        let is_steady = exact || rung.uncertainty <= STEADY * rung.rate.abs();
        steady = if is_steady { steady + 1 } else { 0 };
        flat = if rung.is_flat(long) { flat + 1 } else { 0 };
        turn /= if is_steady { RATIO } else { 2.0 };
        rungs.push(rung);
    }
    if rungs.is_empty() { None } else { Some(classify(rungs, steady, flat >= FLAT, long)) }
}

fn run_rung(contestant: &Contestant, rotor: &System, long: f64, steps: u64) -> Option<EnergyRung> {
    let plan = Plan::over(long, steps, SAMPLES);
    let run = contestant.run(rotor, Form::Least, &plan);
    if run.outcome.broken.is_some() {
        return None;
    }
    let time: Vec<f64> = run.states.iter().map(|s| s.time).collect();
    let energy: Vec<f64> = run.states.iter().map(|s| rotor.rotational_energy(s)).collect();
    let change: Vec<f64> = energy.iter().map(|e| (e - energy[0]) / energy[0]).collect();
    let third = time.len() / 3;
    let rate = regression::secular_rate(&time, &change)?;
    let early = regression::secular_rate(&time[..2 * third], &change[..2 * third])?;
    let late = regression::secular_rate(&time[third..], &change[third..])?;
    let smallest = rotor.body.moments.iter().copied().filter(|m| *m > 0.0).fold(f64::INFINITY, f64::min);
    let most = rotation::length(&rotor.start.angular_momentum).powi(2) / (2.0 * smallest);
    Some(EnergyRung {
        step: plan.step,
        steps,
        rate,
        uncertainty: (early - late).abs(),
        level: change.iter().map(|c| c.abs()).fold(0.0, super::larger),
        gain: change.iter().copied().fold(0.0, super::larger),
        of_largest: energy.iter().copied().fold(0.0, super::larger) / most,
        rounding: if rotor.steady_spin() {
            4.0 * f64::EPSILON * steps as f64
        } else {
            4.0 * f64::EPSILON * (steps as f64).sqrt()
        },
        evaluations: run.outcome.evaluations,
    })
}

fn classify(rungs: Vec<EnergyRung>, steady: usize, flat: bool, long: f64) -> EnergyDrift {
    // A rate counts as clear at ten times its floor: at three times its uncertainty.
    let ladder: Vec<_> =
        rungs.iter().map(|r| (r.step, r.rate.abs(), (0.3 * r.uncertainty).max(r.rounding / long))).collect();
    let shown = ladder.iter().rposition(|(_, rate, floor)| *rate > 10.0 * floor).unwrap_or(rungs.len() - 1);
    let fine = &rungs[rungs.len() - steady.max(1)..];
    let bounded = flat || fine.iter().all(|r| (r.rate * long).abs() < 0.1 * r.level);
    let (class, order) = match regression::find_window(&ladder[rungs.len() - steady.max(1)..]) {
        _ if rungs.iter().all(|r| r.level <= 10.0 * r.rounding) => (DriftClass::Exact, None),
        _ if fine.iter().any(|r| r.of_largest > WAY_PAST) => (DriftClass::Growing, None),
        Ladder::Window { fit, .. } if !flat => (DriftClass::Secular, Some(fit)),
        _ if bounded => (DriftClass::Bounded, None),
        _ => (DriftClass::Undecided, None),
    };
    EnergyDrift { rungs, class, order, shown }
}

/// Period of Ω in body axes [s], 4 K(k)/λ; `None` where Ω is steady. About the axis of a symmetric body it turns evenly, at
/// L₁ (1/I₁ − 1/I₂): that body's energy knows nothing of it, but a splitting into turns about three axes does.
///
/// With moments A < B < C and L² > 2 E B: λ² = (C − B)(L² − 2 E A)/(A B C) and
/// k² = (B − A)(2 E C − L²)/((C − B)(L² − 2 E A)); otherwise A and C change places. K by the arithmetic-geometric
/// mean. Infinite on the separatrix, L² = 2 E B.
fn polhode_period(system: &System) -> Option<f64> {
    let body = &system.body;
    if body.shape != Shape::Extended || system.steady_spin() {
        return None;
    }
    let mut moments = [body.moments[0], body.moments[1], body.moments[2]];
    moments.sort_by(f64::total_cmp);
    let [mut a, b, mut c] = moments;
    let momentum =
        (system.start.orientation * body.principal).inverse_transform_vector(&system.start.angular_momentum);
    match (b - a <= ONE_MOMENT * c, c - b <= ONE_MOMENT * c) {
        (true, true) => return None,
        (false, false) => {}
        (lower_two, _) => {
            let (axis, across) = if lower_two { (c, a) } else { (a, c) };
            let along = (0..3).find(|index| body.moments[*index] == axis).map(|index| momentum[index])?;
            return Some(2.0 * std::f64::consts::PI / (along * (1.0 / axis - 1.0 / across)).abs());
        }
    }
    let squared = momentum.norm_squared();
    let twice_energy = momentum.component_mul(&body.inverse_moments()).dot(&momentum);
    if squared < twice_energy * b {
        std::mem::swap(&mut a, &mut c);
    }
    let lambda = ((c - b) * (squared - twice_energy * a) / (a * b * c)).sqrt();
    let k_squared = (b - a) * (twice_energy * c - squared) / ((c - b) * (squared - twice_energy * a));
    let (mut mean, mut geometric) = (1.0f64, (1.0 - k_squared).max(0.0).sqrt());
    for _ in 0..40 {
        (mean, geometric) = (0.5 * (mean + geometric), (mean * geometric).sqrt());
    }
    Some(2.0 * std::f64::consts::PI / (mean * lambda))
}
