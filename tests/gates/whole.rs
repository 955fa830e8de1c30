//! The verdicts as a whole: refusals, exit codes, names, files, and references.

use std::sync::Arc;

use polhode::campaign::Campaign;
use polhode::gates::{self, Baseline};
use polhode::internals::gates::judge_reference;
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{ClaimName, Evidence, Records, ReferenceEvidence, Rung, SceneRow, Verdict};
use polhode::scenes::Scene;
use polhode::schemes::{Claim, Quantity};

use super::case::{Made, numbers};
use crate::common;

#[test]
fn the_worst_verdict_that_is_not_known_gives_the_exit_code() {
    let verdict = |(ruling, known): &(Ruling, bool)| Verdict {
        verdict: *ruling,
        known_deviation: known.then(|| "it is so".to_owned()),
        ..Verdict::default()
    };
    for (rows, expected) in [
        (&[] as &[_], 2),
        (&[(Pass, false)], 0),
        (&[(Pass, false), (NotApplicable, false)], 0),
        (&[(Pass, false), (Inconclusive, false)], 2),
        (&[(Pass, false), (Inconclusive, true)], 0),
        (&[(Inconclusive, false), (Fail, false)], 1),
        (&[(Inconclusive, false), (Fail, true)], 2),
        (&[(Inconclusive, false), (Broken, false)], 1),
        (&[(Fail, true), (Broken, true), (Pass, false)], 0),
    ] {
        let verdicts: Vec<Verdict> = rows.iter().map(verdict).collect();
        assert_eq!(gates::exit_code(&verdicts), expected, "{rows:?}");
    }
}

#[test]
fn a_scheme_that_cannot_take_a_scene_has_every_claim_not_applicable_with_the_reason() {
    let mut made = Made::new("free-asymmetric", &[Claim::Order(2), Claim::Rigid]);
    made.evidence.refused = Some("it has wheels".to_owned());
    let verdicts = made.judge();
    let claims: Vec<ClaimName> = verdicts.iter().map(|v| v.claim).collect();
    assert_eq!(claims, [ClaimName::Order, ClaimName::Rigid]);
    for found in verdicts {
        assert_eq!((found.quantity.as_str(), found.detail.as_str()), ("all", "it has wheels"));
        assert_eq!((found.verdict, numbers(&found)), (NotApplicable, [None; 3]));
    }
}

/// A free needle with these moments of inertia, the largest 1 kg m² and more by the smallest, and this angular velocity in its axes.
fn needle(smallest: f64, spin: [f64; 3], schemes: &[&str]) -> Records {
    let text = format!(
        "name = 'needle'\nduration = 5.0\n[body]\nmass = 1.0\ninertia = [{smallest}, 1.0, {}]\n[initial]\nangular_velocity = {spin:?}\n",
        1.0 + smallest
    );
    let scene = Scene::parse(&text, "needle.toml").expect("a scene");
    Campaign::of(vec![scene], schemes.iter().map(|name| common::contestant(name)).collect()).run()
}

fn red(records: &Records) -> Vec<&Verdict> {
    records.verdicts.iter().filter(|verdict| ![Pass, NotApplicable].contains(&verdict.verdict)).collect()
}

#[test]
fn a_needle_that_no_step_of_a_ladder_is_small_enough_for_is_judged_at_its_beginning() {
    let records = needle(2.08e-5, [0.1, 1.0, 2.0], &["euler", "rk4-quaternion"]);
    assert!(red(&records).is_empty(), "{:#?}", red(&records));
    let of =
        |scheme: &str| records.evidence.iter().find(|evidence| evidence.scheme == scheme).expect("a cell");
    assert!(of("euler").beginning.is_some() && of("rk4-quaternion").beginning.is_none());
}

#[test]
fn the_energy_of_a_needle_and_its_way_back_round_by_the_condition_of_its_moments() {
    // In f64 the energy of the third drifts by 3e-11 in roundings that add up, and is judged in double-double.
    for (smallest, spin, precise) in
        [(1e-3, [5.0, 0.3, 0.2], false), (1e-4, [5.0, 0.3, 0.2], false), (1e-5, [1.0, 0.0, 1e-3], true)]
    {
        let records = needle(smallest, spin, &["implicit-midpoint"]);
        assert!(red(&records).is_empty(), "{smallest}: {:#?}", red(&records));
        let drift = records.evidence[0].drift.as_ref().expect("long runs");
        assert_eq!(drift.double_double, precise, "{smallest}");
    }
}

#[test]
fn every_verdict_names_its_scene_and_its_scheme() {
    let made = Made::of_order(
        "free-asymmetric",
        &[Claim::Order(2), Claim::Rigid, Claim::Evaluations(2), Claim::VerticalMomentum],
        2.0,
    );
    let verdicts = made.judge();
    assert!(verdicts.len() >= 10);
    for v in verdicts {
        assert_eq!((v.scene.as_str(), v.scheme.as_str()), ("free-asymmetric", "made-up"));
        assert!(!v.detail.is_empty());
    }
}

