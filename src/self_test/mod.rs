//! The verifier verified: defects are planted, and each must turn a gate red; a faithful copy of the scheme must stay green.
//!
//! A defect stands in the scheme (a copy of it on mass points, in plain loops), in a force law, in the start of a run, in what a run
//! shows of its state, in the reference, in a metric, in what is claimed, or in the judge of orders. It is judged in scene after scene until two gates have caught
//! it.

mod copy;
pub mod ladders;
mod measured;
pub mod noise;
mod planted;
pub mod power;
pub mod random;

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::campaign::Campaign;
use crate::claim::Claim;
use crate::gates::{self, Baseline, Case};
use crate::interrupt;
use crate::metrics;
use crate::model::System;
use crate::record::{Ruling, Verdict};
use crate::reference::{Reference, stored};
use crate::scenes::Scene;
use crate::schemes::{Card, PeskinRk2, Scheme};
use crate::simulate::Contestant;
use copy::Flaw;
use planted::Plant;

/// Scenes in which the flaws of the scheme show, those that catch most first.
const SCENES: [&str; 9] = [
    "free-asymmetric",
    "gravity-drag",
    "charged-body-in-fields",
    "time-dependent-field",
    "tether-springs",
    "kovalevskaya",
    "slow-sphere",
    "fast-sphere",
    "gravity-gradient",
];

/// Gates that are enough for a defect.
const ENOUGH: usize = 2;
/// Samples of a reference.
const SAMPLES: usize = 64;

/// A defect, and what became of it.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What is wrong, in words.
    pub name: String,
    /// Where it stands: scheme, law, start, shown, claim, reference, metric or judge.
    pub place: &'static str,
    /// The claims whose gates went red.
    pub caught_by: BTreeSet<String>,
    /// The scenes in which they did.
    pub scenes: Vec<&'static str>,
}

/// What the self-test found.
#[derive(Clone, Debug)]
pub struct Findings {
    /// Every defect.
    pub outcomes: Vec<Outcome>,
    /// What was held against the faithful copy: nothing, in a sound verifier.
    pub held_against_the_copy: Vec<String>,
    /// False where the user ended it early.
    pub complete: bool,
}

impl Findings {
    /// Defects that no gate caught.
    pub fn survivors(&self) -> impl Iterator<Item = &Outcome> {
        self.outcomes.iter().filter(|outcome| outcome.caught_by.is_empty())
    }

    /// Whether every defect was caught and the copy stayed green.
    pub fn sound(&self) -> bool {
        self.complete && self.held_against_the_copy.is_empty() && self.survivors().next().is_none()
    }
}

/// A defect and the scenes to look for it in.
struct Defect {
    name: String,
    place: &'static str,
    plant: Plant,
    scenes: &'static [&'static str],
}

fn defects() -> Vec<Defect> {
    let scheme = Flaw::ALL.into_iter().map(|flaw| Defect {
        name: words(&format!("{flaw:?}")),
        place: "scheme",
        plant: Plant::Scheme(flaw),
        scenes: &SCENES,
    });
    let others = [
        ("law", planted::LAWS),
        ("start", planted::STARTS),
        ("shown", planted::SHOWN),
        ("claim", planted::CLAIMS),
        ("reference", planted::REFERENCES),
        ("metric", measured::METRICS),
    ];
    let others = others.into_iter().flat_map(|(place, rows)| {
        rows.iter().map(move |(name, plant, scenes)| Defect {
            name: (*name).to_owned(),
            place,
            plant: *plant,
            scenes,
        })
    });
    scheme.chain(others).collect()
}

/// `HalfAngleIn5` as "half angle in 5".
fn words(name: &str) -> String {
    let mut words = String::new();
    for letter in name.chars() {
        if !words.is_empty() && (letter.is_uppercase() || letter.is_ascii_digit()) {
            words.push(' ');
        }
        words.extend(letter.to_lowercase());
    }
    words
}

/// Plants every defect. `progress` is called as (done, of all).
pub fn run(progress: &(dyn Fn(usize, usize) + Sync)) -> Findings {
    let defects = defects();
    let done = AtomicUsize::new(0);
    let tick = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, defects.len() + 1);
    let judges = ladders::WRONG_JUDGES.iter().map(told_judge);
    let held_against_the_copy = held_against_the_copy();
    tick();
    let outcomes = defects
        .par_iter()
        .filter(|_| !interrupt::requested())
        .map(|defect| {
            let outcome = look_for(defect);
            tick();
            outcome
        })
        .collect::<Vec<Outcome>>();
    let outcomes = outcomes.into_iter().chain(judges).collect();
    Findings { outcomes, held_against_the_copy, complete: !interrupt::requested() }
}

/// A wrong judge is caught by the made-up ladders on which it says something else than the right one.
fn told_judge(judge: &ladders::WrongJudge) -> Outcome {
    Outcome {
        name: format!("judge that {}", judge.name),
        place: "judge",
        caught_by: judge.told_by().map(|row| format!("ladder-{}", ruling_word(row.right))).collect(),
        scenes: Vec::new(),
    }
}

