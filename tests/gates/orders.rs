//! Convergence, orders, error constants and errors on record.

use polhode::gates::Baseline;
use polhode::internals::measure::{Asked, Decision, Doubt, decide};
use polhode::record::ClaimName::{self, Constant, Converges, ErrorOnRecord, Order, Run, Start};
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{Ladder, Rule, Verdict};
use polhode::scenes;
use polhode::schemes::{Claim, Quantity, When};

use super::case::{FLOOR, Made, ROUNDING, RUNS, Recorded, numbers, power, rung};

const SECOND: &[Claim] = &[Claim::Order(2)];
const POSITION: Quantity = Quantity::Position;

/// A second-order scheme under torque, whose position has these errors.
fn position(errors: &[f64], rounding: f64) -> Made {
    Made::new("kovalevskaya", SECOND).with_errors(POSITION, errors, rounding)
}

#[test]
fn an_order_is_at_least_the_claimed_one_and_the_slope_stands_beside_the_verdict() {
    for (order, expected) in [(1.0, Fail), (2.0, Pass), (3.0, Pass)] {
        let made = position(&power(order), ROUNDING);
        let verdict = made.verdict(Order, "position");
        let [slope, low, high] = numbers(&verdict).map(|number| number.expect("a number"));
        assert_eq!(verdict.verdict, expected, "{order}");
        // The residual r of a pure power is zero: slope and bounds equal the order to rounding of its logarithm.
        assert!([slope, low, high].iter().all(|number| (number - order).abs() < 1e-12), "{verdict:?}");
        // An order that is judged says whether the runs converge.
        assert!(!made.quantities(Converges).contains(&"position".to_owned()));
    }
    let next = Made::new("kovalevskaya", SECOND).with(POSITION, |h, _| h * h + h.powi(3));
    let [slope, low, high] =
        numbers(&next.verdict(Order, "position")).map(|number| number.expect("a number"));
    // One component with a positive next term has its slope at a bound, to rounding.
    assert!(low < 2.0 && 2.0 < high && low < slope && slope < high + 1e-12, "{slope} [{low}, {high}]");
}

#[test]
fn an_order_that_the_whole_motion_leaves_open_is_that_of_its_beginning() {
    // Errors of the size of the motion that fall for no order.
    let open = [1.0, 0.3, 0.9, 0.2, 0.8, 0.3, 0.7, 0.25];
    let with = |beginning: Made, whole: &[f64]| {
        let mut made = position(whole, ROUNDING);
        made.evidence.beginning = Some(beginning.evidence.ladder);
        made.verdict(Order, "position")
    };
    let of_order = |order| position(&power(order), ROUNDING);
    assert_eq!(position(&open, ROUNDING).ruling(Order, "position"), Inconclusive);
    for (order, expected) in [(1.0, Fail), (2.0, Pass), (3.0, Pass)] {
        let verdict = with(of_order(order), &open);
        assert_eq!(verdict.verdict, expected, "{order}");
        assert!((verdict.measured.expect("a slope") - order).abs() < 1e-12, "{verdict:?}");
    }
    // What the whole motion decides stands, and neither no error at the beginning nor one that falls for no order is evidence.
    assert_eq!(with(of_order(1.0), &power(2.0)).verdict, Pass);
    assert_eq!(with(position(&[0.0; RUNS], ROUNDING), &open).verdict, Inconclusive);
    assert_eq!(with(position(&open, ROUNDING), &open).verdict, Inconclusive);
    let mut elsewhere = position(&open, ROUNDING);
    let beginning = Made::new("kovalevskaya", SECOND).with(POSITION, |h, _| 0.25 + 0.01 * h * h);
    elsewhere.evidence.beginning = Some(beginning.evidence.ladder);
    assert_eq!(elsewhere.ruling(Converges, "position"), Fail);
}

