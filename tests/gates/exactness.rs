//! What is promised to be exact.

use polhode::record::ClaimName::Exact;
use polhode::record::Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{Ladder, PointRun, Ruling};
use polhode::schemes::{Claim, Quantity, When};

use super::case::{FLOOR, Made, ROUNDING, RUNS, numbers, power};

const TURNS: &[Claim] = &[Claim::Exact(Quantity::Orientation, When::SteadySpin)];

#[test]
fn every_promise_speaks_of_its_own_scenes_and_of_no_other() {
    let speaks = |when: When, scene: &str| {
        let made = Made::new(scene, &[Claim::Exact(Quantity::Velocity, when)]);
        made.ruling(Exact, "velocity") != NotApplicable
    };
    // Free; falling under springs; on a pivot; a sphere; two equal moments; a symmetric top under torque.
    let scenes = [
        "free-asymmetric",
        "tether-springs",
        "heavy-asymmetric-top",
        "slow-sphere",
        "free-oblate",
        "lagrange-fast-top",
    ];
    for (when, expected) in [
        (When::NoForce, [true, false, false, true, true, false]),
        (When::ConstantForce, [true, false, false, true, true, false]),
        (When::NoTorque, [true, false, false, true, true, false]),
        (When::SteadySpin, [false, false, false, true, false, false]),
        (When::SymmetricBody, [false, false, false, true, true, false]),
    ] {
        assert_eq!(scenes.map(|scene| speaks(when, scene)), expected, "{when}");
    }
}

/// A turn in a steady spin with these errors.
fn turn(errors: &[f64], rounding: f64) -> Made {
    Made::new("slow-sphere", TURNS).with_errors(Quantity::Orientation, errors, rounding)
}

#[test]
fn every_error_is_at_its_rounding() {
    let one = |run: usize, error: f64| std::array::from_fn(|k| if k == run { error } else { 0.0 });
    for (errors, expected) in [
        ([0.0; RUNS], Pass),
        ([FLOOR; RUNS], Pass),
        (one(0, FLOOR.next_up()), Pass),
        (one(0, 1.01 * FLOOR), Fail),
        (one(RUNS - 1, 1.01 * FLOOR), Fail),
        (power(2.0), Fail),
        ([0.25; RUNS], Fail),
    ] {
        // The next number above a bound is lost in the length of four of them.
        let expected = if errors[0] == FLOOR.next_up() { Fail } else { expected };
        assert_eq!(turn(&errors, ROUNDING).ruling(Exact, "orientation"), expected, "{errors:?}");
    }
    // Lengths are over four times: twice those of one.
    let verdict = turn(&one(3, 2.0 * FLOOR), ROUNDING).verdict(Exact, "orientation");
    assert_eq!(numbers(&verdict), [Some(4.0 * FLOOR), Some(0.0), Some(2.0 * FLOOR)]);
}

#[test]
fn the_worst_run_is_that_which_is_farthest_above_its_own_rounding() {
    let mut made = turn(&[ROUNDING; RUNS], ROUNDING);
    let rungs = &mut made.evidence.ladder.rungs;
    // Larger by itself, and far below what its copies leave.
    rungs[2].errors[Quantity::Orientation].fill(1e-9);
    rungs[2].rounding[Quantity::Orientation].fill(1e-9);
    rungs[4].errors[Quantity::Orientation][0] = 3.0 * FLOOR;
    let verdict = made.verdict(Exact, "orientation");
    assert_eq!((verdict.verdict, verdict.high), (Fail, Some(2.0 * FLOOR)));
    // The verdict is broken only where every run broke.
    made = made.broken(4);
    assert_eq!(made.ruling(Exact, "orientation"), Pass);
    for run in 0..RUNS {
        made = made.broken(run);
    }
    assert_eq!(made.ruling(Exact, "orientation"), Broken);
}

#[test]
fn each_verdict_is_on_its_own_quantity() {
    let made = turn(&[0.0; RUNS], ROUNDING).with_errors(Quantity::Velocity, &[1.0; RUNS], ROUNDING);
    assert_eq!(made.quantities(Exact), ["orientation"]);
    assert_eq!(made.ruling(Exact, "orientation"), Pass);
}

