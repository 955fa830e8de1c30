//! The energy of a free body.

use polhode::internals::measure::regression::Fit;
use polhode::internals::measure::{BAND, EnergyDrift, EnergyRung};
use polhode::record::DriftClass as Class;
use polhode::record::Ruling::{self, Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::Verdict;
use polhode::schemes::{Claim, EnergyOfFreeBody};

use super::case::{Made, numbers};

const GROWS: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::GrowsSecularly { rate_order: 3 })];
const SECULAR: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 3 })];
const BOUNDED: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Bounded)];
const CONSTANT: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Constant)];
const FALLS: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Falls)];

/// Three runs, of which the second is shown; `change` changes that and the last.
pub fn drift(class: Class, order: Option<Fit>, change: impl Fn(&mut EnergyRung)) -> EnergyDrift {
    let mut rung = EnergyRung {
        step: 0.5,
        steps: 64,
        rate: 1e-3,
        uncertainty: 1e-5,
        level: 0.25,
        gain: 0.0,
        of_largest: 0.5,
        rounding: 1e-15,
        evaluations: 128,
    };
    let first = EnergyRung { rate: -7.0, level: 7.0, ..rung };
    change(&mut rung);
    EnergyDrift { rungs: vec![first, rung, rung], class, order, shown: 1 }
}

fn verdict(claims: &'static [Claim], drift: EnergyDrift, quantity: &str) -> Verdict {
    let mut made = Made::new("free-asymmetric", claims);
    made.drift = Some(drift);
    made.verdict("energy", quantity)
}

fn fit(low: f64, slope: f64, high: f64) -> Option<Fit> {
    Some(Fit { slope, low, high })
}

#[test]
fn a_class_passes_where_it_is_claimed_and_is_undecided_where_none_is_told() {
    let ruling =
        |claims, class| verdict(claims, drift(class, None, |_| ()), "rotational-energy-drift").verdict;
    let classes = [Class::Exact, Class::Bounded, Class::Secular, Class::Growing, Class::Undecided];
    assert_eq!(classes.map(|class| ruling(BOUNDED, class)), [Pass, Pass, Fail, Fail, Inconclusive]);
    assert_eq!(classes.map(|class| ruling(CONSTANT, class)), [Pass, Fail, Fail, Fail, Inconclusive]);
    let shown = verdict(BOUNDED, drift(Class::Bounded, None, |_| ()), "rotational-energy-drift");
    assert_eq!(numbers(&shown)[0], Some(0.25));
    assert!(shown.detail.starts_with("bounded: largest change 2.50e-1"), "{}", shown.detail);
}

#[test]
fn without_long_runs_nothing_is_said_of_the_energy() {
    for claims in [GROWS, SECULAR, BOUNDED, CONSTANT, FALLS] {
        let made = Made::new("free-asymmetric", claims);
        assert_eq!(made.ruling("energy", "rotational-energy"), NotApplicable);
    }
}

#[test]
fn the_energy_does_not_pass_what_the_momentum_allows_but_for_rounding() {
    let at = |of_largest| {
        let drift = drift(Class::Secular, fit(3.0, 3.0, 3.0), |rung| rung.of_largest = of_largest);
        verdict(GROWS, drift, "rotational-energy-bound")
    };
    assert_eq!([at(1.0).verdict, at(1.0 + 1e-15).verdict, at(1.0 + 3e-15).verdict], [Pass, Pass, Fail]);
    assert_eq!(numbers(&at(0.75)), [Some(0.75), Some(0.0), Some(1.0 + 1e-15)]);
    assert!(at(0.75).detail.contains("1 -2.50e-1"), "{}", at(0.75).detail);
}

#[test]
fn an_energy_that_falls_gains_at_most_ten_roundings() {
    let at =
        |gain| verdict(FALLS, drift(Class::Secular, None, |rung| rung.gain = gain), "rotational-energy-gain");
    assert_eq!([at(0.0).verdict, at(9.99e-15).verdict, at(10.01e-15).verdict], [Pass, Pass, Fail]);
    assert_eq!(numbers(&at(0.0)), [Some(0.0), Some(0.0), Some(10.0)]);
}

fn rate(claims: &'static [Claim], class: Class, order: Option<Fit>, rate: f64) -> Verdict {
    verdict(claims, drift(class, order, |rung| rung.rate = rate), "rotational-energy-rate")
}

#[test]
fn the_order_of_a_rate_lies_with_its_interval_in_the_band() {
    let ruling = |low, slope, high| rate(GROWS, Class::Secular, fit(low, slope, high), 1e-3).verdict;
    let (bottom, top) = (3.0 - BAND, 3.0 + BAND);
    assert_eq!(
        [
            ruling(3.0, 3.0, 3.0),
            ruling(bottom, 3.0, top),
            ruling(bottom, bottom, top),
            ruling(bottom, top, top)
        ],
        [Pass; 4]
    );
    assert_eq!([ruling(bottom.next_down(), 3.0, top), ruling(bottom, 3.0, top.next_up())], [Inconclusive; 2]);
    assert_eq!([ruling(2.0, 2.5, bottom), ruling(top, 3.5, 4.0)], [Inconclusive; 2]);
    assert_eq!([ruling(2.0, 2.5, bottom.next_down()), ruling(top.next_up(), 3.5, 4.0)], [Fail; 2]);
    let shown = rate(SECULAR, Class::Secular, fit(2.9, 3.0, 3.1), -1e-3);
    assert_eq!((shown.verdict, numbers(&shown)), (Pass, [Some(3.0), Some(2.9), Some(3.1)]));
}

#[test]
fn an_energy_that_is_claimed_to_grow_grows() {
    let ruling = |claims, value| rate(claims, Class::Secular, fit(3.0, 3.0, 3.0), value).verdict;
    assert_eq!([ruling(GROWS, 1e-3), ruling(GROWS, 0.0), ruling(GROWS, -1e-3)], [Pass, Fail, Fail]);
    assert_eq!([ruling(SECULAR, 1e-3), ruling(SECULAR, -1e-3)], [Pass; 2]);
}

#[test]
fn a_rate_without_an_order_is_ruled_by_its_class() {
    let ruling = |class, order| rate(GROWS, class, order, 1e-3).verdict;
    assert_eq!(ruling(Class::Exact, fit(3.0, 3.0, 3.0)), NotApplicable);
    assert_eq!(ruling(Class::Growing, fit(3.0, 3.0, 3.0)), Fail);
    let open: [Ruling; 3] = [
        ruling(Class::Secular, None),
        ruling(Class::Bounded, fit(3.0, 3.0, 3.0)),
        ruling(Class::Undecided, fit(3.0, 3.0, 3.0)),
    ];
    assert_eq!(open, [Inconclusive; 3]);
}

#[test]
fn what_keeps_a_rate_from_having_an_order_is_told() {
    let why = |rate: f64, uncertainty: f64| {
        let change = |rung: &mut EnergyRung| (rung.rate, rung.uncertainty) = (rate, uncertainty);
        verdict(GROWS, drift(Class::Undecided, None, change), "rotational-energy-rate").detail
    };
    // Rounding leaves 1e-15 over 64 steps of half a second, and up to ten times that says nothing.
    let floor = 1e-15 / 32.0;
    for sign in [1.0, -1.0] {
        assert!(why(sign * 10.0 * floor, 0.0).contains("rounding alone leaves 3.1e-17"));
        assert!(why(sign * 10.001 * floor, 0.0).contains("too few rates"));
        assert!(why(sign * 3e-3, 1e-3).contains("not told from zero"));
        assert!(why(sign * 3.001e-3, 1e-3).contains("too few rates"));
    }
}
