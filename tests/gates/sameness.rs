//! Gates that ask whether two runs are the same: there and back, other worlds, mass points, the two-form, the limit on record.

use polhode::record::ClaimName::{
    Equivariant, Reduction, Reversible, Rigid, Stability as Stable, Symplectic, VerticalMomentum,
};
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::stability::{LinearLimit, Stability};
use polhode::record::{OtherWorld, PointRun, Reversal, Symplecticity};
use polhode::schemes::{Claim, Quantity};

use super::case::{Made, numbers};

/// Times its rounding that a difference may be.
const CLEAR: f64 = 30.0;

/// What a hundred solves to 1e-12 leave after 25 steps, over the roundings of 25 steps, √25 u.
fn left_by_solves() -> f64 {
    100.0 * 1e-12 / f64::EPSILON / 5.0
}

#[test]
fn a_claim_without_a_measurement_is_not_applicable() {
    for (claim, name, quantity) in [
        (Claim::Reversible, Reversible, "there-and-back"),
        (Claim::Equivariant, Equivariant, "other-worlds"),
        (Claim::Rigid, Rigid, "rigidity"),
        (Claim::Symplectic, Symplectic, "two-form"),
        (Claim::VerticalMomentum, VerticalMomentum, "vertical-momentum"),
    ] {
        assert_eq!(Made::new("kovalevskaya", &[claim]).ruling(name, quantity), NotApplicable);
    }
}

/// There and back, of which this many roundings are left.
fn reversal(of_rounding: Option<f64>, solves: u64, open: f64) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Reversible]);
    let worst = of_rounding.map(|_| (Quantity::Orientation, 1e-15));
    made.evidence.reversal =
        Some(Reversal { steps: 25, step: 0.5, of_rounding, worst, solves, open, ..Reversal::default() });
    made
}

/// The run in another world, which differs by this many roundings.
fn world(to_the_bit: bool, of_rounding: Option<f64>, solves: u64) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Equivariant]);
    let (name, worst) = ("turned".to_owned(), of_rounding.map(|_| (Quantity::Position, 1e-15)));
    made.evidence.other_worlds =
        vec![OtherWorld { name, to_the_bit, of_rounding, worst, steps: 25, solves, ..OtherWorld::default() }];
    made
}

#[test]
fn there_and_back_and_other_worlds_may_differ_by_roundings_and_what_solves_leave_is_undecided() {
    let most = CLEAR * left_by_solves();
    for (of_rounding, solves, expected) in [
        (0.0, 0, Pass),
        (CLEAR, 0, Pass),
        (CLEAR, 100, Pass),
        (CLEAR.next_up(), 0, Fail),
        (CLEAR.next_up(), 100, Inconclusive),
        (most, 100, Inconclusive),
        (most * 1.001, 100, Fail),
        (f64::NAN, 100, Fail),
    ] {
        let found = reversal(Some(of_rounding), solves, 0.0).verdict(Reversible, "there-and-back");
        assert_eq!(found.verdict, expected, "{of_rounding} {solves}");
        assert_eq!(numbers(&found)[1..], [Some(0.0), Some(CLEAR)]);
        let ruling = world(false, Some(of_rounding), solves).ruling(Equivariant, "other-worlds");
        assert_eq!(ruling, expected, "{of_rounding} {solves}");
    }
    assert_eq!(numbers(&reversal(Some(3.0), 0, 0.0).verdict(Reversible, "there-and-back"))[0], Some(3.0));
    // A run that broke on the way back is broken; one that breaks in another world alone is not the same.
    assert_eq!(reversal(None, 100, 0.0).ruling(Reversible, "there-and-back"), Broken);
    let mut unsolved = reversal(None, 100, 0.0);
    unsolved.evidence.reversal.as_mut().expect("a way").unsolved = true;
    assert_eq!(unsolved.ruling(Reversible, "there-and-back"), Inconclusive);
    let mut elsewhere = world(false, None, 100);
    assert_eq!(elsewhere.ruling(Equivariant, "other-worlds"), Fail);
    // Where an equation is not solved there, nothing is known.
    elsewhere.evidence.other_worlds[0].unsolved = true;
    assert_eq!(elsewhere.ruling(Equivariant, "other-worlds"), Inconclusive);
}