#[test]
fn nothing_is_called_exact_where_rounding_leaves_a_tenth_of_the_quantity_open() {
    // Thirty times the distance of the copies.
    for (rounding, error, expected) in
        [(0.0033, 0.0, Pass), (0.0034, 0.0, Inconclusive), (0.0034, 0.1, Inconclusive), (0.0034, 0.11, Fail)]
    {
        assert_eq!(
            turn(&[error; RUNS], rounding).ruling(Exact, "orientation"),
            expected,
            "{rounding} {error}"
        );
    }
}

#[test]
fn what_is_known_of_truth_and_digits_is_no_error() {
    // Each is a bound: r is to resolve a tenth of what is more than that.
    for (printed, uncertainty) in [(1e-6, 0.0), (0.0, 1e-6)] {
        let at = |error: f64| {
            let mut made = turn(&[error; RUNS], ROUNDING);
            made.evidence.ladder.printed = printed;
            made.evidence.ladder.uncertainty[Quantity::Orientation] = uncertainty;
            made.ruling(Exact, "orientation")
        };
        assert_eq!([at(0.999e-5), at(1.001e-5)], [Pass, Fail]);
    }
}

#[test]
fn the_momentum_of_the_points_may_change_by_the_rounding_of_its_sums() {
    let at = |quantity: Quantity, momentum_change: Option<f64>, torque_rounding: f64| {
        let mut made = Made::new("free-asymmetric", &[Claim::Exact(quantity, When::NoTorque)]);
        let steps = 10_000;
        made.evidence.points = Some(PointRun {
            steps,
            momentum_change,
            torque_rounding,
            unit: f64::EPSILON,
            ..PointRun::default()
        });
        made
    };
    let ruling = |change, torque| -> Ruling {
        at(Quantity::AngularMomentum, Some(change), torque).ruling(Exact, "angular-momentum-points")
    };
    // 4 √n + 8 roundings, and those of the torque.
    let bound = 408.0 * f64::EPSILON;
    assert_eq!([ruling(bound, 0.0), ruling(bound.next_up(), 0.0), ruling(f64::NAN, 0.0)], [Pass, Fail, Fail]);
    assert_eq!([ruling(bound + 0.99e-12, 1e-12), ruling(bound + 1.01e-12, 1e-12)], [Pass, Fail]);
    assert_eq!(at(Quantity::AngularMomentum, None, 0.0).quantities(Exact), ["angular-momentum"]);
    assert_eq!(at(Quantity::Velocity, Some(1.0), 0.0).quantities(Exact), ["velocity"]);
}

#[test]
fn what_is_exact_in_double_double_is_at_its_rounding_in_f64_too() {
    let one = |error: f64| std::array::from_fn::<f64, RUNS, _>(|run| if run == 3 { error } else { 0.0 });
    let [rounds, off] = [0.5, 2.0].map(|of_floor| turn(&one(of_floor * FLOOR), ROUNDING));
    let second = turn(&power(2.0), ROUNDING);
    for (error, of_rounding) in [(0.0, Pass), (1e-29, Pass), (1e-20, Fail)] {
        let finer = turn(&one(error), 1e-30).evidence.ladder;
        for (made, expected) in [(&rounds, of_rounding), (&off, Fail), (&second, Fail)] {
            let mut made = made.clone();
            made.evidence.exactness = Some(Ladder { double_double: true, ..finer.clone() });
            assert_eq!(made.ruling(Exact, "orientation"), expected, "{error}");
        }
    }
    // Where f64 leaves more than a tenth of the quantity open, double-double decides.
    let mut made = turn(&one(0.0), 1.0);
    assert_eq!(made.ruling(Exact, "orientation"), Inconclusive);
    made.evidence.exactness = Some(Ladder { double_double: true, ..turn(&one(0.0), 1e-30).evidence.ladder });
    assert_eq!(made.ruling(Exact, "orientation"), Pass);
    // Of one run that came to its end nothing is decided: f64 decides.
    let mut made = turn(&[0.0; RUNS], ROUNDING);
    let mut finer = turn(&one(1e-20), 1e-30).evidence.ladder;
    finer.rungs = vec![finer.rungs[3].clone()];
    made.evidence.exactness = Some(Ladder { double_double: true, ..finer });
    assert_eq!(made.ruling(Exact, "orientation"), Pass);
}