/// The word of a ruling, for the column of the matrix: ladders that should pass, fail, and so on.
fn ruling_word(ruling: Ruling) -> &'static str {
    match ruling {
        Ruling::Pass => "pass",
        Ruling::Fail => "fail",
        Ruling::Inconclusive => "inconclusive",
        Ruling::NotApplicable => "not-applicable",
        Ruling::Broken => "broken",
    }
}

fn held_against_the_copy() -> Vec<String> {
    let not_green = |v: &Verdict| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable);
    SCENES
        .par_iter()
        .flat_map(|scene| judge(copy::contestant(Flaw::None), scene))
        .filter(|verdict| not_green(verdict) && verdict.known_deviation.is_none())
        .map(|v| format!("{} {} {}: {}", v.scene, v.claim, v.quantity, v.detail))
        .collect()
}

fn look_for(defect: &Defect) -> Outcome {
    let mut outcome = Outcome {
        name: defect.name.clone(),
        place: defect.place,
        caught_by: BTreeSet::new(),
        scenes: Vec::new(),
    };
    for scene in defect.scenes {
        let red: Vec<String> = verdicts(&defect.plant, scene)
            .into_iter()
            .filter(|v| matches!(v.verdict, Ruling::Fail | Ruling::Broken) && v.known_deviation.is_none())
            .map(|verdict| verdict.claim)
            .collect();
        if !red.is_empty() {
            outcome.scenes.push(scene);
            outcome.caught_by.extend(red);
        }
        if outcome.caught_by.len() >= ENOUGH {
            break;
        }
    }
    outcome
}

fn verdicts(plant: &Plant, scene: &str) -> Vec<Verdict> {
    match *plant {
        Plant::Scheme(flaw) => judge(copy::contestant(flaw), scene),
        Plant::Law(change) => judge(bent(move |system| planted::under(system, change), |_, _| ()), scene),
        Plant::Start(change) => {
            let other = move |system: &System| {
                let mut other = system.clone();
                change(&mut other);
                other
            };
            judge(bent(other, |_, _| ()), scene)
        }
        Plant::Shown(change) => judge(bent(System::clone, change), scene),
        Plant::Claims(name, claims) => judge(claiming(name, claims), scene),
        Plant::Reference(change) => judge_against(change, None, scene),
        Plant::Metric(measure) => judge_against(|_| (), Some(measure), scene),
    }
}

/// The scheme on another system than it is judged in, or showing another state than it has.
fn bent(
    other: impl Fn(&System) -> System + Send + Sync + 'static,
    shown: fn(&mut crate::model::Snapshot, &System),
) -> Contestant {
    let scheme = Contestant::new::<PeskinRk2>();
    Contestant::foreign(PeskinRk2::CARD, move |system, form, plan, store| {
        let other = other(system);
        scheme.stream(&other, form, plan, &mut |snapshot| {
            let mut bent = *snapshot;
            shown(&mut bent, system);
            store(&bent);
        })
    })
}

/// A scheme with these claims in place of its own, and a name that no known deviation and no constant on record knows.
fn claiming(name: &str, claims: &'static [Claim]) -> Contestant {
    let all = Contestant::all();
    let mut scheme =
        all.into_iter().find(|c| c.card.name == name).unwrap_or_else(Contestant::new::<PeskinRk2>);
    scheme.card = Card { name: "claimant", claims, ..scheme.card };
    scheme
}

fn judge(contestant: Contestant, scene: &str) -> Vec<Verdict> {
    let Ok(scene) = Scene::find(scene) else { return Vec::new() };
    let campaign = Campaign {
        scenes: vec![scene],
        contestants: vec![contestant],
        baseline: Baseline::built_in(),
        series: false,
        progress: &|_, _| (),
    };
    campaign.run().verdicts
}

/// The scheme against a reference that is wrong, or with errors that are measured wrongly.
fn judge_against(change: fn(&mut Reference), measure: Option<planted::Measure>, scene: &str) -> Vec<Verdict> {
    let Ok(scene) = Scene::find(scene) else { return Vec::new() };
    let stored = stored::find(&scene.name).ok().flatten();
    let Ok(mut reference) = Reference::of(&scene.system, scene.duration, SAMPLES, stored.as_ref()) else {
        return Vec::new();
    };
    change(&mut reference);
    let contestant = Contestant::new::<PeskinRk2>();
    let mut evidence = metrics::climb(&contestant, &scene.system, &reference, 2, true);
    if let Some(measure) = measure {
        evidence = measured::mismeasured(&contestant, &scene.system, &reference, 2, evidence, measure);
    }
    gates::judge(&Case {
        scene: &scene.name,
        not_for_order: scene.not_for_order.as_deref(),
        system: &scene.system,
        card: &contestant.card,
        evidence: &evidence,
        drift: None,
        points: None,
        flips: None,
        reversal: None,
        symplecticity: None,
        other_worlds: &[],
        baseline: &Baseline::built_in(),
        step_limit: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_flaws_read_as_words() {
        assert_eq!(words("HalfAngleIn5"), "half angle in 5");
    }

    #[test]
    fn there_are_eighty_defects_and_each_is_named_once() {
        let names: BTreeSet<String> = defects().into_iter().map(|defect| defect.name).collect();
        assert_eq!(names.len(), defects().len());
        assert!(names.len() >= 80, "{}", names.len());
    }
}
