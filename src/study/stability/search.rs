//! The largest usable step, by search: a ladder of halvings from a coarse step on, bisection between its rungs, and a look
//! around the edge.
//!
//! A larger step may be usable again, by luck: a flip less, a resonance passed. The largest usable step is the one below which
//! everything that was tried is usable; where something above it is, the edge is called ragged.

use std::collections::BTreeMap;

use super::failure::Failure;
use super::trial::{Trial, attempt};
use super::truth::Truth;
use crate::record::stability::{Limit, LimitStatus, Meaning};
use crate::simulate::Contestant;

/// Radians that the coarsest step turns the body, or an oscillation its phase, at most.
const COARSEST_TURN: f64 = 8.0;
/// Fewest steps of a scene.
const FEWEST_STEPS: u64 = 4;
/// Most steps of a scene, …
const MOST_STEPS: u64 = 32_768;
/// … and of a foreign program.
const MOST_FOREIGN_STEPS: u64 = 2_048;
/// Ratio of a step that is not usable to one that is, to which the search closes in.
const RESOLUTION: f64 = 1.01;
/// Parts of the limit that must be usable too, …
const BELOW: [f64; 4] = [0.97, 0.9, 0.8, 0.65];
/// … and multiples of the failing step above it, one of which shows that the edge is ragged if it is usable.
const ABOVE: [f64; 2] = [1.04, 1.15];
/// Edges tried until one is confirmed.
const MOST_EDGES: usize = 4;

/// The runs of one scheme in one scene, each made once.
struct Runs<'a> {
    contestant: &'a Contestant,
    truth: &'a Truth,
    made: BTreeMap<u64, Trial>,
}

impl Runs<'_> {
    fn at(&mut self, steps: u64) -> &Trial {
        let (contestant, truth) = (self.contestant, self.truth);
        self.made.entry(steps).or_insert_with(|| attempt(contestant, truth, steps))
    }

    fn usable(&mut self, steps: u64, meaning: Meaning) -> bool {
        self.at(steps).is_usable(meaning)
    }
}

/// What a search found, in steps of the scene: fewer steps are larger ones.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Edge {
    /// Usable with `usable` steps, not with `failing`, which are fewer.
    Between { usable: u64, failing: u64, ragged: bool },
    /// Usable with the fewest tried.
    Unlimited(u64),
    /// Not usable with the most tried.
    Nowhere(u64),
}

/// The limits of a scheme in a scene, one row for each meaning.
pub fn limits(scene: &str, contestant: &Contestant, truth: &Truth) -> Vec<Limit> {
    if let Some(reason) = contestant.refusal(&truth.system) {
        return Meaning::ALL.map(|meaning| refused(scene, contestant, meaning, &reason)).to_vec();
    }
    let mut runs = Runs { contestant, truth, made: BTreeMap::new() };
    let rungs = ladder(&mut runs);
    if let Some(reason) = runs.made.values().find_map(|trial| trial.refusal.clone()) {
        return Meaning::ALL.map(|meaning| refused(scene, contestant, meaning, &reason)).to_vec();
    }
    Meaning::ALL
        .map(|meaning| {
            let edge = edge(&mut runs, &rungs, meaning);
            row(scene, &mut runs, meaning, edge)
        })
        .to_vec()
}

/// Runs at halved steps until two in a row are usable in every sense.
fn ladder(runs: &mut Runs) -> Vec<u64> {
    let truth = runs.truth;
    let turned = truth.duration * truth.fastest.max(truth.omega);
    let most = if runs.contestant.is_foreign() { MOST_FOREIGN_STEPS } else { MOST_STEPS };
    let mut steps = FEWEST_STEPS.max((turned / COARSEST_TURN).ceil() as u64).min(most / 4);
    let mut rungs = Vec::new();
    let mut good = 0;
    while steps <= most && good < 2 {
        good = if runs.at(steps).usable == [true; 3] { good + 1 } else { 0 };
        rungs.push(steps);
        if runs.at(steps).refusal.is_some() {
            break;
        }
        steps *= 2;
    }
    rungs
}