#[test]
fn stored_evidence_is_judged_as_it_was_and_a_scene_at_a_time_after_its_reference() {
    let first = Made::of_order("free-asymmetric", &[Claim::Order(2), Claim::FlipTimes], 2.0);
    let second = Made::of_order("kovalevskaya", &[Claim::Order(2)], 1.0).broken(3);
    let evidence: Vec<Arc<Evidence>> = [&second, &first].map(|made| Arc::new(made.evidence.clone())).to_vec();
    let scenes = ["free-asymmetric", "kovalevskaya", "slow-sphere"];
    let references = scenes.map(|scene| ReferenceEvidence {
        scene: scene.to_owned(),
        worst: Some((Quantity::Position, 1e-9)),
        ..ReferenceEvidence::default()
    });
    let records = Records {
        scenes: scenes.map(|name| SceneRow { name: name.to_owned(), ..SceneRow::default() }).to_vec(),
        evidence,
        references: references.to_vec(),
        ..Records::default()
    };
    let text = serde_json::to_string(&records).expect("JSON");
    let read: Records = serde_json::from_str(&text).expect("records");
    assert_eq!(read, records);
    let verdicts = gates::judge_all(&read, &Baseline::default());
    let reference = |scene: usize| judge_reference(&records.references[scene]);
    let expected =
        [vec![reference(0)], first.judge(), vec![reference(1)], second.judge(), vec![reference(2)]];
    assert_eq!(verdicts, expected.concat());
}

/// The verdict on a reference whose least certain quantity is known to this part of its size.
fn judged(worst: Option<f64>) -> Verdict {
    judge_reference(&ReferenceEvidence {
        scene: "here".to_owned(),
        worst: worst.map(|worst| (Quantity::Orientation, worst)),
        ..ReferenceEvidence::default()
    })
}

#[test]
fn a_reference_is_certain_to_a_millionth_of_the_size_of_every_quantity() {
    for (worst, expected) in
        [(0.0, Pass), (1e-6, Pass), (1e-6f64.next_up(), Inconclusive), (f64::NAN, Inconclusive)]
    {
        let found = judged(Some(worst));
        assert_eq!((found.verdict, found.quantity.as_str()), (expected, "orientation"), "{worst}");
        assert_eq!(numbers(&found)[1..], [Some(0.0), Some(1e-6)]);
        assert_eq!(found.measured, Some(worst).filter(|worst| worst.is_finite()));
    }
    let infinite = judged(None);
    assert_eq!((infinite.verdict, infinite.measured), (Inconclusive, None));
    assert_eq!((infinite.scheme.as_str(), infinite.claim), ("reference", ClaimName::ReferencesAgree));
    let missing = ReferenceEvidence { missing: Some("no solver".to_owned()), ..ReferenceEvidence::default() };
    let found = judge_reference(&missing);
    assert_eq!((found.verdict, numbers(&found)), (Inconclusive, [None; 3]));
}

#[test]
fn what_a_campaign_measured_is_a_baseline_that_it_meets_and_another_scheme_does_not() {
    // Points, a box of inertia alone, a rod, and errors of radians.
    let scenes =
        || ["tether-springs", "mujoco-free-box", "swinging-rod", "thin-body"].map(common::scene).to_vec();
    let campaign = |scheme: &str| Campaign::of(scenes(), vec![common::contestant(scheme)]);
    let records = campaign("peskin-rk2").run();
    let baseline = Baseline::from_records(&records);
    let constants = |verdicts: Vec<Verdict>| -> Vec<Verdict> {
        verdicts.into_iter().filter(|verdict| verdict.claim == ClaimName::Constant).collect()
    };
    let own = constants(gates::judge_all(&records, &baseline));
    assert!(own.len() > 12 && own.iter().all(|verdict| verdict.verdict == Pass), "{own:#?}");
    let mut other = common::contestant("peskin-trapezoid");
    other.card.name = "peskin-rk2";
    let changed = Campaign { baseline, ..Campaign::of(scenes(), vec![other]) };
    assert!(constants(changed.run().verdicts).iter().any(|verdict| verdict.verdict == Fail));
}

#[test]
fn what_f64_does_not_hold_is_measured_in_double_double_and_stored() {
    for (scheme, scene) in [("strang-symmetric-8", "free-asymmetric"), ("course-code-euler", "fast-sphere")] {
        let records = Campaign::of(vec![common::scene(scene)], vec![common::contestant(scheme)]).run();
        let not_pass = |v: &&Verdict| !matches!(v.verdict, Pass | NotApplicable);
        assert_eq!(records.verdicts.iter().find(not_pass), None, "{scheme}");
        let evidence = &records.evidence[0];
        let turn =
            |rung: &Rung| rung.errors[Quantity::Orientation].iter().fold(0.0f64, |a, b| a.max(b.abs()));
        if scheme == "strang-symmetric-8" {
            let finer = evidence.precise.as_ref().expect("a ladder in double-double");
            assert!(finer.double_double && turn(finer.rungs.last().expect("a run")) > 0.0);
        } else {
            let exact = evidence.exactness.as_ref().expect("runs in double-double");
            // A hundred units of 2e-31 after up to 32 steps.
            assert!(exact.rungs.len() >= 3 && exact.rungs.iter().all(|rung| turn(rung) < 1e-27));
        }
        let read: Records =
            serde_json::from_str(&serde_json::to_string(&records).expect("JSON")).expect("records");
        assert_eq!(gates::judge_all(&read, &Baseline::built_in()), records.verdicts, "{scheme}");
    }
}
