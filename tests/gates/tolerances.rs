//! Solvers that choose their own steps.

use polhode::record::Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::schemes::{Claim, Quantity};

use super::case::{FLOOR, Made, broken, numbers};

/// The step of a plan stands for a tolerance h².
const FOLLOWS: &[Claim] = &[Claim::FollowsTolerance(2)];

/// Errors at halved steps and one floor; the work doubles each time.
fn solver(errors: &[f64], floor: f64) -> Made {
    let mut made = Made::new("free-asymmetric", FOLLOWS).with_errors(Quantity::Orientation, errors, floor);
    for (k, rung) in made.evidence.rungs.iter_mut().enumerate() {
        rung.outcome.evaluations = 100 << k;
    }
    made
}

/// A hundredth of the tolerance to a power, twice as large and half as large by this in turn.
fn power(slope: f64, scatter: f64) -> [f64; 6] {
    std::array::from_fn(|k| {
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        0.01 * 0.25f64.powf(slope * k as f64) * 2f64.powf(sign * scatter)
    })
}

#[test]
fn an_error_follows_the_tolerance_to_a_power_between_a_half_and_three_halves() {
    let at = |slope, scatter| {
        solver(&power(slope, scatter), FLOOR).verdict("follows-tolerance", "orientation-end")
    };
    assert_eq!([at(0.51, 0.0), at(1.0, 0.0), at(1.49, 0.0), at(1.0, 1.0)].map(|v| v.verdict), [Pass; 4]);
    assert_eq!([at(0.49, 0.0), at(1.51, 0.0), at(-0.1, 0.0)].map(|v| v.verdict), [Fail; 3]);
    // The interval reaches into the band.
    assert_eq!([at(0.4, 1.0), at(1.6, 1.0)].map(|v| v.verdict), [Inconclusive; 2]);
    assert!(at(0.4, 1.0).detail.contains("scatter") && !at(0.51, 1.0).detail.contains("scatter"));
    let [slope, low, high] = numbers(&at(1.0, 1.0)).map(|number| number.expect("a fit"));
    assert!(low < slope && slope < high && (slope - 1.0).abs() < 0.2, "{slope} [{low}, {high}]");
    assert!(at(1.0, 0.0).detail.contains("over 6 tolerances"));
}

#[test]
fn fewer_than_four_tolerances_that_rule_the_error_decide_nothing() {
    let mut errors = power(1.0, 0.0);
    // At the floor; then as large as the motion.
    errors[5] = FLOOR;
    errors[0] = 100.0;
    let at = |errors: &[f64]| solver(errors, FLOOR).verdict("follows-tolerance", "orientation-end");
    assert_eq!(at(&errors).verdict, Pass);
    errors[1] = 100.0;
    let verdict = at(&errors);
    assert_eq!((verdict.verdict, numbers(&verdict)), (Inconclusive, [None; 3]));
    assert!(verdict.detail.starts_with("3 of 6 tolerances"), "{}", verdict.detail);
    assert!(verdict.detail.contains("motion (2)") && verdict.detail.contains("floor of 1.0e-15 (1)"));
}

#[test]
fn errors_at_the_floor_at_every_tolerance_leave_nothing_to_follow() {
    let ruling = |error: f64| solver(&[error; 6], FLOOR).ruling("follows-tolerance", "orientation-end");
    assert_eq!(
        [ruling(0.0), ruling(10.0 * FLOOR), ruling((10.0 * FLOOR).next_up())],
        [NotApplicable, NotApplicable, Fail]
    );
}

#[test]
fn a_solver_that_broke_at_the_finest_tolerance_or_never_ran_does_not_pass() {
    let mut errors = power(1.0, 0.0);
    errors[5] = f64::NAN;
    let mut made = solver(&errors, FLOOR);
    let verdict = made.verdict("follows-tolerance", "orientation-end");
    assert!(verdict.verdict == Broken && verdict.detail == "no finite error", "{verdict:?}");
    made.evidence.rungs[5] = broken(made.evidence.rungs[5].clone());
    assert!(made.verdict("follows-tolerance", "orientation-end").detail.contains("no longer finite"));
    assert_eq!(solver(&[], FLOOR).ruling("follows-tolerance", "orientation-end"), Inconclusive);
}