fn edge(runs: &mut Runs, rungs: &[u64], meaning: Meaning) -> Edge {
    let last_failing = rungs.iter().rposition(|steps| !runs.usable(*steps, meaning));
    let Some(index) = last_failing else {
        return Edge::Unlimited(rungs.first().copied().unwrap_or(FEWEST_STEPS));
    };
    let mut failing = rungs[index];
    let Some(mut usable) = rungs.get(index + 1).copied() else { return Edge::Nowhere(failing) };
    for _ in 0..MOST_EDGES {
        (usable, failing) = bisect(runs, meaning, usable, failing);
        let finer = BELOW.map(|part| (usable as f64 / part).ceil() as u64);
        let Some(worse) = finer.into_iter().rev().find(|steps| !runs.usable(*steps, meaning)) else { break };
        // A smaller step fails: the edge is below it.
        failing = worse;
        match rungs.iter().find(|steps| **steps > worse).copied() {
            Some(next) => usable = next,
            None => return Edge::Nowhere(worse),
        }
    }
    let coarser = ABOVE.map(|part| ((failing as f64 / part) as u64).max(1));
    let mut ragged = coarser.into_iter().any(|steps| runs.usable(steps, meaning));
    ragged |= rungs.iter().any(|steps| *steps < failing && runs.usable(*steps, meaning));
    Edge::Between { usable, failing, ragged }
}

/// Closes in on the edge between a usable and a failing number of steps.
fn bisect(runs: &mut Runs, meaning: Meaning, mut usable: u64, mut failing: u64) -> (u64, u64) {
    while usable > failing + 1 && usable as f64 / failing as f64 > RESOLUTION {
        let middle = ((usable as f64 * failing as f64).sqrt().round() as u64).clamp(failing + 1, usable - 1);
        if runs.usable(middle, meaning) { usable = middle } else { failing = middle }
    }
    (usable, failing)
}

fn row(scene: &str, runs: &mut Runs, meaning: Meaning, edge: Edge) -> Limit {
    let truth = runs.truth;
    let of = |steps: u64| truth.duration / steps as f64;
    let (status, step, fails_at, ragged) = match edge {
        Edge::Between { usable, failing, ragged } => {
            (LimitStatus::Limit, Some(of(usable)), Some(failing), ragged)
        }
        Edge::Unlimited(steps) => (LimitStatus::Unlimited, Some(of(steps)), None, false),
        Edge::Nowhere(steps) => (LimitStatus::None, None, Some(steps), false),
    };
    let failure: Option<Failure> = fails_at.and_then(|steps| runs.at(steps).failure.clone());
    let detail = match (&failure, step) {
        (Some(failure), _) => Some(failure.to_string()),
        (None, Some(step)) => Some(format!("usable at every step tried, up to {step:.3e} s")),
        _ => None,
    };
    Limit {
        scene: scene.to_owned(),
        scheme: runs.contestant.card.name.to_owned(),
        meaning,
        status,
        step_s: step,
        fails_at_s: fails_at.map(of),
        radians_per_step: step.map(|step| step * truth.fastest),
        h_omega: step.map(|step| step * truth.omega),
        omega_rad_s: Some(truth.omega),
        omega_is: if truth.omega_is_natural { "natural frequency" } else { "largest spin" }.to_owned(),
        failure: failure.map(|failure| failure.class().to_owned()),
        detail,
        ragged,
    }
}

/// The row of a scheme that cannot take a scene.
fn refused(scene: &str, contestant: &Contestant, meaning: Meaning, reason: &str) -> Limit {
    Limit {
        scene: scene.to_owned(),
        scheme: contestant.card.name.to_owned(),
        meaning,
        status: LimitStatus::NotApplicable,
        detail: Some(reason.to_owned()),
        ..Limit::default()
    }
}

/// The rows of a scene without a truth.
pub fn without_truth(scene: &str, contestant: &Contestant, reason: &str) -> Vec<Limit> {
    let row = |meaning: Meaning| Limit {
        status: LimitStatus::Broken,
        ..refused(scene, contestant, meaning, reason)
    };
    Meaning::ALL.map(row).to_vec()
}