#[test]
fn in_a_generic_scene_one_quantity_has_exactly_the_claimed_order() {
    let all = |made: &Made| made.judge().into_iter().find(|v| v.claim == Order && v.quantity == "all");
    for (order, generic, expected) in [(2.0, true, false), (3.0, true, true), (3.0, false, false)] {
        let mut made = Made::of_order("free-asymmetric", SECOND, order);
        made.evidence.setting.generic = generic;
        let verdict = all(&made);
        assert_eq!(verdict.is_some(), expected, "{order} {generic}");
        if let Some(Verdict { verdict, measured, high, .. }) = verdict {
            assert_eq!((verdict, measured, high), (Fail, Some(3.0), Some(2.0)));
        }
        // One quantity is enough, and none is where no order is claimed.
        assert!(all(&made.clone().with_errors(POSITION, &power(2.0), ROUNDING)).is_none());
        made.evidence.claims.clear();
        assert!(all(&made).is_none());
    }
}

#[test]
fn runs_that_converge_elsewhere_fail_in_every_scene_but_where_that_is_claimed() {
    let at = |claims: &[Claim], not_for_order: Option<&str>| {
        let mut made = Made::new("kovalevskaya", claims).with(POSITION, |h, _| 0.25 + 0.01 * h * h);
        made.evidence.setting.not_for_order = not_for_order.map(str::to_owned);
        made
    };
    for (claims, not_for_order, expected) in [
        (SECOND, None, Fail),
        (&[], None, Fail),
        (SECOND, Some("it is so"), Fail),
        (&[Claim::SolvesAnotherMotion], None, Pass),
    ] {
        let verdict = at(claims, not_for_order).verdict(Converges, "position");
        assert_eq!(verdict.verdict, expected, "{claims:?}");
        // Of the finest run, with h = 1/128.
        assert!((verdict.measured.expect("an error") - 0.25).abs() < 1e-6, "{verdict:?}");
    }
    // A motion that is another has no order; one that is right beside it has.
    let judged = at(SECOND, None).quantities(Order);
    assert!(!judged.contains(&"position".to_owned()) && judged.contains(&"velocity".to_owned()));
}

#[test]
fn an_error_that_stays_is_of_a_kink_where_a_run_of_odd_steps_has_another() {
    for (kinks, last, expected) in [
        (true, 0.25, Fail),
        // Runs that agree differ by a tenth at the most.
        (true, 0.226, Fail),
        (true, 0.224, NotApplicable),
        (false, 0.224, Fail),
    ] {
        let mut made = Made::new("kovalevskaya", SECOND).with(POSITION, |_, _| 0.25);
        made.evidence.setting.not_for_order = kinks.then(|| "a kink".to_owned());
        let odd = |(steps, error)| {
            let mut odd = rung(steps, 1);
            odd.errors[POSITION][0] = error;
            odd
        };
        made.evidence.ladder.odd = [(633, 0.25), (829, 0.25), (949, last)].map(odd).to_vec();
        assert_eq!(made.ruling(Converges, "position"), expected, "{last}");
    }
}

#[test]
fn an_error_that_vanishes_from_one_run_to_the_next_fails_unless_a_step_may_end_at_a_kink() {
    for (kinks, expected) in [(false, Fail), (true, NotApplicable)] {
        let mut errors = power(1.0).map(|h| 0.05 * h);
        errors[RUNS - 1] = 0.0;
        let mut made = position(&errors, ROUNDING);
        made.evidence.setting.not_for_order = kinks.then(|| "a kink".to_owned());
        let of_jumps = made.judge().into_iter().find(|verdict| verdict.rule == Rule::Jump.word());
        assert_eq!(of_jumps.expect("a verdict").verdict, expected, "{kinks}");
    }
}

