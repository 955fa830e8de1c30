//! Wrong orders in random scenes: the other side of a false alarm. A gate that never fails anybody would hold nothing against a
//! correct scheme either; how often it fails one whose order is not what it says is its power.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::faint::Contaminated;
use super::random::{Tally, cause, weight};
use crate::campaign::Campaign;
use crate::claim::Claim;
use crate::gates::Baseline;
use crate::interrupt;
use crate::record::{ClaimName, Ruling, Verdict};
use crate::scenes::random::{self, Family};
use crate::schemes::Card;
use crate::simulate::Contestant;

/// A scheme of the list, and an order above its own: a claim that is too low holds but in generic scenes.
struct Misdeclared {
    name: &'static str,
    scheme: &'static str,
    claims: &'static [Claim],
}

macro_rules! misdeclared {
    ($($scheme:literal: $($order:literal),*;)*) => {
        &[$($(Misdeclared {
            name: concat!($scheme, ", claimed ", $order),
            scheme: $scheme,
            claims: &[Claim::Order($order)],
        }),*),*]
    };
}

const MISDECLARED: &[Misdeclared] = misdeclared! {
    "peskin-rk2": 3;
    "euler": 2;
    "rk4-quaternion": 5;
    "rkmk4": 5;
    "strang-rotations": 3;
    "implicit-midpoint": 3;
    "adams-bashforth-2": 3;
};

/// What the order gate said of one wrong order.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// The scheme and what is wrong.
    pub name: &'static str,
    /// Scenes, by the worst verdict on the order in each.
    pub scenes: Tally,
    /// Verdicts on single quantities.
    pub quantities: Tally,
    /// Numbers of the scenes that pass.
    pub passed: Vec<u64>,
    /// How often each reason left a quantity undecided.
    pub causes: BTreeMap<String, usize>,
}

impl Row {
    /// The part of the scenes with an order to measure in which the gate fails.
    pub fn power(&self) -> f64 {
        let judged = self.scenes.all() - self.scenes.not_applicable;
        self.scenes.fail as f64 / judged.max(1) as f64
    }
}

fn contestants() -> Vec<Contestant> {
    let all = Contestant::all();
    let claiming = |wrong: &Misdeclared| {
        let mut scheme = all.iter().find(|c| c.card.name == wrong.scheme)?.clone();
        scheme.card = Card { name: wrong.name, claims: wrong.claims, ..scheme.card };
        Some(scheme)
    };
    let contaminated = [Contestant::new(Contaminated::<100>), Contestant::new(Contaminated::<1000>)];
    MISDECLARED.iter().filter_map(claiming).chain(contaminated).collect()
}

/// Judges wrong orders in the first `count` random scenes of a seed.
pub fn run(seed: u64, count: u64) -> Vec<Row> {
    let contestants = contestants();
    let judged: Vec<(u64, Vec<Verdict>)> = (0..count)
        .into_par_iter()
        .filter(|_| !interrupt::requested())
        .filter_map(|number| Some((number, random::scene(Family::Ordinary, seed, number).ok()?)))
        .map(|(number, scene)| {
            let campaign =
                Campaign { baseline: Baseline::default(), ..Campaign::of(vec![scene], contestants.clone()) };
            (number, campaign.run().verdicts)
        })
        .collect();
    contestants.iter().map(|contestant| row(contestant.card.name, &judged)).collect()
}

fn row(name: &'static str, judged: &[(u64, Vec<Verdict>)]) -> Row {
    let mut row = Row { name, ..Row::default() };
    for (number, verdicts) in judged {
        let mut worst = Ruling::NotApplicable;
        for verdict in verdicts.iter().filter(|v| v.scheme == name && v.claim == ClaimName::Order) {
            row.quantities.count(verdict.verdict);
            if verdict.verdict == Ruling::Inconclusive {
                *row.causes.entry(cause(verdict)).or_default() += 1;
            }
            if weight(verdict.verdict) > weight(worst) {
                worst = verdict.verdict;
            }
        }
        row.scenes.count(worst);
        if worst == Ruling::Pass {
            row.passed.push(*number);
        }
    }
    row
}
