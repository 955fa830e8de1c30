//! Whether runs come to another motion than the truth.

use polhode::internals::measure::{APART, Reading};
use polhode::model::PerQuantity;
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::Verdict;
use polhode::schemes::{Claim, Quantity};

use super::case::{FLOOR, Made, broken, numbers, rung};

const SECOND: &[Claim] = &[Claim::Order(2)];

/// The verdict on runs of which each is known by its distance from the one before and its error.
fn consistency(runs: &[(f64, f64)]) -> Verdict {
    let mut made = Made::new("free-asymmetric", SECOND);
    made.not_for_order = Some("it is so");
    made.evidence.rungs =
        (0..).zip(runs).map(|(k, (moved, error))| rung(0.5f64.powi(k), 8 << k, *error, *moved)).collect();
    // It is the points of the body over the run that are looked at.
    for rung in &mut made.evidence.rungs {
        let max = rung.errors[Quantity::BodyPoint].max;
        rung.errors = PerQuantity::all(Reading { end: 7.0, max: 7.0 });
        rung.errors[Quantity::BodyPoint].max = max;
    }
    assert_eq!(made.ruling("order", "all"), NotApplicable);
    made.verdict("consistency", "body-point-max")
}

#[test]
fn runs_that_agree_with_one_another_and_not_with_the_truth_fail() {
    let floor = 10.0 * FLOOR;
    for (runs, expected) in [
        (&[(f64::NAN, 1.0), (0.0, floor)] as &[_], Pass),
        (&[(f64::NAN, 1.0), (0.0, floor.next_up())], Inconclusive),
        (&[(0.5, 1.0), (APART, 1.0)], Pass),
        (&[(0.5, 1.0), (APART.next_down(), 1.0)], Inconclusive),
        (&[(0.09, 1.0), (0.05, 1.0)], Fail),
        (&[(APART / 2.0, 1.0), (0.05, 1.0)], Inconclusive),
        (&[(0.05, 1.0), (0.05, 1.0)], Inconclusive),
        (&[(0.05, 1.0), (0.09, 1.0)], Inconclusive),
        (&[(0.15, 2.0), (APART / 2.0, 1.0)], Inconclusive),
        // The run before is compared with its own error.
        (&[(0.15, 2.0), (0.09, 1.0)], Fail),
        (&[(0.15, 0.5), (0.09, 1.0)], Inconclusive),
    ] {
        let verdict = consistency(runs);
        assert_eq!(verdict.verdict, expected, "{runs:?}: {}", verdict.detail);
    }
    let verdict = consistency(&[(0.09, 1.0), (0.05, 0.5)]);
    assert_eq!(numbers(&verdict), [Some(0.1), Some(APART), None]);
    assert_eq!(numbers(&consistency(&[(f64::NAN, 1.0), (0.5, floor)]))[0], Some(1.0));
    let alone = consistency(&[(f64::NAN, 1.0)]);
    assert!(
        alone.verdict == Inconclusive
            && alone.measured.is_none()
            && alone.detail.contains("no run before it")
    );
}

#[test]
fn a_run_that_broke_is_no_run_to_compare_with() {
    let mut made = Made::new("free-asymmetric", SECOND);
    made.not_for_order = Some("it is so");
    made.evidence.rungs =
        vec![rung(1.0, 8, 1.0, 0.09), rung(0.5, 16, 1.0, 0.05), broken(rung(0.25, 32, f64::NAN, f64::NAN))];
    let verdict = made.verdict("consistency", "body-point-max");
    assert!(verdict.verdict == Fail && verdict.detail.contains("h = 5.000e-1 s"), "{verdict:?}");
    made.evidence.rungs = made.evidence.rungs.into_iter().map(broken).collect();
    assert!(made.quantities("consistency").is_empty());
}
