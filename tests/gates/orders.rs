//! Orders and error constants.

use polhode::internals::gates::{self, Baseline};
use polhode::internals::measure::regression::{Fit, Ladder};
use polhode::internals::measure::{BAND, Place, QuantityLadder};
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{Order, Records};
use polhode::scenes::Scene;
use polhode::schemes::{Claim, Quantity, When};

use super::case::{FLOOR, Made, broken, numbers};

pub const SECOND: &[Claim] = &[Claim::Order(2)];

/// Errors h^order.
pub fn power(order: f64) -> [f64; 6] {
    std::array::from_fn(|k| 0.5f64.powf(order * k as f64))
}

/// What is said of a fit over a ladder that shows nothing else.
fn said(order: u32, low: f64, slope: f64, high: f64) -> (Ruling, String) {
    let rungs = power(slope).iter().zip(0..).map(|(e, k)| (0.5f64.powi(k), *e, 0.0)).collect();
    said_over(rungs, order, Fit { slope, low, high })
}

fn said_over(rungs: Vec<(f64, f64, f64)>, order: u32, fit: Fit) -> (Ruling, String) {
    let ladder = Ladder::Window { rungs: 0..6, fit };
    let made =
        QuantityLadder { quantity: Quantity::BodyPoint, place: Place::End, rungs, ladder, constant: None };
    gates::rule(&made, order)
}

#[test]
fn the_interval_of_a_slope_is_inside_the_band_outside_or_across_an_end() {
    let (bottom, top) = (2.0 - BAND, 2.0 + BAND);
    for (low, slope, high, expected, words) in [
        (bottom, 2.0, top, Pass, "inside"),
        (bottom.next_down(), 2.0, top, Inconclusive, "reaches across"),
        (bottom, 2.0, top.next_up(), Inconclusive, "reaches across"),
        (top, 2.5, 3.0, Inconclusive, "reaches across"),
        (1.0, 1.5, bottom, Inconclusive, "reaches across"),
        (2.9, 3.0, 3.1, Fail, "above the band"),
        (0.9, 1.0, 1.1, Fail, "below the band"),
        (1.4, 1.5, 1.6, Fail, "below the band"),
    ] {
        let (ruling, detail) = said(2, low, slope, high);
        assert!(ruling == expected && detail.contains(words), "[{low}, {high}]: {ruling:?}, {detail}");
        assert!(detail.contains("over 6 rungs") && detail.contains("1.85 … 2.15"), "{detail}");
    }
}

#[test]
fn a_term_of_the_claimed_order_under_the_next_one_is_undecided_where_the_interval_is_outside() {
    let rungs =
        || (0..6).map(|k| 0.7f64.powi(k)).map(|h| (h, 0.05 * h * h + h.powi(3), 0.0)).collect::<Vec<_>>();
    let (bottom, top) = (2.0 - BAND, 2.0 + BAND);
    for (low, slope, high, there) in [
        (top.next_up(), 2.5, 3.0, true),
        (top, 2.5, 3.0, false),
        (1.0, 1.5, bottom.next_down(), true),
        (1.0, 1.5, bottom, false),
    ] {
        let (ruling, detail) = said_over(rungs(), 2, Fit { slope, low, high });
        assert_eq!(
            (ruling, detail.contains("a term of the claimed order is there")),
            (Inconclusive, there),
            "{detail}"
        );
    }
}

#[test]
fn ladders_without_a_slope_say_why() {
    let of = |errors: &[f64], floor: f64| {
        let rungs = (0..).zip(errors).map(|(k, e)| (0.5f64.powi(k), *e, floor)).collect();
        gates::rule(&QuantityLadder::of(Quantity::BodyPoint, Place::End, rungs, 2), 2)
    };
    for (errors, floor, expected, words) in [
        ([0.0; 6], FLOOR, NotApplicable, "exact"),
        ([1.0, 0.25, 0.0625, 0.0, 0.0, 0.0], 1e-3, Inconclusive, "only 3 of 6 rungs"),
        ([1.0, 3.0, 1.0, 3.0, 1.0, 3.0], 0.0, Inconclusive, "down to h = 3.125e-2 s"),
        ([f64::NAN; 6], 0.0, Broken, "no finite error"),
    ] {
        let (ruling, detail) = of(&errors, floor);
        assert!(ruling == expected && detail.contains(words), "{ruling:?}: {detail}");
    }
}

