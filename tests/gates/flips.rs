//! Flips of a tumbling body.

use polhode::internals::measure::{FlipRung, Flips, TrueFlips};
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};
use polhode::schemes::{Claim, Quantity};

use super::case::{Made, numbers};

/// Two flips in truth, and times on rungs that are late by these errors.
fn late(errors: &[f64]) -> Made {
    let mut made = Made::new("dzhanibekov", &[Claim::Order(2), Claim::FlipTimes]);
    let truth = TrueFlips { times: vec![10.0, 29.0], uncertainty: 0.0, slowest: 0.5 };
    // The first flip is late and the second early.
    let times = |error: &f64| vec![10.0 + 0.5 * error, 29.0 - error];
    let rung = |(k, e): (i32, &f64)| FlipRung { step: 0.5f64.powi(k), times: times(e), uncertainty: 0.0 };
    let rungs = (0..).zip(errors).map(rung).collect();
    made.flips = Some(Flips { truth, rungs });
    made
}

fn flips(made: &mut Made) -> &mut Flips {
    made.flips.as_mut().expect("flips")
}

/// Errors h^order at halved steps.
fn power(order: i32) -> [f64; 8] {
    std::array::from_fn(|k| 0.125 * 0.5f64.powi(order * k as i32))
}

#[test]
fn times_of_flips_converge_at_least_as_fast_as_claimed() {
    let ruling = |errors: &[f64]| late(errors).ruling("flip-times", "flip-times");
    assert_eq!([ruling(&power(2)), ruling(&power(3)), ruling(&power(1))], [Pass, Pass, Fail]);
    // 1.8 is below the band about two, and 1.9 in it.
    let slope = |slope: f64| -> [f64; 8] { std::array::from_fn(|k| 0.1 * 0.5f64.powf(slope * k as f64)) };
    assert_eq!([ruling(&slope(1.8)), ruling(&slope(1.9))], [Fail, Pass]);
    let verdict = late(&power(3)).verdict("flip-times", "flip-times");
    let [measured, low, high] = numbers(&verdict);
    assert!((measured.expect("a slope") - 3.0).abs() < 1e-9);
    assert!(low.zip(high).is_some_and(|(low, high)| 2.99 < low && high < 3.01), "{low:?} {high:?}");
    assert!(
        verdict.detail.starts_with("2 flips; largest error of a time 5.96e-8 s at h = 7.81e-3 s"),
        "{}",
        verdict.detail
    );
}

#[test]
fn slopes_that_do_not_agree_decide_only_where_all_of_the_last_three_are_steep_enough() {
    let ruling = |errors: &[f64]| late(errors).ruling("flip-times", "flip-times");
    // Slopes 3.3, 2.3, 3.3 and 2.3; then 3.3, 2.3, 3.3 and 1.
    assert_eq!(ruling(&[1.0, 0.1, 0.02, 2e-3, 4e-4]), Pass);
    assert_eq!(ruling(&[1.0, 0.1, 0.02, 2e-3, 1e-3]), Inconclusive);
    // They have stopped to fall, off the truth.
    assert_eq!(ruling(&[4.0, 1.0, 1e-3, 1e-3, 1e-3, 1e-3]), Fail);
}

#[test]
fn times_at_their_floor_are_right_whatever_their_slopes() {
    let errors = [1.0, 0.1, 0.02, 2e-3, 1e-3];
    for (floor, expected) in [(0.99e-4, Inconclusive), (1.01e-4, Pass)] {
        let mut made = late(&errors);
        flips(&mut made).rungs.iter_mut().for_each(|rung| rung.uncertainty = floor);
        assert_eq!(made.ruling("flip-times", "flip-times"), expected, "{floor}");
        // What the truth is off by counts as well, and so does an angle over the rate of the slowest flip.
        let mut made = late(&errors);
        flips(&mut made).truth.uncertainty = floor;
        assert_eq!(made.ruling("flip-times", "flip-times"), expected, "{floor}");
        let mut made = late(&errors);
        let orientation = Quantity::Orientation;
        made.evidence.rungs[5].floors[orientation].max = 0.5 * floor;
        assert_eq!(made.ruling("flip-times", "flip-times"), expected, "{floor}");
    }
}

#[test]
fn flips_are_as_many_as_in_truth_at_the_three_finest_steps() {
    // Fewer than four rungs after the last wrong one have no window.
    for (rung, expected) in [(7, Fail), (6, Fail), (5, Fail), (4, Inconclusive), (3, Pass), (0, Pass)] {
        let mut made = late(&power(2));
        flips(&mut made).rungs[rung].times.pop();
        assert_eq!(made.ruling("flip-times", "flip-times"), expected, "{rung}");
    }
    let mut made = late(&power(2));
    flips(&mut made).truth.times.clear();
    assert_eq!(made.ruling("flip-times", "flip-times"), Fail);
    flips(&mut made).rungs.iter_mut().for_each(|rung| rung.times.clear());
    assert_eq!(made.ruling("flip-times", "flip-times"), Pass);
}

#[test]
fn flips_that_are_not_known_are_not_judged() {
    let mut made = late(&power(1));
    // So fast that an angle is no time.
    flips(&mut made).truth.slowest = f64::INFINITY;
    let orientation = Quantity::Orientation;
    made.evidence.rungs[5].floors[orientation].max = 1e-3;
    assert_eq!(made.ruling("flip-times", "flip-times"), Fail);
    made.evidence.rungs[5].floors[orientation].max = 1e-3f64.next_up();
    assert_eq!(made.ruling("flip-times", "flip-times"), Inconclusive);
    made.flips = None;
    assert_eq!(made.ruling("flip-times", "flip-times"), NotApplicable);
}