#[test]
fn what_is_undecided_is_inconclusive_with_its_doubt_and_what_is_exact_has_no_order() {
    let first_three = |k: usize, h: f64| if k < 3 { h * h } else { 0.02 };
    let doubled = |k: usize, h: f64| if k.is_multiple_of(2) { h } else { 2.0 * h };
    let errors = |of: &dyn Fn(usize, f64) -> f64| -> [f64; RUNS] {
        let steps = power(1.0);
        std::array::from_fn(|k| of(k, steps[k]))
    };
    for (errors, rounding, expected) in [
        (&power(2.0)[..3], ROUNDING, Decision::Undecided(Doubt::FewRuns { whole: 3 })),
        // Three errors are more than 30 times a rounding of a thousandth.
        (&errors(&first_three), 1e-3, Decision::Undecided(Doubt::Rounding { clear: 3 })),
        // Thirty times a hundredth of the quantity.
        (&power(2.0), 0.01, Decision::Undecided(Doubt::Open { rounding: 0.3 })),
        (&[FLOOR; RUNS], ROUNDING, Decision::Exact),
        (&[0.0; RUNS], ROUNDING, Decision::Exact),
    ] {
        let made = position(errors, rounding);
        assert_eq!(decide(&Asked::of(&made.evidence.ladder, POSITION)), expected);
        let exact = expected == Decision::Exact;
        assert_eq!(made.ruling(Order, "position"), if exact { NotApplicable } else { Inconclusive });
        assert_eq!(numbers(&made.verdict(Order, "position")), [None; 3]);
    }
    let made = position(&errors(&doubled), ROUNDING);
    let decision = decide(&Asked::of(&made.evidence.ladder, POSITION));
    assert!(matches!(decision, Decision::Undecided(Doubt::NotAsymptotic { .. })), "{decision:?}");
    assert_eq!(made.ruling(Order, "position"), Inconclusive);
}

#[test]
fn the_finest_run_comes_to_its_end_and_runs_after_a_broken_one_are_judged() {
    let made = position(&power(2.0), ROUNDING);
    for (broken, expected) in [(0, Pass), (3, Pass), (4, Inconclusive), (6, Inconclusive)] {
        assert_eq!(made.clone().broken(broken).ruling(Order, "position"), expected, "{broken}");
    }
    let mut without = made.clone();
    without.evidence.ladder.rungs.clear();
    for made in [made.clone().broken(RUNS - 1), without] {
        let of_order = |v: &Verdict| [Order, Converges, Constant].contains(&v.claim);
        assert_eq!((made.ruling(Run, "all"), made.judge().iter().any(of_order)), (Broken, false));
    }
    assert!(made.quantities(Run).is_empty());
}

#[test]
fn every_quantity_is_judged_but_what_is_promised_to_be_exact_and_the_rotation_of_a_point() {
    let exact = |quantity, when| Claim::Exact(quantity, when);
    let (place, turn) = (exact(POSITION, When::NoForce), exact(Quantity::Orientation, When::SteadySpin));
    let names = |without: &[Quantity]| -> Vec<&str> {
        let judged = Quantity::ALL.into_iter().filter(|quantity| !without.contains(quantity));
        judged.map(Quantity::name).collect()
    };
    for (scene, more, without) in [
        ("free-asymmetric", vec![], vec![]),
        ("free-asymmetric", vec![place], vec![POSITION]),
        // A promise that does not hold in the scene exempts no quantity.
        ("free-asymmetric", vec![turn], vec![]),
        // A body point is exact where place and rotation are.
        ("slow-sphere", vec![place, turn], vec![POSITION, Quantity::Orientation, Quantity::BodyPoint]),
    ] {
        let claims = [SECOND, &more].concat();
        assert_eq!(Made::of_order(scene, &claims, 2.0).quantities(Order), names(&without), "{more:?}");
    }
    let rotation = [Quantity::Orientation, Quantity::AngularVelocity, Quantity::AngularMomentum];
    let mut point = Made::of_order("gravity-drag", SECOND, 2.0);
    point.evidence.setting.point = true;
    point.evidence.ladder.arms.clear();
    point.evidence.ladder.rungs.iter_mut().for_each(|rung| rung.errors[Quantity::Orientation].clear());
    assert_eq!(point.quantities(Order), names(&rotation));
    assert_eq!(point.ruling(Order, "body-point"), Pass);
}