#[test]
fn a_broken_ladder_says_what_broke() {
    let mut made = Made::new("free-asymmetric", SECOND).with_errors(Quantity::Position, &[f64::NAN; 6], 0.0);
    // Runs that differ from one another by numbers are whole: it is the reference that has none.
    let verdict = made.verdict("order", "position-end");
    assert!(
        verdict.verdict == Inconclusive && verdict.detail.contains("reference is not finite"),
        "{verdict:?}"
    );
    made.evidence.rungs[5].moved[Quantity::Position].end = f64::NAN;
    let verdict = made.verdict("order", "position-end");
    assert!(verdict.verdict == Broken && verdict.detail.contains("no finite error"), "{verdict:?}");
    made.evidence.rungs[5] = broken(made.evidence.rungs[5].clone());
    let verdict = made.verdict("order", "position-end");
    assert!(verdict.verdict == Broken && verdict.detail.contains("no longer finite"), "{verdict:?}");
    // Where a smaller step gets past, the step was too large.
    made.evidence.goes_on_in = Some(0.25);
    let verdict = made.verdict("order", "position-end");
    assert!(verdict.verdict == Inconclusive && verdict.detail.contains("steps of 2.5e-1 s"), "{verdict:?}");
}

#[test]
fn every_quantity_is_judged_at_both_places_with_its_fit_but_those_that_are_promised_exact() {
    const EXACT: &[Claim] = &[
        Claim::Order(2),
        Claim::Exact(Quantity::Position, When::NoForce),
        Claim::Exact(Quantity::AngularMomentum, When::SteadySpin),
    ];
    let with = |claims| {
        let made = Made::new("free-asymmetric", claims);
        Quantity::ALL.into_iter().fold(made, |made, quantity| made.with_errors(quantity, &power(2.0), 0.0))
    };
    assert_eq!(with(SECOND).quantities("order").len(), 12);
    let made = with(EXACT);
    let judged = made.quantities("order");
    assert!(
        judged.len() == 10 && !judged.iter().any(|quantity| quantity.starts_with("position")),
        "{judged:?}"
    );
    let verdict = made.verdict("order", "body-point-max");
    let fit = numbers(&verdict).map(|number| number.expect("a fit"));
    assert!(verdict.verdict == Pass && fit.iter().all(|number| (number - 2.0).abs() < 1e-9), "{fit:?}");
    assert!(fit[1] <= fit[0] && fit[0] <= fit[2]);
}

#[test]
fn a_body_point_is_exact_where_place_and_rotation_are() {
    const BOTH: &[Claim] = &[
        Claim::Order(2),
        Claim::Exact(Quantity::Position, When::NoForce),
        Claim::Exact(Quantity::Orientation, When::SteadySpin),
    ];
    for (scene, judged) in [("slow-sphere", 0), ("free-asymmetric", 2)] {
        let made = Made::new(scene, BOTH).with_errors(Quantity::BodyPoint, &power(2.0), 0.0);
        assert_eq!(made.quantities("order").len(), judged, "{scene}");
    }
}

#[test]
fn rotation_of_a_single_point_has_no_order() {
    let text = "name = \"point\"\nduration = 1.0\n[body]\npoints = [{ mass = 1.0, position = [0, 0, 0] }]\n\
                [initial]\nangular_velocity = [0, 0, 0]\n";
    let made = Made::new("free-asymmetric", SECOND);
    let mut made =
        Quantity::ALL.into_iter().fold(made, |made, quantity| made.with_errors(quantity, &power(2.0), 0.0));
    assert_eq!(made.quantities("order").len(), 12);
    made.scene = Scene::parse(text, "point.toml").expect("a scene");
    let places =
        ["position-end", "position-max", "velocity-end", "velocity-max", "body-point-end", "body-point-max"];
    assert_eq!(made.quantities("order"), places);
}