#[test]
fn in_binary_units_every_bit_is_the_same_whatever_is_solved() {
    let at =
        |of_rounding, solves| world(true, Some(of_rounding), solves).verdict(Equivariant, "other-worlds");
    assert_eq!([at(0.0, 0).verdict, at(1e-300, 0).verdict, at(1e-300, 100).verdict], [Pass, Fail, Fail]);
    assert_eq!(numbers(&at(0.0, 0)), [Some(0.0); 3]);
    assert_eq!(
        numbers(&world(false, Some(3.0), 0).verdict(Equivariant, "other-worlds")),
        [Some(3.0), Some(0.0), Some(CLEAR)]
    );
}

#[test]
fn one_world_that_differs_is_the_verdict() {
    let mut made = world(false, Some(3.0), 0);
    let other = made.evidence.other_worlds[0].clone();
    let far = OtherWorld { name: "far".to_owned(), of_rounding: Some(2.0 * CLEAR), ..other };
    made.evidence.other_worlds.push(far);
    let found = made.verdict(Equivariant, "other-worlds");
    assert_eq!((found.verdict, found.measured), (Fail, Some(2.0 * CLEAR)));
}

#[test]
fn where_roundings_turn_the_body_by_much_nothing_is_known_of_its_return() {
    // Thirty roundings are a tenth of a radian.
    let at = |open: f64| reversal(Some(1000.0), 0, open).ruling(Reversible, "there-and-back");
    assert_eq!([at(0.0033), at(0.0034)], [Fail, Inconclusive]);
}

/// A scheme with a run of 10,000 steps of its point form.
fn points(scene: &str, claims: &[Claim], change: impl FnOnce(&mut PointRun)) -> Made {
    let mut made = Made::new(scene, claims);
    let mut points = PointRun { step: 0.5, steps: 10_000, unit: f64::EPSILON, ..PointRun::default() };
    change(&mut points);
    made.evidence.points = Some(points);
    made
}

#[test]
fn points_may_stretch_by_the_rounding_of_their_turns_and_in_a_steady_spin_by_that_of_each() {
    // 4 √n + 8 roundings where the axis tumbles, n more where it stands still.
    for (scene, bound) in
        [("free-asymmetric", 408.0 * f64::EPSILON), ("slow-sphere", 10_408.0 * f64::EPSILON)]
    {
        let at = |stretch: f64| {
            points(scene, &[Claim::Rigid], |points| points.stretch = stretch).verdict(Rigid, "rigidity")
        };
        assert_eq!([at(0.0).verdict, at(bound).verdict], [Pass; 2], "{scene}");
        assert_eq!([at(bound.next_up()).verdict, at(f64::NAN).verdict], [Fail; 2], "{scene}");
        assert_eq!(numbers(&at(1e-15)), [Some(1e-15), Some(0.0), Some(bound)], "{scene}");
        assert_eq!(numbers(&at(f64::NAN))[0], None);
    }
}

#[test]
fn the_least_model_may_differ_from_the_points_by_their_roundings() {
    let at = |difference: f64, rounding: f64, torque_rounding: f64| {
        let set = |points: &mut PointRun| {
            (points.difference, points.rounding, points.torque_rounding) =
                (difference, rounding, torque_rounding);
        };
        points("free-asymmetric", &[], set).ruling(Reduction, "all")
    };
    // 4,096 units, thirty of the roundings that were measured, three of those of the torque.
    let least = 4096.0 * f64::EPSILON;
    for (rounding, torque, bound) in
        [(0.0, 0.0, least), (1e-12, 0.0, least + 30e-12), (0.0, 1e-12, least + 3e-12)]
    {
        assert_eq!([at(bound * 0.999, rounding, torque), at(bound * 1.001, rounding, torque)], [Pass, Fail]);
    }
    let infinite = f64::INFINITY;
    assert_eq!(
        [at(least * 0.9, 0.0, infinite), at(least * 1.1, 0.0, infinite), at(f64::NAN, 0.0, 0.0)],
        [Pass, Fail, Fail]
    );
}