#[test]
fn a_body_point_is_off_by_place_and_rotation_together() {
    // The position and, over √2, the first axis are off by opposite vectors: the end of the first arm of one metre is where it should be.
    let shift = |h: f64| h * h;
    let made = Made::new("kovalevskaya", SECOND)
        .with(POSITION, |h, _| shift(h))
        .with(Quantity::Orientation, |h, _| -shift(h) * std::f64::consts::FRAC_1_SQRT_2);
    let rung = &made.evidence.ladder.rungs[1];
    let points = rung.error(Quantity::BodyPoint, &made.evidence.ladder.arms);
    // Three arms at four times: the first is right, the other two are shifted.
    let expected = [0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.25, 0.0, 0.0].repeat(4);
    assert!(points.len() == 36 && points.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-15));
    assert_eq!(made.ruling(Order, "body-point"), Pass);
}

#[test]
fn without_torque_the_order_is_that_claimed_for_it() {
    const CLAIMS: &[Claim] = &[Claim::Order(2), Claim::OrderWithoutTorque(4)];
    for (scene, order, expected) in [
        ("free-asymmetric", 2.0, Fail),
        ("free-asymmetric", 4.0, Pass),
        ("kovalevskaya", 1.0, Fail),
        ("kovalevskaya", 2.0, Pass),
    ] {
        assert_eq!(Made::of_order(scene, CLAIMS, order).ruling(Order, "position"), expected, "{scene}");
    }
}

#[test]
fn a_scene_that_carries_no_order_has_no_verdict_on_one() {
    let mut made = Made::of_order("kovalevskaya", SECOND, 1.0);
    made.evidence.setting.not_for_order = Some("it is so".to_owned());
    assert_eq!((made.quantities(Order), made.ruling(Order, "all")), (vec!["all".to_owned()], NotApplicable));
    assert_eq!(made.ruling(Converges, "orientation"), Pass);
}

#[test]
fn a_program_begins_at_the_start_of_the_scene_and_claims_an_order() {
    // Thirty units in the last place, and thirty halves of the last digit that is printed.
    for (printed, allowed) in [(0.0, 30.0 * f64::EPSILON), (0.5e-6, 30.0 * (f64::EPSILON + 0.5e-6))] {
        let at = |program: bool, apart: f64| {
            let mut made = Made::new("kovalevskaya", SECOND);
            made.evidence.program = program;
            made.evidence.ladder.printed = printed;
            made.evidence.ladder.start[Quantity::Velocity] = apart;
            made
        };
        assert!(at(true, allowed).quantities(Start).is_empty());
        assert!(at(false, 2.0 * allowed).quantities(Start).is_empty());
        let verdict = at(true, allowed * 1.001).verdict(Start, "velocity");
        assert_eq!((verdict.verdict, verdict.high), (Fail, Some(allowed)));
        assert_eq!(at(true, f64::NAN).ruling(Start, "velocity"), Fail);
    }
    for (claims, program, expected) in [
        (&[] as &[Claim], true, vec!["all"]),
        (&[], false, vec![]),
        (&[Claim::SolvesAnotherMotion], true, vec!["all"]),
    ] {
        let mut made = Made::of_order("kovalevskaya", claims, 2.0);
        made.evidence.program = program;
        assert_eq!(made.quantities(Order), expected);
        assert!(!program || made.ruling(Order, "all") == Inconclusive);
    }
}