#[test]
fn without_torque_the_order_is_that_claimed_for_it() {
    const CLAIMS: &[Claim] = &[Claim::Order(2), Claim::OrderWithoutTorque(4)];
    for (scene, order) in [("free-asymmetric", 4.0), ("kovalevskaya", 2.0)] {
        for slope in [2.0, 4.0] {
            let made = Made::new(scene, CLAIMS).with_errors(Quantity::Position, &power(slope), 0.0);
            assert_eq!(made.ruling("order", "position-end") == Pass, slope == order, "{scene}, {slope}");
        }
    }
}

fn recorded(quantity: &str, constant: Option<f64>) -> Baseline {
    let (scene, scheme) = ("kovalevskaya".to_owned(), "made-up".to_owned());
    let order = Order { scene, scheme, quantity: quantity.to_owned(), constant, ..Order::default() };
    Baseline::from_records(&Records { orders: vec![order], ..Records::default() })
}

#[test]
fn a_constant_on_record_excuses_no_slope() {
    let mut made = Made::new("kovalevskaya", SECOND).with_errors(Quantity::Position, &power(3.0), 0.0);
    let constant = made.evidence.ladders[0].constant;
    assert!(constant.is_some());
    made.baseline = recorded("position-end", constant);
    assert_eq!([made.ruling("constant", "position-end"), made.ruling("order", "position-end")], [Pass, Fail]);
}

#[test]
fn a_constant_is_that_on_record_to_five_percent() {
    let at = |constant: f64| {
        let mut made = Made::new("kovalevskaya", SECOND).with_errors(Quantity::Position, &power(2.0), 0.0);
        made.evidence.ladders.iter_mut().for_each(|ladder| ladder.constant = Some(constant));
        made.baseline = recorded("position-end", Some(4.0));
        assert_eq!(made.quantities("constant"), ["position-end"]);
        made.verdict("constant", "position-end")
    };
    assert_eq!([at(4.0), at(4.0 * 1.049), at(4.0 * 0.951)].map(|v| v.verdict), [Pass; 3]);
    assert_eq!([at(4.0 * 1.051), at(4.0 * 0.949), at(f64::NAN), at(-4.0)].map(|v| v.verdict), [Fail; 4]);
    assert_eq!(numbers(&at(5.0)), [Some(5.0), Some(4.0 * 0.95), Some(4.0 * 1.05)]);
    assert!(at(5.0).detail.contains("ratio 1.2500"), "{}", at(5.0).detail);
}

#[test]
fn a_record_is_of_one_scene_one_scheme_and_one_quantity() {
    let baseline = recorded("position-end", Some(4.0));
    assert_eq!(baseline.constant("kovalevskaya", "made-up", "position-end"), Some(4.0));
    for (scene, scheme, quantity) in [
        ("free-asymmetric", "made-up", "position-end"),
        ("kovalevskaya", "euler", "position-end"),
        ("kovalevskaya", "made-up", "position-max"),
    ] {
        assert_eq!(baseline.constant(scene, scheme, quantity), None);
    }
    assert_eq!(recorded("position-end", None).constant("kovalevskaya", "made-up", "position-end"), None);
    assert!(Baseline::built_in().constant("kovalevskaya", "peskin-rk2", "body-point-end").is_some());
}

#[test]
fn a_constant_that_is_gone_fails_where_an_error_vanished_that_the_record_makes_large() {
    // On record an error of 4 h²; of the rungs one is looked at, at h = ½.
    let at = |error: f64, floor: f64| {
        let mut made = Made::new("kovalevskaya", SECOND);
        let quantity = Quantity::Position;
        let rungs = vec![(0.5, error, floor)];
        let ladder =
            QuantityLadder { quantity, place: Place::End, rungs, ladder: Ladder::Exact, constant: None };
        made.evidence.ladders = vec![ladder];
        made.baseline = recorded("position-end", Some(4.0));
        made.ruling("constant", "position-end")
    };
    let floor = 1e-3;
    assert_eq!([at(floor * 0.999, floor), at(0.0, floor)], [Inconclusive; 2]);
    let floor = floor.next_down();
    assert_eq!([at(floor, floor), at(0.0, floor), at(floor.next_up(), floor)], [Fail, Fail, Inconclusive]);
}
