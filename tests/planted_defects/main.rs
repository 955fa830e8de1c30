//! The verifier verified: a faithful copy of the scheme stays green, and every planted defect turns the gate red.

mod copy;

use copy::{Defect, contestant};
use polhode::campaign::Campaign;
use polhode::gates::{self, Baseline};
use polhode::record::{Records, Ruling};
use polhode::scenes::Scene;
use rayon::prelude::*;

/// Scenes in which the defects show, those that catch most first.
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

fn gate(defect: Defect, scenes: &[&str]) -> Records {
    let scenes = scenes.iter().map(|name| Scene::find(name).expect("built in")).collect();
    let baseline = Baseline::built_in();
    Campaign { scenes, contestants: vec![contestant(defect)], baseline, series: false, progress: &|_, _| () }
        .run()
}

#[test]
fn a_faithful_copy_of_the_scheme_passes_every_gate() {
    let records = gate(Defect::None, &SCENES);
    let held_against: Vec<_> = records
        .verdicts
        .iter()
        .filter(|v| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable))
        .map(|v| format!("{} {} {}: {}", v.scene, v.claim, v.quantity, v.detail))
        .collect();
    assert_eq!(gates::exit_code(&records.verdicts), 0, "{held_against:#?}");
    assert!(records.verdicts.iter().filter(|v| v.claim == "constant").count() > 40);
}

#[test]
fn every_planted_defect_turns_the_gate_red() {
    let survivors: Vec<Defect> = Defect::ALL
        .into_par_iter()
        .filter(|defect| {
            // One scene after the other: the first that catches it is enough.
            !SCENES.iter().any(|scene| {
                let records = gate(*defect, &[scene]);
                let failed = records.verdicts.iter().any(|v| v.verdict == Ruling::Fail);
                failed && gates::exit_code(&records.verdicts) == 1
            })
        })
        .collect();
    assert!(survivors.is_empty(), "no gate caught {survivors:?}");
}

#[test]
fn defects_that_stay_second_order_are_caught_by_a_constant_or_by_exactness() {
    let scenes = ["free-asymmetric", "gravity-drag", "fast-sphere"];
    let missed: Vec<Defect> = Defect::ALL
        .into_par_iter()
        .filter(|defect| defect.stays_second_order())
        .filter(|defect| {
            let records = gate(*defect, &scenes);
            !records
                .verdicts
                .iter()
                .any(|v| v.verdict == Ruling::Fail && matches!(v.claim.as_str(), "constant" | "exact"))
        })
        .collect();
    assert!(missed.is_empty(), "neither constant nor exactness caught {missed:?}");
}
