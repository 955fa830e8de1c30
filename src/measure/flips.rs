//! Flips of a body that tumbles about its middle axis: the times at which the middle component of L in body
//! axes changes its sign.

use nalgebra::Vector3;

use super::copies;
use super::ladder::ROUNDING_DIGITS;
use super::order::{Asked, BELOW, Decision, Run, decide};
use crate::model::body::Shape;
use crate::model::copies::CLEAR;
use crate::model::{Snapshot, System};
#[cfg(feature = "solvers")]
use crate::ode::dop853;
use crate::record::{FlipRung, Flips, TrueFlips, to_digits};
use crate::reference::Reference;
#[cfg(not(feature = "solvers"))]
use crate::reference::precise;
use crate::rotation;
use crate::simulate::{Contestant, Form, Plan};

/// Part of |L| along the middle axis from which a body counts as tumbling about it.
const TUMBLING: f64 = 0.9;
/// Radians turned in a step of the coarsest run.
const COARSEST_TURN: f64 = 0.16;
/// Runs at halved steps, at least, …
const FEWEST_RUNGS: usize = 8;
/// … and at most, where the times are not settled.
const MOST_RUNGS: usize = 11;
/// Runs, at the fine end, that must have the flips of the truth.
pub const COUNTED: usize = 3;
/// Most steps of a run beyond the fewest.
const MOST_STEPS: u64 = 1 << 20;
/// Error of a cubic through every second state over that through every state: the fourth power of their spacing.
const COARSER: f64 = 16.0;
/// Intervals of the truth: fine enough for cubic interpolation to 1e-9 of the duration.
const TRUE_SAMPLES: u32 = 4096;

/// What the rule of orders says of the flip times.
pub fn flip_order(flips: &Flips) -> Decision {
    let truth = &flips.truth;
    let whole = flips.rungs.iter().filter(|rung| is_complete(flips, rung));
    let common = whole.map(|rung| rung.times.len()).min().unwrap_or(0).min(truth.times.len());
    let run = |rung: &FlipRung| {
        let late = rung.times.iter().zip(&truth.times).map(|(a, b)| a - b).take(common);
        // Each is a bound: r is to resolve a tenth of an error.
        let known = (truth.uncertainty + rung.uncertainty) / (BELOW * CLEAR);
        let of_copies = |flip: usize| rung.rounding.get(flip).copied().unwrap_or(0.0);
        Run {
            step: rung.step,
            steps: rung.steps,
            errors: if is_complete(flips, rung) { late.collect() } else { Vec::new() },
            rounding: (0..common).map(|flip| known.max(of_copies(flip))).collect(),
        }
    };
    let runs = flips.rungs.iter().map(run).collect();
    // In this time L turns by a radian: a flip that is further off is no small change of the motion.
    let turn = truth.slowest.recip();
    decide(&Asked { largest: turn, ..Asked::in_f64(runs, &truth.times[..common], turn) })
}

/// Whether a run has the flips of the truth. One more or less is the same where it lies no further from the end of the run than ten times
/// what the others are late by, and each of these is nearer to its own than to the next: one that is missing in the middle moves all after it.
pub fn is_complete(flips: &Flips, rung: &FlipRung) -> bool {
    let (own, truth) = (&rung.times, &flips.truth.times);
    let late = own.iter().zip(truth).map(|(a, b)| (a - b).abs()).fold(0.0, super::larger);
    let longer = if own.len() > truth.len() { own } else { truth };
    let apart = longer.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    match own.len().abs_diff(truth.len()) {
        0 => true,
        1 => longer.last().is_some_and(|last| 2.0 * late < apart && flips.duration - last <= late / BELOW),
        _ => false,
    }
}

/// Whether roundings decide how many flips a run has before its end: for one of them, copies lie as far apart as the rest of the run is long.
/// A distance of copies counts as in [`flip_order`].
pub fn is_open(flips: &Flips, rung: &FlipRung) -> bool {
    let rest = |flip: usize| flips.duration - rung.times.get(flip).unwrap_or(&flips.duration);
    rung.rounding.iter().enumerate().any(|(flip, apart)| apart * CLEAR > rest(flip))
}

