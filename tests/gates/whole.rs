//! The verdicts as a whole: refusals, exit codes, runs that broke, and references.

use nalgebra::Vector3;
use polhode::internals::gates;
use polhode::internals::rotation::Rotation;
use polhode::model::{PerQuantity, Snapshot};
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::Verdict;
use polhode::reference::Reference;
use polhode::schemes::{Claim, Quantity};

use super::case::{Made, broken, numbers};
use crate::common::scene;

fn verdict(ruling: Ruling, known: bool) -> Verdict {
    let known_deviation = known.then(|| "it is so".to_owned());
    Verdict { verdict: ruling, known_deviation, ..Verdict::default() }
}

#[test]
fn the_worst_verdict_that_is_not_known_gives_the_exit_code() {
    let code = |rows: &[(Ruling, bool)]| {
        gates::exit_code(&rows.iter().map(|(ruling, known)| verdict(*ruling, *known)).collect::<Vec<_>>())
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
        assert_eq!(code(rows), expected, "{rows:?}");
    }
}

#[test]
fn a_scheme_that_cannot_take_a_scene_has_every_claim_not_applicable_with_the_reason() {
    let made = Made::new("free-asymmetric", &[Claim::Order(2), Claim::Rigid]);
    let verdicts = gates::refuse("here", &made.card, "it has wheels");
    let claims: Vec<_> = verdicts.iter().map(|v| v.claim.word()).collect();
    assert_eq!(claims, ["order", "rigid"]);
    for found in verdicts {
        assert_eq!(
            (found.scene.as_str(), found.scheme.as_str(), found.quantity.as_str(), found.detail.as_str()),
            ("here", "made-up", "all", "it has wheels")
        );
        assert_eq!((found.verdict, numbers(&found)), (NotApplicable, [None; 3]));
    }
}

#[test]
fn a_run_that_broke_is_told_of_a_scheme_that_claims_no_order() {
    let of = |claims: &'static [Claim], breaks: bool| {
        let mut made = Made::new("free-asymmetric", claims);
        if breaks {
            made.evidence.rungs[2] = broken(made.evidence.rungs[2].clone());
        }
        made.judge()
            .into_iter()
            .filter(|v| v.claim.word() == "run")
            .map(|v| (v.verdict, v.quantity))
            .collect::<Vec<_>>()
    };
    assert_eq!(of(&[Claim::Rigid], true), [(Broken, "all".to_owned())]);
    assert!(of(&[Claim::Rigid], false).is_empty() && of(&[Claim::Order(2)], true).is_empty());
}

#[test]
fn every_verdict_names_its_scene_and_its_scheme() {
    let made = Made::new("free-asymmetric", &[Claim::Rigid, Claim::Evaluations(2), Claim::VerticalMomentum]);
    let verdicts = made.judge();
    assert!(verdicts.len() >= 3);
    assert!(
        verdicts
            .iter()
            .all(|v| v.scene == "free-asymmetric" && v.scheme == "made-up" && !v.detail.is_empty())
    );
}

/// What is changed of a state.
type Change = fn(&mut Snapshot);

/// A body at rest, and then as changed, as a reference that is as uncertain at first.
fn judged(uncertainty: PerQuantity<f64>, change: Change) -> Verdict {
    let scene = scene("free-asymmetric");
    let zero = Vector3::zeros();
    let rest = Snapshot {
        time: 0.0,
        position: zero,
        velocity: zero,
        orientation: Rotation::identity(),
        angular_velocity: zero,
        angular_momentum: zero,
        stretch: 0.0,
    };
    let mut state = rest;
    change(&mut state);
    let states = vec![rest, state];
    let uncertainty = vec![uncertainty, PerQuantity::all(0.0)];
    let reference = Reference { times: vec![0.0, 1.0], states, uncertainty, sources: Vec::new() };
    gates::judge_reference("here", &scene.system, &reference)
}

fn uncertain(quantity: Quantity, value: f64) -> PerQuantity<f64> {
    let mut uncertainty = PerQuantity::all(0.0);
    uncertainty[quantity] = value;
    uncertainty
}

#[test]
fn a_reference_is_certain_to_a_millionth_of_the_scale_of_every_quantity() {
    let extent = scene("free-asymmetric").system.body.extent();
    let large = |state: &mut Snapshot| {
        state.position = Vector3::new(0.0, 100.0, 0.0);
        state.velocity = Vector3::new(-200.0, 0.0, 0.0);
        state.angular_velocity = Vector3::new(0.0, 0.0, 300.0);
        state.angular_momentum = Vector3::new(0.0, -400.0, 0.0);
    };
    let turning = |state: &mut Snapshot| state.angular_velocity = Vector3::new(0.0, 0.0, 300.0);
    let scales: [(Quantity, f64, Change); 8] = [
        (Quantity::Position, 100.0, large),
        (Quantity::BodyPoint, 100.0, large),
        (Quantity::Velocity, if 300.0 * extent > 200.0 { 300.0 * extent } else { 200.0 }, large),
        (Quantity::Orientation, 1.0, large),
        (Quantity::AngularVelocity, 300.0, large),
        (Quantity::AngularMomentum, 400.0, large),
        // A body that hardly moves is as large as it is, and its points as fast as it turns.
        (Quantity::Position, extent, turning),
        (Quantity::Velocity, 300.0 * extent, turning),
    ];
    for (quantity, scale, change) in scales {
        let at = |part: f64| judged(uncertain(quantity, part * scale), change);
        let (below, above) = (at(0.99e-6), at(1.01e-6));
        assert_eq!([below.verdict, above.verdict], [Pass, Inconclusive], "{quantity:?}");
        assert_eq!([below.quantity.as_str(), above.quantity.as_str()], [quantity.name(); 2]);
        assert!((below.measured.expect("a number") - 0.99e-6).abs() < 1e-12, "{quantity:?}: {below:?}");
        assert_eq!(numbers(&below)[1..], [Some(0.0), Some(1e-6)]);
    }
}

#[test]
fn the_least_certain_quantity_is_named_and_nan_is_no_certainty() {
    let turning = |state: &mut Snapshot| state.angular_velocity = Vector3::new(0.0, 0.0, 300.0);
    let mut uncertainty = uncertain(Quantity::Orientation, 1e-8);
    uncertainty[Quantity::AngularVelocity] = 1e-7;
    let found = judged(uncertainty, turning);
    assert_eq!((found.verdict, found.quantity.as_str(), found.measured), (Pass, "orientation", Some(1e-8)));
    assert_eq!(
        (found.scene.as_str(), found.scheme.as_str(), found.claim.word()),
        ("here", "reference", "references-agree")
    );
    let certain = judged(PerQuantity::all(0.0), turning);
    assert_eq!((certain.verdict, certain.quantity.as_str(), certain.measured), (Pass, "position", Some(0.0)));
    // A bound that is met exactly.
    assert_eq!(judged(uncertain(Quantity::Orientation, 1e-6), |_| ()).verdict, Pass);
    // Of what is nothing throughout there is nothing to be certain of.
    assert_eq!(judged(uncertain(Quantity::AngularVelocity, 1.0), |_| ()).verdict, Pass);
    assert_eq!(judged(uncertain(Quantity::AngularVelocity, f64::NAN), turning).verdict, Inconclusive);
    let infinite = judged(uncertain(Quantity::Orientation, f64::INFINITY), |_| ());
    assert_eq!((infinite.verdict, infinite.measured), (Inconclusive, None));
}