#[test]
fn an_odd_number_of_steps_is_what_the_other_runs_make_of_it() {
    let with = |mut made: Made, steps: u64, error: f64| {
        let mut odd = rung(steps, 1);
        odd.errors[POSITION][0] = error;
        made.evidence.ladder.odd = vec![odd];
        let failed = |v: &Verdict| v.claim == Converges && v.quantity == "position" && v.verdict == Fail;
        made.judge().iter().any(failed)
    };
    let second = |steps, error| with(position(&power(2.0), ROUNDING), steps, error);
    // 49 steps lie between 32 and 64, whose errors are 1/16 and 1/64: up to twice their difference, over four times, from the coarser one.
    let (coarse, apart) = (1.0 / 16.0, 2.0 * 3.0 / 64.0);
    assert_eq!(
        [0.0267, coarse + 2.0 * apart, coarse - 2.0 * apart].map(|error| second(49, error)),
        [false; 3]
    );
    assert_eq!([coarse + 2.01 * apart, coarse - 2.01 * apart].map(|error| second(49, error)), [true; 2]);
    // What is at its rounding otherwise is so here, in giant steps too where it is promised to be.
    let exact = |claims: &[Claim], steps, error| with(Made::new("free-asymmetric", claims), steps, error);
    let promised = &[Claim::Order(2), Claim::Exact(POSITION, When::NoForce)];
    assert_eq!([exact(SECOND, 49, FLOOR), exact(SECOND, 49, 1.01 * FLOOR)], [false, true]);
    assert_eq!(
        [exact(SECOND, 7, 1.0), exact(promised, 7, 1.0), exact(promised, 7, FLOOR)],
        [false, true, false]
    );
    // A run of an odd number of steps is not judged where the order is undecided.
    assert!(!with(position(&power(2.0)[..3], ROUNDING), 49, 1.0));
}

/// The verdicts on the constant of a position, beside one on record.
fn constant(made: &Made, change: impl FnOnce(&mut Recorded)) -> Vec<Ruling> {
    on_record(made, Constant, change)
}

/// The verdicts of a claim on a position, beside a row on record.
fn on_record(made: &Made, claim: ClaimName, change: impl FnOnce(&mut Recorded)) -> Vec<Ruling> {
    let mut row = Recorded::of(made, POSITION);
    change(&mut row);
    let judged = made.clone().recorded(row).judge();
    // A body point follows the position.
    let own = judged.into_iter().filter(|v| v.claim == claim && v.quantity == "position");
    own.map(|v| v.verdict).collect()
}