#[test]
fn nothing_is_reduced_where_there_are_only_points_or_none() {
    assert_eq!(Made::new("free-asymmetric", &[]).ruling(Reduction, "all"), NotApplicable);
    let mut made = points("free-asymmetric", &[], |points| points.difference = 1.0);
    assert_eq!(made.ruling(Reduction, "all"), Fail);
    made.evidence.model = "points".to_owned();
    assert_eq!(made.ruling(Reduction, "all"), NotApplicable);
}

#[test]
fn a_step_may_change_the_two_form_by_9e_minus_22_or_in_f64_by_1e_minus_9_over_the_unit_of_its_directions() {
    for (defect, unit, double_double, expected) in [
        (0.0, 1.0, false, Pass),
        (1e-9, 1.0, false, Pass),
        (2e-9, 0.5, false, Pass),
        (1e-9f64.next_up(), 1.0, false, Fail),
        (2.1e-9, 0.5, false, Fail),
        (f64::NAN, 1.0, false, Fail),
        (9e-22, 1.0, true, Pass),
        (1e-21, 1.0, true, Fail),
    ] {
        let mut made = Made::new("free-asymmetric", &[Claim::Symplectic]);
        made.evidence.symplecticity =
            Some(Symplecticity { step: 0.5, defect, unit, double_double, rounding: 0.0 });
        assert_eq!(made.ruling(Symplectic, "two-form"), expected, "{defect} {unit}");
    }
}

#[test]
fn the_vertical_momentum_may_change_by_the_rounding_of_its_sums_on_every_run() {
    // 4 √n + 8 roundings after n steps.
    let bound = |steps: f64| f64::EPSILON * (8.0 + 4.0 * steps.sqrt());
    let (few, many) = (bound(100.0), bound(10_000.0));
    for (changes, expected, worst) in [
        ([few, 0.0], Pass, (few, few)),
        ([0.0, many], Pass, (many, many)),
        ([few.next_up(), 0.0], Fail, (few.next_up(), few)),
        ([0.0, many.next_up()], Fail, (many.next_up(), many)),
        // The worst is that which is nearest to its own bound.
        ([40e-16, 50e-16], Pass, (40e-16, few)),
        ([40e-16, 600e-16], Pass, (600e-16, many)),
    ] {
        let mut made = Made::new("kovalevskaya", &[Claim::VerticalMomentum]);
        for (rung, (steps, change)) in
            made.evidence.ladder.rungs.iter_mut().zip([100, 10_000].into_iter().zip(changes))
        {
            (rung.steps, rung.vertical_momentum) = (steps, Some(change));
        }
        let found = made.verdict(VerticalMomentum, "vertical-momentum");
        assert_eq!(found.verdict, expected, "{changes:?}");
        assert_eq!(numbers(&found), [Some(worst.0), Some(0.0), Some(worst.1)], "{changes:?}");
    }
}

#[test]
fn a_limit_of_stability_is_judged_with_its_bounds_where_one_is_on_record() {
    let stored = Stability::built_in().linear.iter().find(|row| row.h_omega.is_some()).expect("a limit");
    let known = stored.h_omega.expect("a limit");
    let judged = |limit: &LinearLimit| {
        let mut made = Made::new("free-asymmetric", &[]);
        (made.evidence.scene, made.evidence.scheme) = (stored.scene.clone(), stored.scheme.clone());
        made.evidence.step_limit = Some(limit.clone());
        let verdict = made.verdict(Stable, "step-limit");
        (verdict.verdict, numbers(&verdict))
    };
    let at = |h_omega: Option<f64>| judged(&LinearLimit { h_omega, ..stored.clone() });
    let bounds = |ruling: Ruling, now: f64| (ruling, [Some(now), Some(known * 0.98), Some(known * 1.02)]);
    assert_eq!(at(Some(known)), bounds(Pass, known));
    assert_eq!(at(Some(known * 1.03)), bounds(Fail, known * 1.03));
    assert_eq!(at(None), (Fail, [None; 3]));
    // There is no verdict without a measurement or without a record of the scheme.
    let mut made = Made::new("free-asymmetric", &[]);
    assert!(made.quantities(Stable).is_empty());
    made.evidence.step_limit = Some(stored.clone());
    assert!(made.quantities(Stable).is_empty());
}
