//! Drift of the rotational energy of a body that no torque turns: how far, how fast, and how that depends on h.
//!
//! E = ½ Ω·L with L exact. A scheme's energy error is an oscillation with the polhode's period, bounded and of the
//! scheme's order, on top of a secular part whose rate has an order of its own; only runs over many periods
//! tell them apart, and only steps so small that the rate stays what it was at the start.

use super::order::{Asked, BELOW, Decision, Run, decide};
use crate::arithmetic::{DoubleDouble, Real};
use crate::claim::{Claim, EnergyOfFreeBody};
use crate::model::body::Shape;
use crate::model::copies::CLEAR;
use crate::model::forces::Forces;
use crate::model::{Snapshot, System};
use crate::record::{DriftClass, EnergyDrift, EnergyRung};
use crate::rotation;
use crate::simulate::{Arithmetic, Contestant, Form, Plan};

/// Largest step, in radians turned.
const COARSEST_TURN: f64 = 0.2;
/// Ratio of successive steps.
const RATIO: f64 = std::f64::consts::SQRT_2;
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
/// Most steps of all runs in double-double together.
const MOST_PRECISE_STEPS: u64 = 400_000;
/// Steps in f64 that one in double-double costs, at most.
const PRECISE_COST: u64 = 50;
/// A rate counts as clear at so many times its uncertainty: three rates show an uncertainty as well as three copies a rounding.
const SEEN: f64 = CLEAR * BELOW;
/// Samples of a run.
const SAMPLES: u64 = 512;
/// Difference of two moments, over the largest, below which they are one.
const ONE_MOMENT: f64 = 1e-9;

/// Whether there is no rate but that of rounding.
fn is_rounding(rung: &EnergyRung, long: f64) -> bool {
    rung.rate.abs() * long <= rung.rounding / BELOW
}

/// Whether there is no rate but what the averages leave of an oscillation that has not gone elsewhere.
fn oscillates(rung: &EnergyRung, long: f64) -> bool {
    // A change as large as the energy is that of a run whose step is too large for its rate to mean anything.
    rung.level < 1.0 && rung.rate.abs() <= SEEN * rung.uncertainty && is_bounded(rung, long)
}

/// Whether the rate makes a part of the largest change that is not seen.
fn is_bounded(rung: &EnergyRung, long: f64) -> bool {
    rung.rate.abs() * long < BELOW * rung.level
}

/// The order in h of the rate, by the rule of orders.
pub fn rate_order(drift: &EnergyDrift) -> Decision {
    let run = |rung: &EnergyRung| {
        let long = rung.step * rung.steps as f64;
        // What a rate may be wrong by is a bound: r is to resolve a tenth of the rate.
        let known = rung.uncertainty.max(rung.rounding / long);
        Run {
            step: rung.step,
            steps: rung.steps,
            errors: vec![rung.rate],
            rounding: vec![known / (BELOW * CLEAR)],
        }
    };
    let runs = drift.rungs.iter().map(run).collect();
    decide(&Asked::in_f64(runs, &[1.0], 0.0))
}

/// Measures the drift; `None` for a body under torque, without spin, too near the separatrix for many periods, or
/// that breaks.
pub fn energy_drift(contestant: &Contestant, system: &System, duration: f64) -> Option<EnergyDrift> {
    energy_drift_within(contestant, system, duration, u64::MAX).unwrap_or_default()
}

/// The runs take more steps than there is time for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeftOut;

/// The same in so many steps of all runs together.
///
/// # Errors
/// [`LeftOut`].
pub fn energy_drift_within(
    contestant: &Contestant,
    system: &System,
    duration: f64,
    afforded: u64,
) -> Result<Option<EnergyDrift>, LeftOut> {
    let Some((rotor, runs)) = LongRuns::of(contestant, system, duration) else { return Ok(None) };
    let Some(rungs) = runs.ladder(&rotor, runs.most, afforded)? else { return Ok(None) };
    let mut drift = EnergyDrift { rungs, ..EnergyDrift::default() };
    let hidden = match runs.claimed {
        Some(EnergyOfFreeBody::Constant) => may_add_up(&drift, runs.long),
        _ => runs.secular() && is_hidden(&drift),
    };
    if hidden
        && contestant.runs_in_double_double()
        && let Ok(precise) = System::<DoubleDouble>::of(&rotor)
        && let Some(rungs) = runs.ladder(&precise, MOST_PRECISE_STEPS, afforded / PRECISE_COST)?
    {
        (drift.rungs, drift.double_double) = (rungs, true);
    }
    let clear = |rung: &EnergyRung| {
        rung.rate.abs() > (SEEN * rung.uncertainty).max(rung.rounding / BELOW / runs.long)
    };
    let Some(class) = class_of(&drift, runs.long) else { return Ok(None) };
    drift.class = class;
    drift.shown = drift.rungs.iter().rposition(clear).unwrap_or(drift.rungs.len() - 1);
    Ok(Some(drift))
}

