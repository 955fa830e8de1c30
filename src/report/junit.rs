//! The verdicts as JUnit XML, which build servers read: a suite a scene, a case a verdict.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use crate::record::{Records, Verdict};

use super::survey::{self, Outcome};

/// The verdicts as JUnit XML.
///
/// A failed claim is a `failure` and a broken run an `error`. JUnit has no word for the rest: what is
/// inconclusive, not applicable or a known deviation is `skipped`, and the message says which.
pub fn junit(records: &Records) -> String {
    let mut report = Report::new("polhode");
    for scene in survey::scenes(records) {
        let mut suite = TestSuite::new(scene);
        for verdict in records.verdicts.iter().filter(|verdict| verdict.scene == scene) {
            suite.add_test_case(case(verdict));
        }
        report.add_test_suite(suite);
    }
    report.to_string().expect("XML into memory cannot fail")
}

fn case(verdict: &Verdict) -> TestCase {
    let parts = [verdict.scheme.as_str(), verdict.claim.word(), verdict.quantity.as_str()];
    let named: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    let mut case = TestCase::new(named.join(": "), status(verdict));
    case.set_classname(verdict.scene.as_str());
    case
}

/// All that a verdict holds, a line each.
fn body(verdict: &Verdict) -> String {
    let number = |name: &str, value: Option<f64>| value.map(|value| format!("{name}: {value:e}\n"));
    let numbers =
        [number("measured", verdict.measured), number("low", verdict.low), number("high", verdict.high)];
    let numbers: String = numbers.into_iter().flatten().collect();
    format!(
        "scene: {}\nscheme: {}\nrule: {}, {}\nquantity: {}\n{numbers}{}\n",
        verdict.scene,
        verdict.scheme,
        verdict.claim,
        verdict.claim.explained(),
        verdict.quantity,
        verdict.detail
    )
}

fn status(verdict: &Verdict) -> TestCaseStatus {
    let detail = verdict.detail.as_str();
    let skipped = |message: String| {
        let mut status = TestCaseStatus::skipped();
        status.set_message(message);
        status
    };
    let unsuccessful = |kind, word: &str| {
        let mut status = TestCaseStatus::non_success(kind);
        status.set_message(detail).set_type(word).set_description(body(verdict));
        status
    };
    match Outcome::of(verdict) {
        Outcome::Pass => TestCaseStatus::success(),
        Outcome::Fail => unsuccessful(NonSuccessKind::Failure, "fail"),
        Outcome::Broken => unsuccessful(NonSuccessKind::Error, "broken"),
        Outcome::Inconclusive => skipped(format!("inconclusive: {detail}")),
        Outcome::NotApplicable => skipped(format!("not applicable: {detail}")),
        Outcome::KnownDeviation => {
            let reason = verdict.known_deviation.as_deref().unwrap_or_default();
            skipped(format!("known deviation: {reason} ({detail})"))
        }
    }
}
