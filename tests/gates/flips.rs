//! Flips of a tumbling body.

use polhode::internals::measure::is_complete;
use polhode::record::ClaimName::FlipTimes;
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{FlipRung, Flips, TrueFlips};
use polhode::schemes::Claim;

use super::case::{Made, numbers, power, step};

/// Runs at halved steps.
const RUNS: usize = 8;

/// Four flips in truth within 50 s, and runs that are late by these errors; every second flip is early.
fn late(errors: &[f64]) -> Made {
    let mut made = Made::new("dzhanibekov", &[Claim::Order(2), Claim::FlipTimes]);
    let truth = TrueFlips { times: vec![10.0, 20.0, 30.0, 40.0], uncertainty: 0.0, slowest: 0.5 };
    let times = |error: &f64| vec![10.0 + 0.5 * error, 20.0 - 0.5 * error, 30.0 + error, 40.0 - error];
    let rung = |(run, error): (usize, &f64)| FlipRung {
        step: step(run),
        steps: 50 << run,
        times: times(error),
        uncertainty: 0.0,
        rounding: vec![0.0; 4],
    };
    let rungs = errors.iter().enumerate().map(rung).collect();
    made.evidence.flips = Some(Flips { truth, duration: 50.0, rungs });
    made
}

fn flips(made: &mut Made) -> &mut Flips {
    made.evidence.flips.as_mut().expect("flips")
}

fn ruling(made: &Made) -> polhode::record::Ruling {
    made.ruling(FlipTimes, "flip-times")
}

#[test]
fn times_of_flips_converge_at_least_as_fast_as_claimed() {
    let doubled: Vec<f64> = power(2.0).iter().zip([1.0, 2.0].repeat(4)).map(|(e, by)| e * by).collect();
    for (errors, expected) in [
        (&power(1.0)[..], Fail),
        (&power(2.0), Pass),
        (&power(3.0), Pass),
        (&[0.0; RUNS], Pass),
        // Off however small the step.
        (&[0.25; RUNS], Fail),
        (&doubled, Inconclusive),
        (&power(2.0)[..3], Inconclusive),
    ] {
        assert_eq!(ruling(&late(errors)), expected, "{errors:?}");
    }
    let shown = numbers(&late(&power(3.0)).verdict(FlipTimes, "flip-times"));
    // Times of up to 40 s are rounded to 7e-15 s, over errors of 1e-3 s or more.
    assert!(shown.iter().all(|number| number.is_some_and(|order| (order - 3.0).abs() < 1e-9)), "{shown:?}");
}

#[test]
fn times_at_what_they_may_be_off_by_are_right() {
    // Each counts ten times: what interpolation leaves open of a run and of the truth; a distance of copies counts thirty times.
    let off = 1e-3;
    let ways: [fn(&mut Made, f64); 3] = [
        |made, off| flips(made).rungs.iter_mut().for_each(|rung| rung.uncertainty = off),
        |made, off| flips(made).truth.uncertainty = off,
        |made, off| flips(made).rungs.iter_mut().for_each(|rung| rung.rounding.fill(off / 3.0)),
    ];
    for way in ways {
        // Of four errors two are whole and two are halves: their length is √(5/8) times that of four whole ones.
        let length = (5.0f64 / 8.0).sqrt();
        for (error, expected) in [(0.99, Pass), (1.01, Fail)] {
            let mut made = late(&[10.0 * off * error / length; RUNS]);
            way(&mut made, off);
            assert_eq!(ruling(&made), expected, "{error}");
        }
    }
}

#[test]
fn a_truth_that_may_have_another_number_of_flips_fails_no_count() {
    // The flips lie ten seconds apart, and the end as far from the last.
    for (uncertainty, end, expected) in [
        (0.99, 50.0, Fail),
        (1.01, 50.0, Inconclusive),
        (0.99, 49.0, Inconclusive),
        (f64::INFINITY, 50.0, Inconclusive),
    ] {
        let mut made = late(&power(2.0));
        flips(&mut made).truth.uncertainty = uncertainty;
        flips(&mut made).duration = end;
        flips(&mut made).rungs.iter_mut().for_each(|rung| rung.times.truncate(1));
        assert_eq!(ruling(&made), expected, "{uncertainty} s, {end} s");
    }
}