#[test]
fn a_constant_is_that_on_record_to_one_percent() {
    // The constant of h² is one.
    let second = position(&power(2.0), ROUNDING);
    let at = |known: f64| constant(&second, |row| row.constant = Some(known));
    assert_eq!([at(1.0), at(1.0 / 1.0099), at(1.0 / 0.9901)], [[Pass]; 3]);
    assert_eq!([at(1.0 / 1.0101), at(1.0 / 0.9899), at(-1.0), at(f64::NAN)], [[Fail]; 4]);
    let mut row = Recorded::of(&second, POSITION);
    row.constant = Some(4.0);
    let verdict = second.clone().recorded(row).verdict(Constant, "position");
    let expected = [1.0, 4.0 * 0.99, 4.0 * 1.01];
    let shown = numbers(&verdict).map(|number| number.expect("a number"));
    assert!(shown.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{shown:?}");
    // Where the order fails no constant is judged.
    let mut row = Recorded::of(&second, POSITION);
    row.constant = Some(1.0);
    let first = position(&power(1.0), ROUNDING).recorded(row);
    assert_eq!([first.ruling(Constant, "position"), first.ruling(Order, "position")], [NotApplicable, Fail]);
    // A vanished error shows another scheme; an undecided one gives no verdict.
    let gone = |made: &Made| constant(made, |row| row.constant = Some(1.0));
    assert_eq!(gone(&position(&[0.0; RUNS], ROUNDING)), [Fail]);
    assert_eq!(gone(&position(&power(2.0)[..3], ROUNDING)), [Inconclusive]);
}

#[test]
fn a_record_is_of_one_content_one_scheme_and_one_quantity() {
    let made = position(&power(2.0), ROUNDING);
    let at = |change: fn(&mut Recorded)| {
        constant(&made, |row| {
            row.constant = Some(1.0);
            change(row);
        })
    };
    assert_eq!(at(|_| ()), [Pass]);
    let other =
        scenes::built_in().iter().map(|scene| scene.content()).find(|c| *c != made.evidence.setting.content);
    assert!(other.is_some());
    assert!(at(|row| row.content.push('0')).is_empty() && at(|row| row.content.clear()).is_empty());
    assert!(at(|row| row.scheme.push('0')).is_empty());
    assert!(at(|row| row.quantity = Quantity::Velocity).is_empty());
    assert!(at(|row| row.constant = None).is_empty());
    assert!(Baseline::default().pairs().is_empty());
}

#[test]
fn the_error_of_every_run_is_that_on_record_to_a_half_of_it() {
    let second = position(&power(2.0), ROUNDING);
    let at =
        |made: &Made, h: f64, known: f64| on_record(made, ErrorOnRecord, |row| row.errors = vec![(h, known)]);
    // 1/16 at h = 1/4: known to a half of itself and the floor.
    let error = 1.0 / 16.0;
    for (known, expected) in [
        (error, vec![Pass]),
        (error / 1.499, vec![Pass]),
        (error / 1.501, vec![Fail]),
        (error / 0.501, vec![Pass]),
        (error / 0.499, vec![Fail]),
    ] {
        assert_eq!(at(&second, 0.25, known), expected, "{known}");
    }
    // The record has no step in between.
    assert_eq!(at(&second, 0.3, 7.0), [NotApplicable]);
    // What is at its rounding is so whatever the record, and a run that broke is none.
    let exact = position(&[FLOOR; RUNS], ROUNDING);
    assert_eq!([at(&exact, 0.25, 0.0), at(&exact, 0.25, 1.0)], [vec![Pass], vec![Fail]]);
    assert_eq!(at(&second.clone().broken(0), 1.0, 1.0), [Fail]);
    assert_eq!(at(&second.broken(0), 0.5, 0.25), [Pass]);
}

#[test]
fn an_order_that_f64_leaves_open_is_decided_in_double_double() {
    let sixth = |order, rounding| {
        Made::new("kovalevskaya", &[Claim::Order(6)]).with_errors(POSITION, &power(order), rounding)
    };
    let finer = |order| Some(Ladder { double_double: true, ..sixth(order, 0.0).evidence.ladder });
    // Two errors of order 6 stand clear of this rounding, and the rule needs four.
    for (order, expected) in [(6.0, Pass), (7.0, Pass), (5.0, Fail)] {
        let mut made = sixth(order, 1e-4);
        assert_eq!(made.ruling(Order, "position"), Inconclusive, "{order}");
        made.evidence.precise = finer(order);
        assert_eq!(made.ruling(Order, "position"), expected, "{order}");
        // Runs in f64 that differ by more than rounding have another error.
        made.evidence.precise = finer(order - 2.0);
        assert_eq!(made.ruling(Order, "position"), Inconclusive, "{order}");
    }
    let mut made = sixth(6.0, ROUNDING);
    made.evidence.precise = finer(5.0);
    // Where f64 decides, nothing else is asked.
    assert_eq!(made.ruling(Order, "position"), Pass);
    // The unit of double-double is that of a step: errors that f64 rounds away count.
    let small: Vec<f64> = power(6.0).map(|error| 1e-16 * error).to_vec();
    let tiny =
        Made::new("kovalevskaya", &[Claim::Order(6)]).with_errors(POSITION, &small, 0.0).evidence.ladder;
    let decided = |double_double| {
        let ladder = Ladder { double_double, ..tiny.clone() };
        matches!(decide(&Asked::of(&ladder, POSITION)), Decision::Order(found) if found.order == 6)
    };
    assert_eq!([false, true].map(decided), [false, true]);
}
