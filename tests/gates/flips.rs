//! Flips of a tumbling body.

use polhode::claim::{Claim, Quantity};
use polhode::metrics::{FlipRung, Flips};
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};

use super::case::{Made, index, numbers};

/// Two flips in truth, and times on five rungs that are late by these errors.
fn late(errors: &[f64]) -> Made {
    let mut made = Made::new("dzhanibekov", &[Claim::Order(2), Claim::FlipTimes]);
    let truth = vec![10.0, 29.0];
    // The first flip is late and the second early.
    let times = |error: &f64| vec![10.0 + 0.5 * error, 29.0 - error];
    let rungs = (0..).zip(errors).map(|(k, e)| FlipRung { step: 0.5f64.powi(k), times: times(e) }).collect();
    made.flips = Some(Flips { truth, rungs });
    made
}

fn flips(made: &mut Made) -> &mut Flips {
    made.flips.as_mut().expect("flips")
}

/// Errors h^order at halved steps.
fn power(order: i32) -> [f64; 5] {
    std::array::from_fn(|k| 0.125 * 0.5f64.powi(order * k as i32))
}

#[test]
fn times_of_flips_converge_at_least_as_fast_as_claimed() {
    let ruling = |errors: &[f64]| late(errors).ruling("flip-times", "flip-times");
    assert_eq!([ruling(&power(2)), ruling(&power(3)), ruling(&power(1))], [Pass, Pass, Fail]);
    // 1.8 is below the band about two, and 1.9 in it.
    let slope = |slope: f64| [0, 1, 2, 3, 4].map(|k| 0.1 * 0.5f64.powf(slope * f64::from(k)));
    assert_eq!([ruling(&slope(1.8)), ruling(&slope(1.9))], [Fail, Pass]);
    let verdict = late(&power(3)).verdict("flip-times", "flip-times");
    let [measured, low, high] = numbers(&verdict);
    assert!((measured.expect("a slope") - 3.0).abs() < 1e-9 && low == Some(1.85) && high.is_none());
    assert!(
        verdict.detail.starts_with("2 flips; largest error of a time 3.05e-5 s at h = 6.25e-2 s"),
        "{}",
        verdict.detail
    );
}

#[test]
fn the_three_finest_runs_alone_are_judged() {
    let ruling = |errors: &[f64]| late(errors).ruling("flip-times", "flip-times");
    assert_eq!(ruling(&[1e-9, 1e-9, 1e-2, 2.5e-3, 6.25e-4]), Pass);
    assert_eq!(ruling(&[4.0, 1.0, 1e-3, 1e-3, 1e-3]), Fail);
    // An error that is zero has no slope.
    assert_eq!(ruling(&[1e-1, 1e-2, 1e-3, 1e-4, 0.0]), Inconclusive);
}

#[test]
fn flips_are_as_many_as_in_truth_at_the_three_finest_steps() {
    for (rung, expected) in [(4, Fail), (3, Fail), (2, Fail), (1, Pass), (0, Pass)] {
        let mut made = late(&power(2));
        flips(&mut made).rungs[rung].times.pop();
        assert_eq!(made.ruling("flip-times", "flip-times"), expected, "{rung}");
    }
    let mut made = late(&power(2));
    flips(&mut made).truth.clear();
    assert_eq!(made.ruling("flip-times", "flip-times"), Fail);
    flips(&mut made).rungs.iter_mut().for_each(|rung| rung.times.clear());
    assert_eq!(made.ruling("flip-times", "flip-times"), Pass);
}

#[test]
fn flips_that_are_not_known_are_not_judged() {
    let mut made = late(&power(1));
    let orientation = index(Quantity::Orientation);
    made.evidence.rungs[5].floors[orientation].max = 1e-3;
    assert_eq!(made.ruling("flip-times", "flip-times"), Fail);
    made.evidence.rungs[5].floors[orientation].max = 1e-3f64.next_up();
    assert_eq!(made.ruling("flip-times", "flip-times"), Inconclusive);
    made.flips = None;
    assert_eq!(made.ruling("flip-times", "flip-times"), NotApplicable);
}
