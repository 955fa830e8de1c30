//! What is promised to be exact.

use polhode::internals::measure::{Place, PointRun};
use polhode::record::Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::schemes::{Claim, Quantity, When};
use polhode::simulate::Outcome;

use super::case::{FLOOR, Made, broken, numbers, rung};

const TURNS: &[Claim] = &[Claim::Exact(Quantity::Orientation, When::SteadySpin)];
const SPINS: &[Claim] = &[Claim::Exact(Quantity::AngularVelocity, When::SteadySpin)];
const MOMENTUM: &[Claim] = &[Claim::Exact(Quantity::AngularMomentum, When::NoTorque)];

#[test]
fn every_promise_speaks_of_its_own_scenes_and_of_no_other() {
    let speaks = |claims: &'static [Claim], scene: &str| {
        let made = Made::new(scene, claims).with_errors(Quantity::Velocity, &[0.0; 6], FLOOR);
        made.judge().iter().find(|v| v.claim.word() == "exact").expect("a verdict").verdict != NotApplicable
    };
    // Free; falling; under springs; on a pivot; a sphere; two equal moments.
    let scenes = ["free-asymmetric", "tether-springs", "heavy-asymmetric-top", "slow-sphere", "free-oblate"];
    for (claims, expected) in [
        (&[Claim::Exact(Quantity::Velocity, When::NoForce)] as &[Claim], [true, false, false, true, true]),
        (&[Claim::Exact(Quantity::Velocity, When::ConstantForce)], [true, false, false, true, true]),
        (&[Claim::Exact(Quantity::Velocity, When::NoTorque)], [true, false, false, true, true]),
        (&[Claim::Exact(Quantity::Velocity, When::SteadySpin)], [false, false, false, true, false]),
        (&[Claim::Exact(Quantity::Velocity, When::SymmetricBody)], [false, false, false, true, true]),
    ] {
        assert_eq!(scenes.map(|scene| speaks(claims, scene)), expected, "{claims:?}");
    }
    // A symmetric top under torque is no free symmetric body.
    assert!(!speaks(&[Claim::Exact(Quantity::Velocity, When::SymmetricBody)], "lagrange-fast-top"));
}

#[test]
fn every_error_is_at_most_ten_floors_at_the_end_and_over_the_run() {
    let at =
        |errors: [f64; 6]| Made::new("slow-sphere", TURNS).with_errors(Quantity::Orientation, &errors, FLOOR);
    let bound = 10.0 * FLOOR;
    for (errors, expected) in [
        ([0.0; 6], Pass),
        ([bound; 6], Pass),
        ([bound.next_up(), 0.0, 0.0, 0.0, 0.0, 0.0], Fail),
        ([0.0, 0.0, 0.0, 0.0, 0.0, bound.next_up()], Fail),
        ([0.0, 0.0, 0.0, 0.0, 0.0, f64::NAN], Broken),
    ] {
        for place in ["orientation-end", "orientation-max"] {
            assert_eq!(at(errors).ruling("exact", place), expected, "{errors:?}");
        }
    }
    let verdict = at([0.0, 5e-14, 0.0, 2e-14, 0.0, 0.0]).verdict("exact", "orientation-end");
    assert_eq!(numbers(&verdict), [Some(5e-14), Some(0.0), Some(bound)]);
    assert_eq!(at([0.0; 6]).quantities("exact"), ["orientation-end", "orientation-max"]);
}

#[test]
fn each_verdict_is_on_its_own_quantity_at_its_own_place() {
    let mut made = Made::new("slow-sphere", TURNS)
        .with_errors(Quantity::Velocity, &[1.0; 6], FLOOR)
        .with_errors(Quantity::Orientation, &[0.0; 6], FLOOR);
    assert_eq!(["orientation-end", "orientation-max"].map(|place| made.ruling("exact", place)), [Pass; 2]);
    made.evidence.ladders[3].rungs[2].1 = 1.0;
    assert_eq!(["orientation-end", "orientation-max"].map(|place| made.ruling("exact", place)), [Pass, Fail]);
}

#[test]
fn the_worst_rung_is_that_which_is_farthest_above_its_own_floor() {
    let mut made = Made::new("slow-sphere", TURNS).with_errors(Quantity::Orientation, &[0.0; 6], FLOOR);
    let ladder =
        made.evidence.ladders.iter_mut().find(|ladder| ladder.place == Place::End).expect("a ladder");
    ladder.rungs[0] = (1.0, 1e-15, FLOOR);
    ladder.rungs[1] = (0.5, 9e-15, 1e-16);
    ladder.rungs[4] = (1.0 / 16.0, 20e-15, 3e-15);
    let verdict = made.verdict("exact", "orientation-end");
    assert_eq!((verdict.verdict, numbers(&verdict)), (Fail, [Some(9e-15), Some(0.0), Some(10.0 * 1e-16)]));
    // Of a run that broke nothing is said.
    made.evidence.rungs[1] = broken(made.evidence.rungs[1].clone());
    assert_eq!(made.ruling("exact", "orientation-end"), Pass);
}

