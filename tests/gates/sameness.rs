//! Gates that ask whether two runs are the same: there and back, other worlds, mass points, the two-form, the limit on record.

use polhode::internals::measure::{self, OtherWorld, PointRun, Reading, Reversal, Symplecticity};
use polhode::record::Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::stability::LinearLimit;
use polhode::schemes::{Claim, Quantity};
use polhode::simulate::Outcome;

use super::case::{Made, numbers};

/// Times its floor that a difference may be.
const CLEAR: f64 = 10.0;

/// What a hundred solves to 1e-12 leave after 25 steps, over the roundings of 25 steps, √25 u.
fn left_by_solves() -> f64 {
    100.0 * 1e-12 / f64::EPSILON / 5.0
}

fn reversal(of_floor: f64, solves: u64) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Reversible]);
    let quantity = Quantity::Orientation;
    made.reversal =
        Some(Reversal { steps: 25, step: 0.5, of_floor, quantity, distance: 1e-15, solves, open: 0.0 });
    made
}

#[test]
fn there_and_back_may_differ_by_ten_floors_and_by_what_solves_leave_is_undecided() {
    let ruling = |of_floor, solves| reversal(of_floor, solves).ruling("reversible", "there-and-back");
    assert_eq!([ruling(0.0, 0), ruling(CLEAR, 0), ruling(CLEAR, 100)], [Pass; 3]);
    assert_eq!([ruling(CLEAR.next_up(), 0), ruling(CLEAR.next_up(), 100)], [Fail, Inconclusive]);
    let most = CLEAR * left_by_solves();
    assert_eq!([ruling(most, 100), ruling(most * 1.001, 100)], [Inconclusive, Fail]);
    assert_eq!(ruling(f64::NAN, 100), Broken);
    // Where roundings turn the body by an angle that can be seen, nobody can tell where it returns to.
    let open = |open: f64| {
        let mut made = reversal(3.0, 0);
        made.reversal.as_mut().expect("a reversal").open = open;
        made.ruling("reversible", "there-and-back")
    };
    assert_eq!([open(1e-3), open(1.1e-3)], [Pass, Inconclusive]);
    let verdict = reversal(3.0, 0).verdict("reversible", "there-and-back");
    assert_eq!(numbers(&verdict), [Some(3.0), Some(0.0), Some(CLEAR)]);
    assert_eq!(
        Made::new("free-asymmetric", &[Claim::Reversible]).quantities("reversible"),
        ["there-and-back"]
    );
    let silent = Made::new("free-asymmetric", &[Claim::Reversible]);
    assert_eq!(silent.ruling("reversible", "there-and-back"), NotApplicable);
}

#[test]
fn an_undecided_way_back_names_the_solves_and_a_decided_one_does_not() {
    let detail = |of_floor, solves| reversal(of_floor, solves).verdict("reversible", "there-and-back").detail;
    assert!(detail(CLEAR * 2.0, 100).contains("100 solves to 1e-12"));
    assert!(!detail(CLEAR * 2.0, 0).contains("solves") && !detail(1.0, 100).contains("solves"));
}

fn world(to_the_bit: bool, of_floor: f64, solves: u64) -> Made {
    let mut made = Made::new("free-asymmetric", &[Claim::Equivariant]);
    let (name, quantity, difference) = ("turned", Quantity::Position, 1e-15);
    made.other_worlds =
        vec![OtherWorld { name, to_the_bit, of_floor, quantity, difference, steps: 25, solves }];
    made
}

