//! Solvers that choose their own steps.

use polhode::record::ClaimName::{Converges, FollowsTolerance, Order, Run};
use polhode::record::Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::schemes::{Claim, Quantity};

use super::case::{FLOOR, Made, ROUNDING, RUNS, numbers};

/// The step of a plan stands for a tolerance h².
const FOLLOWS: &[Claim] = &[Claim::FollowsTolerance(2)];

/// Errors at tolerances of which each is a quarter of the last; the work doubles each time, and counts as steps of 1e-13 each at most.
fn solver(errors: &[f64]) -> Made {
    let mut made = Made::new("free-asymmetric", FOLLOWS).with_errors(Quantity::Orientation, errors, ROUNDING);
    for (run, rung) in made.evidence.ladder.rungs.iter_mut().enumerate() {
        rung.evaluations = 100 << run;
    }
    made
}

/// A hundredth of the tolerance to a power, twice as large and half as large by this in turn.
fn power(slope: f64, scatter: f64) -> [f64; RUNS] {
    std::array::from_fn(|run| {
        let sign = if run % 2 == 0 { 1.0 } else { -1.0 };
        0.01 * 0.25f64.powf(slope * run as f64) * 2f64.powf(sign * scatter)
    })
}

#[test]
fn an_error_follows_the_tolerance_to_a_power_between_a_half_and_three_halves() {
    for (slope, scatter, expected) in [
        (0.51, 0.0, Pass),
        (1.0, 0.0, Pass),
        (1.49, 0.0, Pass),
        (1.0, 1.0, Pass),
        (0.49, 0.0, Fail),
        (1.51, 0.0, Fail),
        (-0.1, 0.0, Fail),
    ] {
        let verdict = solver(&power(slope, scatter)).verdict(FollowsTolerance, "orientation");
        assert_eq!(verdict.verdict, expected, "{slope} {scatter}");
        let [measured, low, high] = numbers(&verdict).map(|number| number.expect("a number"));
        // Eight points in the logarithm, of which every second is up by one and the next down: the slope moves by 2 × 4 × 4/(42 × 4).
        assert!((measured - slope).abs() <= 1e-9 + scatter * 0.2, "{measured}");
        assert_eq!((low, high), (0.5, 1.5));
    }
}

#[test]
fn fewer_than_four_tolerances_that_rule_the_error_decide_nothing() {
    let at = |change: &dyn Fn(&mut Made)| {
        // Five are clear: the last three are at their rounding.
        let errors: [f64; RUNS] = std::array::from_fn(|run| if run < 5 { power(1.0, 0.0)[run] } else { 0.0 });
        let mut made = solver(&errors);
        change(&mut made);
        made.verdict(FollowsTolerance, "orientation").verdict
    };
    let large = |made: &mut Made, run: usize| {
        made.evidence.ladder.rungs[run].errors[Quantity::Orientation].fill(1.0);
    };
    let same_work = |made: &mut Made, run: usize| {
        made.evidence.ladder.rungs[run].evaluations = made.evidence.ladder.rungs[run + 1].evaluations;
    };
    assert_eq!(at(&|made| large(made, 0)), Pass);
    // As large as the motion; then no more work at the next tolerance.
    for change in [large, same_work] {
        let decides = |runs: &[usize]| at(&|made| runs.iter().for_each(|run| change(made, *run)));
        assert_eq!([decides(&[0]), decides(&[1, 0])], [Pass, Inconclusive]);
    }
    assert_eq!(at(&|made| *made = made.clone().broken(0)), Pass);
}

#[test]
fn errors_at_their_rounding_at_every_tolerance_leave_nothing_to_follow() {
    let ruling = |error: f64| solver(&[error; RUNS]).ruling(FollowsTolerance, "orientation");
    assert_eq!([ruling(0.0), ruling(FLOOR), ruling(1.01 * FLOOR)], [NotApplicable, NotApplicable, Fail]);
    let mut made = solver(&power(0.0, 0.0));
    made.evidence.setting.not_for_order = Some("it is so".to_owned());
    assert_eq!(made.ruling(FollowsTolerance, "orientation"), NotApplicable);
}

#[test]
fn a_solver_that_broke_at_the_finest_tolerance_or_never_ran_does_not_pass() {
    let made = solver(&power(1.0, 0.0));
    assert!([Run, Order, Converges].iter().all(|claim| made.quantities(*claim).is_empty()));
    let mut silent = solver(&[]);
    silent.evidence.ladder.rungs.clear();
    for made in [made.broken(RUNS - 1), silent] {
        assert_eq!(made.ruling(Run, "all"), Broken);
    }
}

#[test]
fn three_quantities_are_followed() {
    assert_eq!(
        solver(&power(1.0, 0.0)).quantities(FollowsTolerance),
        ["position", "orientation", "body-point"]
    );
}