/// Whether the truth is known so badly that it may have another number of flips: one of them is no better known than a tenth of what lies between
/// it and the next, or the end.
pub fn is_unknown(flips: &Flips) -> bool {
    let TrueFlips { times, uncertainty, .. } = &flips.truth;
    let next = times.iter().skip(1).chain([&flips.duration]);
    times.iter().zip(next).any(|(flip, next)| *uncertainty > BELOW * (next - flip))
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
    /// How fast L went through, over |L|, at the slowest [rad/s]; infinite without a flip.
    slowest: f64,
}

impl FlipFinder {
    /// A finder for flips of `axis`, body axes.
    pub fn new(axis: Vector3<f64>) -> FlipFinder {
        FlipFinder { axis, last: None, times: Vec::new(), slowest: f64::INFINITY }
    }

    /// Takes the next state.
    #[inline]
    pub fn push(&mut self, state: &Snapshot) {
        self.take(state, self.seen(state));
    }

    /// L·a and its rate (L × Ω)·a for the axis a.
    #[inline]
    fn seen(&self, state: &Snapshot) -> (f64, f64) {
        let axis = state.orientation * self.axis;
        (state.angular_momentum.dot(&axis), state.angular_momentum.cross(&state.angular_velocity).dot(&axis))
    }

    #[inline]
    fn take(&mut self, state: &Snapshot, now: (f64, f64)) {
        if let Some((time, before)) = self.last
            && before.0 != 0.0
            && before.0.signum() != now.0.signum()
        {
            self.times.push(hermite_root(time, state.time, before, now));
            self.slowest = self.slowest.min(now.1.abs() / rotation::length(&state.angular_momentum));
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

/// Flips by every state and by every second one: what interpolation leaves open is seen from their difference.
struct Twice {
    every: FlipFinder,
    second: FlipFinder,
    pushed: u64,
}

impl Twice {
    fn new(axis: Vector3<f64>) -> Twice {
        Twice { every: FlipFinder::new(axis), second: FlipFinder::new(axis), pushed: 0 }
    }

    #[inline]
    fn push(&mut self, state: &Snapshot) {
        let seen = self.every.seen(state);
        self.every.take(state, seen);
        if self.pushed.is_multiple_of(2) {
            self.second.take(state, seen);
        }
        self.pushed += 1;
    }

    /// What interpolation leaves open [s]; nothing is known where every second state shows other flips.
    fn uncertainty(&self) -> f64 {
        let (fine, coarse) = (&self.every.times, &self.second.times);
        // The last state may be left out of every second, and a flip with it.
        if coarse.len() + 1 < fine.len() || coarse.len() > fine.len() {
            return f64::INFINITY;
        }
        let apart = fine.iter().zip(coarse).map(|(a, b)| (a - b).abs()).fold(0.0, super::larger);
        apart / (COARSER - 1.0)
    }
}

/// Flips of the truth, by dop853 from each state of the reference to the next, so that no error grows over the run; `None` for a body that does
/// not tumble, or where the solver fails.
pub fn true_flips(system: &System, reference: &Reference, fastest: f64) -> Option<TrueFlips> {
    let axis = tumbling_axis(system)?;
    let duration = *reference.times.last()?;
    let fine = TRUE_SAMPLES.max((duration * fastest * 16.0).min(65536.0) as u32);
    // An even number, so that every second state is one of the reference.
    let parts = 2 * fine.div_ceil(2 * (reference.times.len() as u32 - 1));
    let (mut finder, mut apart) = (Twice::new(axis), 0.0);
    finder.push(reference.states.first()?);
    for (pair, start) in reference.states.windows(2).zip(&reference.times) {
        let long = pair[1].time - pair[0].time;
        let times: Vec<f64> = (0..=parts).map(|j| f64::from(j) * long / f64::from(parts)).collect();
        let states = motion(&system.started_at(&pair[0]), &times)?;
        states[1..].iter().for_each(|s| finder.push(&Snapshot { time: start + s.time, ..*s }));
        let angle = rotation::angle_between(&states.last()?.orientation, &pair[1].orientation);
        apart = super::larger(apart, angle);
    }
    let slowest = finder.every.slowest;
    let uncertainty = finder.uncertainty() + apart / slowest;
    Some(TrueFlips { times: finder.every.times, uncertainty, slowest })
}

/// The motion by dop853, or without the feature `solvers` by the Taylor series.
fn motion(system: &System, times: &[f64]) -> Option<Vec<Snapshot>> {
    #[cfg(feature = "solvers")]
    return Some(dop853::solve(system, times, dop853::TOLERANCE).ok()?.states);
    #[cfg(not(feature = "solvers"))]
    return Some(
        precise::solve(system, times, precise::AFFORDABLE)
            .ok()?
            .moments
            .iter()
            .map(precise::Moment::snapshot)
            .collect(),
    );
}

/// Whether the times are decided, and the finest runs have the flips of the truth.
fn are_settled(flips: &Flips) -> bool {
    let finest = &flips.rungs[flips.rungs.len().saturating_sub(COUNTED)..];
    let complete = finest.iter().all(|rung| is_complete(flips, rung));
    complete && !matches!(flip_order(flips), Decision::Undecided(_))
}

/// Runs a scheme at halved steps and finds its flips, until their times are settled. `motion` is that of the truth.
pub fn flips(
    contestant: &Contestant,
    system: &System,
    motion: &[Snapshot],
    fastest: f64,
    truth: TrueFlips,
) -> Option<Flips> {
    let (axis, duration) = (tumbling_axis(system)?, motion.last()?.time);
    let copies = copies::starts(system, motion, f64::EPSILON, system.body.is_given_by_points());
    let mut flips = Flips { truth, duration, rungs: Vec::new() };
    for index in 0..MOST_RUNGS {
        let steps = (duration * fastest / COARSEST_TURN).ceil() as u64 * (1 << index);
        if index >= FEWEST_RUNGS && (steps > MOST_STEPS || are_settled(&flips)) {
            break;
        }
        let plan = Plan { step: duration / steps as f64, steps, every: 1 };
        let found = |start: &System| {
            let mut finder = Twice::new(axis);
            contestant.stream(start, Form::Least, &plan, &mut |state| finder.push(state));
            finder
        };
        let own = found(system);
        let uncertainty = own.uncertainty();
        let times = own.every.times;
        flips.rungs.push(FlipRung { step: plan.step, steps, times, uncertainty, rounding: Vec::new() });
        if index + 1 >= FEWEST_RUNGS {
            let copies: Vec<Vec<f64>> = copies.iter().map(|copy| found(copy).every.times).collect();
            add_rounding(&mut flips.rungs, &copies);
        }
    }
    Some(flips)
}

/// Gives the finest run the roundings that its copies show, and the coarser ones that have none the same: a run of fewer steps rounds no more.
fn add_rounding(rungs: &mut [FlipRung], copies: &[Vec<f64>]) {
    let Some(rounding) = rungs.last().map(|finest| rounding(&finest.times, copies)) else { return };
    let without = rungs.iter_mut().rev().take_while(|rung| rung.rounding.is_empty());
    without.for_each(|rung| rung.rounding.clone_from(&rounding));
}

/// The largest distance of a flip of a copy from that of the run; infinite for a flip that not all have.
fn rounding(own: &[f64], copies: &[Vec<f64>]) -> Vec<f64> {
    let most = copies.iter().map(Vec::len).fold(own.len(), usize::max);
    let apart = |flip: usize, copy: &Vec<f64>| match (own.get(flip), copy.get(flip)) {
        (Some(own), Some(copy)) => (own - copy).abs(),
        _ => f64::INFINITY,
    };
    let largest = |flip| copies.iter().map(|copy| apart(flip, copy)).fold(0.0, super::larger);
    (0..most).map(|flip| to_digits(largest(flip), ROUNDING_DIGITS)).collect()
}