#[test]
fn another_world_may_differ_by_ten_floors_and_in_binary_units_by_nothing() {
    let ruling = |bit, of_floor, solves| world(bit, of_floor, solves).ruling("equivariant", "turned");
    assert_eq!([ruling(false, CLEAR, 0), ruling(true, 0.0, 0)], [Pass; 2]);
    assert_eq!([ruling(false, CLEAR.next_up(), 0), ruling(true, 1e-300, 0)], [Fail; 2]);
    // Solves are no excuse where every bit must be the same.
    assert_eq!([ruling(false, CLEAR.next_up(), 100), ruling(true, 1e-300, 100)], [Inconclusive, Fail]);
    let most = CLEAR * left_by_solves();
    assert_eq!([ruling(false, most, 100), ruling(false, most * 1.001, 100)], [Inconclusive, Fail]);
    assert_eq!([ruling(false, f64::NAN, 100), ruling(true, f64::NAN, 0)], [Fail; 2]);
    assert_eq!(
        Made::new("free-asymmetric", &[Claim::Equivariant]).ruling("equivariant", "all"),
        NotApplicable
    );
}

#[test]
fn what_differs_in_another_world_is_said_with_its_numbers() {
    let verdict = |bit, of_floor| world(bit, of_floor, 0).verdict("equivariant", "turned");
    assert_eq!(numbers(&verdict(false, 3.0)), [Some(3.0), Some(0.0), Some(CLEAR)]);
    assert_eq!(numbers(&verdict(true, f64::NAN)), [None, Some(0.0), Some(0.0)]);
    assert!(verdict(false, 3.0).detail.contains("3.00 of its floor"));
    assert!(verdict(true, 0.0).detail.contains("to the last bit"));
    assert!(verdict(false, f64::NAN).detail.contains("breaks in the other world"));
}

fn points(change: impl FnOnce(&mut PointRun)) -> Option<PointRun> {
    let mut points = PointRun {
        step: 0.5,
        steps: 10_000,
        difference: 0.0,
        stretch: 0.0,
        momentum_change: None,
        torque_rounding: 0.0,
        rounding: 0.0,
        outcome: Outcome::none_yet(),
    };
    change(&mut points);
    Some(points)
}

#[test]
fn points_may_stretch_by_the_rounding_of_their_turns_and_in_a_steady_spin_by_that_of_each() {
    // 4 √n + 8 roundings where the axis tumbles, n more where it stands still.
    for (scene, bound) in
        [("free-asymmetric", 408.0 * f64::EPSILON), ("slow-sphere", 10_408.0 * f64::EPSILON)]
    {
        let at = |stretch: f64| {
            let mut made = Made::new(scene, &[Claim::Rigid]);
            made.points = points(|points| points.stretch = stretch);
            made.verdict("rigid", "rigidity")
        };
        assert_eq!([at(0.0).verdict, at(bound).verdict], [Pass; 2], "{scene}");
        assert_eq!([at(bound.next_up()).verdict, at(f64::NAN).verdict], [Fail; 2], "{scene}");
        assert_eq!(numbers(&at(1e-15)), [Some(1e-15), Some(0.0), Some(bound)], "{scene}");
        assert_eq!(numbers(&at(f64::NAN))[0], None);
    }
    assert_eq!(Made::new("slow-sphere", &[Claim::Rigid]).ruling("rigid", "rigidity"), NotApplicable);
}

#[test]
fn the_least_model_may_differ_from_the_points_by_their_roundings() {
    let at = |difference: f64, rounding: f64, torque_rounding: f64| {
        let mut made = Made::new("free-asymmetric", &[]);
        made.points = points(|points| {
            (points.difference, points.rounding, points.torque_rounding) =
                (difference, rounding, torque_rounding);
        });
        made.ruling("reduction", "all")
    };
    // 1e-12, ten of the roundings that were measured, three of those of the torque.
    for (rounding, torque, bound) in [(0.0, 0.0, 1e-12), (1e-12, 0.0, 11e-12), (0.0, 1e-12, 4e-12)] {
        assert_eq!([at(bound * 0.999, rounding, torque), at(bound * 1.001, rounding, torque)], [Pass, Fail]);
    }
    assert_eq!(
        [at(0.9e-12, 0.0, f64::NAN), at(1.1e-12, 0.0, f64::NAN), at(f64::NAN, 0.0, 0.0)],
        [Pass, Fail, Fail]
    );
}