/// The kind of a drift; `None` without a run.
fn class_of(drift: &EnergyDrift, long: f64) -> Option<DriftClass> {
    let finest = drift.rungs.last()?;
    // A secular change stands out of the oscillation at large steps: it is of a higher order.
    let bounded = drift
        .rungs
        .iter()
        .filter(|rung| rung.level > rung.rounding / BELOW)
        .all(|rung| is_bounded(rung, long));
    Some(match rate_order(drift) {
        _ if drift.rungs.iter().all(|rung| rung.level <= rung.rounding / BELOW) => DriftClass::Exact,
        // That of a thin body may be ten thousand times the first.
        _ if BELOW * finest.of_largest > 1.0 => DriftClass::Growing,
        _ if bounded => DriftClass::Bounded,
        Decision::Order(_) => DriftClass::Secular,
        _ => DriftClass::Undecided,
    })
}

/// Whether no order of the rate is decided, and the finest run changes the energy by no more than roundings that add up.
fn is_hidden(drift: &EnergyDrift) -> bool {
    let at_rounding =
        |rung: &EnergyRung| rung.rate.abs() * rung.step * (rung.steps as f64) <= all_added(rung);
    !matches!(rate_order(drift), Decision::Order(_)) && drift.rungs.last().is_some_and(at_rounding)
}

/// Whether the energy changes by more than roundings and by no more than roundings that add up.
fn may_add_up(drift: &EnergyDrift, long: f64) -> bool {
    let exact = class_of(drift, long) == Some(DriftClass::Exact);
    !exact && drift.rungs.iter().all(|rung| rung.level <= all_added(rung))
}

/// What the roundings of a run make of the energy where they add up, ten times: they are as many as the root of the steps otherwise.
fn all_added(rung: &EnergyRung) -> f64 {
    rung.rounding * (rung.steps as f64).sqrt() / BELOW
}

/// What so many roundings make of the energy, relative: one of L changes E by Ω·δL, and `condition` is the largest |Ω| |L|/E of the run.
fn rounding<T: Real>(count: f64, condition: f64) -> f64 {
    2.0 * T::UNIT * count * condition
}

/// Long runs of a free body at falling steps.
struct LongRuns<'a> {
    contestant: &'a Contestant,
    /// What a run covers [s].
    long: f64,
    /// Radians turned in a second.
    spin: f64,
    steady: bool,
    /// What the scheme promises.
    claimed: Option<EnergyOfFreeBody>,
    /// Most steps of all runs together.
    most: u64,
}

impl LongRuns<'_> {
    /// The body without its forces, and its runs; `None` where none are measured.
    fn of<'a>(contestant: &'a Contestant, system: &System, duration: f64) -> Option<(System, LongRuns<'a>)> {
        let mut rotor = system.clone();
        // A scheme that chooses its steps has no rate as a function of h.
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
        let claims = &contestant.card.claims;
        let claimed = claims.iter().find_map(|c| if let Claim::Energy(e) = c { Some(*e) } else { None });
        let most = match claimed {
            Some(EnergyOfFreeBody::GrowsSecularly { .. } | EnergyOfFreeBody::Secular { .. }) => MOST_STEPS,
            Some(_) => MOST_STEPS_OTHERWISE,
            None => MOST_STEPS_UNASKED,
        };
        let steady = rotor.steady_spin();
        Some((rotor, LongRuns { contestant, long, spin, steady, claimed, most }))
    }

    /// Whether a rate is promised.
    fn secular(&self) -> bool {
        self.most == MOST_STEPS
    }

    /// The runs in an arithmetic, until a finer run confirms the order of the rate or there is none; `None` where one breaks. The first runs that
    /// seem to have an order may have it by chance.
    fn ladder<T: Arithmetic>(
        &self,
        rotor: &System<T>,
        most: u64,
        afforded: u64,
    ) -> Result<Option<Vec<EnergyRung>>, LeftOut> {
        let mut drift = EnergyDrift::default();
        let (mut flat, mut taken, mut turn) = (0, 0, COARSEST_TURN);
        let (mut order, mut confirmed) = (None, false);
        while flat < FLAT && !confirmed {
            let steps = ((self.long * self.spin / turn).ceil() as u64).div_ceil(SAMPLES) * SAMPLES;
            turn /= RATIO;
            if drift.rungs.last().is_some_and(|coarser| coarser.steps == steps) {
                continue;
            }
            taken += steps;
            if taken > most {
                break;
            }
            if taken > afforded {
                return Err(LeftOut);
            }
            let Some(rung) = run_rung(self.contestant, rotor, (self.long, steps, self.steady)) else {
                return Ok(None);
            };
            // An oscillation of an order falls with the step; at too large ones the motion is another.
            let falls = drift.rungs.last().is_none_or(|coarser| rung.level < coarser.level);
            let is_settled = is_rounding(&rung, self.long)
                || falls && oscillates(&rung, self.long)
                || !self.secular() && is_bounded(&rung, self.long);
            flat = if is_settled { flat + 1 } else { 0 };
            drift.rungs.push(rung);
            let found =
                if let Decision::Order(found) = rate_order(&drift) { Some(found.order) } else { None };
            confirmed = found.is_some() && found == order;
            order = found;
        }
        Ok(Some(drift.rungs))
    }
}