#[test]
fn giant_steps_are_held_to_ten_floors_where_runs_came_to_their_end() {
    let at = |errors: [f64; 2]| {
        let mut made = Made::new("slow-sphere", TURNS);
        made.evidence.giant_steps = vec![rung(8.0, 1, errors[0], 0.0), rung(1.0, 7, errors[1], 0.0)];
        made
    };
    let bound = 10.0 * FLOOR;
    let ruling = |errors| at(errors).ruling("exact", "orientation-giant-steps");
    assert_eq!([ruling([0.0, 0.0]), ruling([bound, 0.0]), ruling([0.0, bound])], [Pass; 3]);
    assert_eq!(
        [ruling([bound.next_up(), 0.0]), ruling([0.0, bound.next_up()]), ruling([f64::NAN, 0.0])],
        [Fail; 3]
    );
    assert_eq!(
        numbers(&at([1e-15, 2e-15]).verdict("exact", "orientation-giant-steps")),
        [Some(2e-15), Some(0.0), Some(bound)]
    );
    let mut made = at([1.0, 0.0]);
    made.evidence.giant_steps[0] = broken(made.evidence.giant_steps[0].clone());
    assert_eq!(made.ruling("exact", "orientation-giant-steps"), Pass);
    // No error is exact whatever the floor is, and the worst is that which is nearest to its own bound.
    let mut made = at([0.0, 3e-15]);
    made.evidence.giant_steps[0].floors[Quantity::Orientation].end = 0.0;
    let verdict = made.verdict("exact", "orientation-giant-steps");
    assert_eq!((verdict.verdict, verdict.measured), (Pass, Some(3e-15)));
    made.evidence.giant_steps[0] = rung(8.0, 1, 2e-15, 0.0);
    made.evidence.giant_steps[0].floors[Quantity::Orientation].end = 1e-16;
    assert_eq!(made.verdict("exact", "orientation-giant-steps").measured, Some(2e-15));
    assert!(Made::new("slow-sphere", TURNS).quantities("exact").is_empty());
}

#[test]
fn nothing_is_called_exact_where_rounding_leaves_the_rotation_open() {
    let at = |claims: &'static [Claim], open: f64| {
        let mut made = Made::new("slow-sphere", claims);
        for (quantity, floor) in [(Quantity::Orientation, open), (Quantity::Position, 1.0)] {
            made.evidence.rungs[5].floors[quantity].max = floor;
        }
        made.judge().into_iter().find(|v| v.claim.word() == "exact").map(|v| v.verdict)
    };
    for claims in [TURNS, SPINS] {
        assert_eq!([at(claims, 1e-3f64.next_up()), at(claims, 1e-3)], [Some(Inconclusive), None]);
    }
    assert_eq!(at(&[Claim::Exact(Quantity::Position, When::NoForce)], 1.0), None);
}

#[test]
fn the_momentum_of_the_points_may_change_by_the_rounding_of_its_sums() {
    let at = |claims: &'static [Claim], change: Option<f64>, torque_rounding: f64| {
        let mut made = Made::new("free-asymmetric", claims);
        made.points = Some(PointRun {
            step: 0.5,
            steps: 10_000,
            difference: 0.0,
            stretch: 0.0,
            momentum_change: change,
            torque_rounding,
            rounding: 0.0,
            outcome: Outcome::none_yet(),
        });
        made
    };
    let ruling =
        |change, torque| at(MOMENTUM, Some(change), torque).ruling("exact", "angular-momentum-points");
    // 4 √n + 8 roundings, and those of the torque.
    let bound = 408.0 * f64::EPSILON;
    assert_eq!([ruling(bound, 0.0), ruling(bound.next_up(), 0.0), ruling(f64::NAN, 0.0)], [Pass, Fail, Fail]);
    assert_eq!([ruling(bound + 0.99e-12, 1e-12), ruling(bound + 1.01e-12, 1e-12)], [Pass, Fail]);
    assert!(at(MOMENTUM, None, 0.0).quantities("exact").is_empty());
    let velocity: &'static [Claim] = &[Claim::Exact(Quantity::Velocity, When::NoTorque)];
    assert!(at(velocity, Some(1.0), 0.0).quantities("exact").is_empty());
}