#[test]
fn flips_are_as_many_as_in_truth_at_the_three_finest_steps() {
    for run in 0..RUNS {
        let mut made = late(&power(2.0));
        flips(&mut made).rungs[run].times.remove(1);
        // Fewer than four runs after the last wrong one decide no order, and runs that differ do not say what the limit is.
        let expected = [Pass, Pass, Pass, Pass, Inconclusive, Inconclusive, Inconclusive, Inconclusive][run];
        assert_eq!(ruling(&made), expected, "{run}");
    }
    let mut made = late(&power(2.0));
    flips(&mut made).truth.times.clear();
    assert_eq!(ruling(&made), Fail);
    flips(&mut made).rungs.iter_mut().for_each(|rung| rung.times.clear());
    assert_eq!(ruling(&made), Pass);
}

#[test]
fn one_flip_more_or_less_is_the_same_at_the_end_of_the_run_and_nowhere_else() {
    // The last true flip, or the one more of the run, is this far from the end, and the others are late by this much.
    let one_off = |before_end: f64, late_by: f64, less: bool| {
        let mut made = late(&[late_by; RUNS]);
        let flips = flips(&mut made);
        let last = flips.duration - before_end;
        if less {
            flips.truth.times.push(last);
        } else {
            flips.rungs.iter_mut().for_each(|rung| rung.times.push(last));
        }
        is_complete(flips, &flips.rungs[7])
    };
    for less in [true, false] {
        assert!(one_off(0.0, 0.0, less) && one_off(0.99, 0.1, less));
        assert!(!one_off(1.01, 0.1, less) && !one_off(1e-3, 0.0, less));
    }
    // In the middle, or two of them, they are others.
    let without = |flip: usize, count: usize| {
        let mut made = late(&[1e-3; RUNS]);
        let flips = flips(&mut made);
        flips.rungs[7].times.drain(flip..flip + count);
        is_complete(flips, &flips.rungs[7])
    };
    assert!(!without(3, 1) && !without(1, 1) && !without(2, 2));
    // The order is that of the flips that all have.
    for (late_by, expected) in [(2.0, Pass), (1.0, Fail)] {
        let mut made = late(&power(late_by));
        flips(&mut made).truth.times.push(50.0 - 1e-6);
        assert_eq!(ruling(&made), expected);
    }
}

#[test]
fn flips_that_are_not_known_are_not_judged() {
    // Copies that are a tenth of the time apart in which L turns by a radian, over thirty, decide nothing.
    let far = 2.0 / 10.0 / 30.0;
    for (rounding, expected) in [
        ([0.99 * far; 4], Pass),
        ([1.01 * far; 4], Inconclusive),
        ([0.0, 0.0, 0.0, 10.0 * far], Inconclusive),
    ] {
        let mut made = late(&[0.0; RUNS]);
        flips(&mut made).rungs.iter_mut().for_each(|rung| rung.rounding = rounding.to_vec());
        assert_eq!(ruling(&made), expected, "{rounding:?}");
    }
    // A flip that not all copies have.
    let mut made = late(&power(2.0));
    flips(&mut made).rungs.iter_mut().for_each(|rung| {
        rung.times.push(49.0);
        rung.rounding.push(f64::INFINITY);
    });
    assert_eq!(ruling(&made), Inconclusive);
    made.evidence.flips = None;
    assert_eq!(ruling(&made), NotApplicable);
    // Of the last flip, the copies are a thirtieth of the rest of the run apart: there may be one less.
    let rest = 50.0 - 40.0;
    for (apart, expected) in [(0.99 / 30.0, Fail), (1.01 / 30.0, Inconclusive)] {
        let mut made = late(&[0.0; RUNS]);
        let flips = flips(&mut made);
        flips.truth.times.pop();
        flips.rungs.iter_mut().for_each(|rung| rung.rounding[3] = apart * rest);
        assert_eq!(ruling(&made), expected, "{apart}");
    }
}