#[test]
fn nothing_is_reduced_where_there_are_only_points_or_none() {
    let mut made = Made::new("free-asymmetric", &[]);
    assert_eq!(made.ruling("reduction", "all"), NotApplicable);
    made.points = points(|points| points.difference = 1.0);
    assert_eq!(made.ruling("reduction", "all"), Fail);
    made.evidence.model = "points";
    assert_eq!(made.ruling("reduction", "all"), NotApplicable);
}

#[test]
fn a_step_may_change_the_two_form_by_1e_minus_9_over_the_unit_of_its_directions() {
    let at = |defect: f64, unit: f64| {
        let mut made = Made::new("free-asymmetric", &[Claim::Symplectic]);
        made.symplecticity = Some(Symplecticity { step: 0.5, defect, unit });
        made.ruling("symplectic", "two-form")
    };
    assert_eq!([at(0.0, 1.0), at(1e-9, 1.0), at(2e-9, 0.5)], [Pass; 3]);
    assert_eq!([at(1e-9f64.next_up(), 1.0), at(2.1e-9, 0.5), at(f64::NAN, 1.0)], [Fail; 3]);
    assert_eq!(
        Made::new("free-asymmetric", &[Claim::Symplectic]).ruling("symplectic", "two-form"),
        NotApplicable
    );
}

#[test]
fn the_vertical_momentum_may_change_by_the_rounding_of_its_sums_on_every_rung() {
    let place = measure::ALL.iter().position(|metric| metric.name == "vertical-momentum").expect("a metric");
    // 4 √n + 8 roundings after n steps.
    let bound = |steps: f64| f64::EPSILON * (8.0 + 4.0 * steps.sqrt());
    let at = |changes: [f64; 2]| {
        let mut made = Made::new("kovalevskaya", &[Claim::VerticalMomentum]);
        for (rung, (steps, max)) in made.evidence.rungs.iter_mut().zip([100, 10_000].into_iter().zip(changes))
        {
            rung.steps = steps;
            rung.readings[place] = Some(Reading { end: 0.0, max });
        }
        made.verdict("vertical-momentum", "vertical-momentum")
    };
    assert_eq!([at([bound(100.0), 0.0]).verdict, at([0.0, bound(10_000.0)]).verdict], [Pass; 2]);
    assert_eq!(
        [at([bound(100.0).next_up(), 0.0]).verdict, at([0.0, bound(10_000.0).next_up()]).verdict],
        [Fail; 2]
    );
    // The worst is that which is nearest to its own bound.
    assert_eq!(numbers(&at([40e-16, 50e-16])), [Some(40e-16), Some(0.0), Some(bound(100.0))]);
    assert_eq!(numbers(&at([40e-16, 600e-16])), [Some(600e-16), Some(0.0), Some(bound(10_000.0))]);
    let silent = Made::new("kovalevskaya", &[Claim::VerticalMomentum]);
    assert_eq!(silent.ruling("vertical-momentum", "vertical-momentum"), NotApplicable);
}

#[test]
fn a_limit_of_stability_is_judged_with_its_bounds() {
    let limit = |h_omega| LinearLimit { h_omega, failure: "grows".to_owned(), ..LinearLimit::default() };
    let at = |stored, measured| {
        let mut made = Made::new("free-asymmetric", &[]);
        made.step_limit = Some((limit(stored), limit(measured)));
        made.verdict("stability", "step-limit")
    };
    let met = at(Some(2.0), Some(2.0));
    assert_eq!((met.verdict, numbers(&met)), (Pass, [Some(2.0), Some(2.0 * 0.98), Some(2.0 * 1.02)]));
    assert!(met.detail.contains("2.0000 on record"));
    let gone = at(Some(2.0), None);
    assert_eq!((gone.verdict, numbers(&gone)), (Fail, [None; 3]));
    assert!(gone.detail.contains("none (grows)") && gone.detail.contains("h·ω = 2.0000"), "{}", gone.detail);
    assert!(Made::new("free-asymmetric", &[]).quantities("stability").is_empty());
}
