//! The verifier verified: defects are planted, and each must turn a gate red; a faithful copy of the scheme must stay green.
//!
//! A defect stands in the scheme (a copy of it on mass points, in plain loops), in a force law, in the start of a run, in what a run
//! shows of its state, in the reference, in a metric, in what is claimed, or in the judge of orders. It is judged in scene after scene, against
//! what the right scheme has on record there, until two gates have caught it.

mod beyond_f64;
mod copy;
mod faint;
mod flaw;
pub mod judges;
pub mod ladders;
mod measured;
mod mistaken;
pub mod noise;
mod planted;
pub mod power;
mod promised;
pub mod random;
mod trial;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::gates::Baseline;
use crate::interrupt;
use crate::record::{Ruling, Verdict};
use flaw::Flaw;
use planted::Plant;
use trial::{judge, verdicts};

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
        ("scheme", faint::FAINT),
        ("scheme", beyond_f64::BEYOND_F64),
        ("law", planted::LAWS),
        ("start", planted::STARTS),
        ("shown", planted::SHOWN),
        ("claim", promised::CLAIMS),
        ("reference", mistaken::REFERENCES),
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
    let judges = judges::WRONG_JUDGES.iter().map(exposed);
    let on_record = on_record(&defects);
    let held_against_the_copy = held_against_the_copy(&on_record);
    tick();
    let outcomes = defects
        .par_iter()
        .filter(|_| !interrupt::requested())
        .map(|defect| {
            let outcome = look_for(defect, &on_record);
            tick();
            outcome
        })
        .collect::<Vec<Outcome>>();
    let outcomes = outcomes.into_iter().chain(judges).collect();
    Findings { outcomes, held_against_the_copy, complete: !interrupt::requested() }
}

/// A wrong judge is caught by the made-up ladders on which it says something else than the right one.
fn exposed(judge: &judges::WrongJudge) -> Outcome {
    Outcome {
        name: format!("judge that {}", judge.name),
        place: "judge",
        caught_by: judge.exposed_by().map(|row| format!("ladder: {}", row.name)).collect(),
        scenes: Vec::new(),
    }
}

/// What the right schemes have on record, by scene.
fn on_record(defects: &[Defect]) -> BTreeMap<&'static str, Baseline> {
    let mut schemes: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for defect in defects {
        for scene in defect.scenes {
            schemes.entry(scene).or_default().insert(defect.plant.scheme());
        }
    }
    let schemes: Vec<_> = schemes.into_iter().filter(|_| !interrupt::requested()).collect();
    schemes.into_par_iter().map(|(scene, schemes)| (scene, trial::on_record(scene, &schemes))).collect()
}

fn held_against_the_copy(on_record: &BTreeMap<&str, Baseline>) -> Vec<String> {
    let not_green = |v: &Verdict| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable);
    SCENES
        .par_iter()
        .filter_map(|scene| Some(judge(copy::contestant(Flaw::None), scene, on_record.get(scene)?)))
        .flatten()
        .filter(|verdict| not_green(verdict) && verdict.known_deviation.is_none())
        .map(|v| format!("{} {} {}: {}", v.scene, v.claim, v.quantity, v.detail))
        .collect()
}

fn look_for(defect: &Defect, on_record: &BTreeMap<&str, Baseline>) -> Outcome {
    let mut outcome = Outcome {
        name: defect.name.clone(),
        place: defect.place,
        caught_by: BTreeSet::new(),
        scenes: Vec::new(),
    };
    for scene in defect.scenes {
        if interrupt::requested() {
            break;
        }
        let Some(baseline) = on_record.get(scene) else { continue };
        let red: Vec<String> = verdicts(&defect.plant, scene, baseline)
            .into_iter()
            .filter(|v| matches!(v.verdict, Ruling::Fail | Ruling::Broken) && v.known_deviation.is_none())
            .map(|verdict| verdict.claim.to_string())
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_flaws_read_as_words() {
        assert_eq!(words("HalfAngleIn5"), "half angle in 5");
    }

    /// The others take minutes: `tests/slow`.
    #[test]
    fn two_gates_catch_each_defect_of_wheels_damping_pulses_and_orbits() {
        let scenes =
            ["gyrostat", "damped-tumble", "magnetic-satellite", "thruster-pulse", "satellite-circular-orbit"];
        let is_own = |defect: &Defect| defect.place == "law" && scenes.contains(&defect.scenes[0]);
        let own: Vec<Defect> = defects().into_iter().filter(is_own).collect();
        let on_record = on_record(&own);
        let outcomes: Vec<Outcome> = own.iter().map(|defect| look_for(defect, &on_record)).collect();
        assert_eq!(outcomes.len(), 14);
        for outcome in outcomes {
            assert!(outcome.caught_by.len() >= ENOUGH, "{outcome:?}");
        }
    }

    #[test]
    fn there_are_eighty_defects_and_each_is_named_once() {
        let names: BTreeSet<String> = defects().into_iter().map(|defect| defect.name).collect();
        assert_eq!(names.len(), defects().len());
        assert!(names.len() >= 80, "{}", names.len());
    }
}