/// A run in an arithmetic; `None` where it breaks.
fn run_rung<T: Arithmetic>(
    contestant: &Contestant,
    rotor: &System<T>,
    (long, steps, steady): (f64, u64, bool),
) -> Option<EnergyRung> {
    let plan = Plan::over(long, steps, SAMPLES);
    let (states, outcome) = contestant.run_in(rotor, Form::Least, &plan);
    if outcome.broken.is_some() {
        return None;
    }
    let time: Vec<f64> = states.iter().map(|s| s.time.to_f64()).collect();
    let energy: Vec<T> = states.iter().map(|s| rotor.rotational_energy(s)).collect();
    let change: Vec<f64> = energy.iter().map(|e| ((*e - energy[0]) / energy[0]).to_f64()).collect();
    let third = time.len() / 3;
    let rate = secular_rate(&time, &change)?;
    let early = secular_rate(&time[..2 * third], &change[..2 * third])?;
    let late = secular_rate(&time[third..], &change[third..])?;
    let smaller = |a: T, b: T| if b < a { b } else { a };
    let smallest = rotor.body.moments.iter().copied().filter(|m| *m > T::zero()).reduce(smaller)?;
    let momentum = rotation::length(&rotor.start.angular_momentum);
    let most = momentum * momentum / (smallest * 2.0);
    let lengths =
        |s: &Snapshot<T>| rotation::length(&s.angular_velocity) * rotation::length(&s.angular_momentum);
    let conditions = states.iter().zip(&energy).map(|(s, e)| (lengths(s) / *e).to_f64());
    let condition = conditions.fold(0.0, super::larger);
    // In double-double they are so small that they may all add up.
    let roundings = if steady || T::UNIT < f64::UNIT { steps as f64 } else { (steps as f64).sqrt() };
    Some(EnergyRung {
        step: plan.step,
        steps,
        rate,
        uncertainty: (early - late).abs(),
        level: change.iter().map(|c| c.abs()).fold(0.0, super::larger),
        gain: change.iter().copied().fold(0.0, super::larger),
        of_largest: energy.iter().map(|e| (*e / most).to_f64()).fold(0.0, super::larger),
        rounding: rounding::<T>(roundings, condition),
        evaluations: outcome.evaluations,
    })
}

/// Secular rate of a sampled quantity, in its unit over that of time: the difference of two averages over its
/// halves, each weighted by a Hann window, over the time between them. An oscillation of n periods a half
/// leaks into the rate as n⁻³ only.
///
/// `None` with fewer than eight samples.
fn secular_rate(time: &[f64], value: &[f64]) -> Option<f64> {
    let half = time.len() / 2;
    if half < 4 || time.len() != value.len() {
        return None;
    }
    let (early, late) = (hann_mean(&time[..half], &value[..half]), hann_mean(&time[half..], &value[half..]));
    Some((late.1 - early.1) / (late.0 - early.0))
}

/// Means of time and value under a Hann window.
fn hann_mean(time: &[f64], value: &[f64]) -> (f64, f64) {
    let count = time.len() as f64;
    let (mut weight_sum, mut time_sum, mut value_sum) = (0.0, 0.0, 0.0);
    for (index, (t, v)) in time.iter().zip(value).enumerate() {
        let weight = (std::f64::consts::PI * (index as f64 + 0.5) / count).sin().powi(2);
        weight_sum += weight;
        time_sum += weight * t;
        value_sum += weight * v;
    }
    (time_sum / weight_sum, value_sum / weight_sum)
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
