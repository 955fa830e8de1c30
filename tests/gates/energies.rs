//! The energy of a free body.

use polhode::internals::measure::{BELOW, Decision, Doubt, rate_order};
use polhode::record::ClaimName::Energy;
use polhode::record::DriftClass::{self, Bounded, Exact, Growing, Secular, Undecided};
use polhode::record::Ruling::{Fail, Inconclusive, NotApplicable, Pass};
use polhode::record::{EnergyDrift, EnergyRung, Verdict};
use polhode::schemes::{Claim, EnergyOfFreeBody};

use super::case::{Made, numbers, power, step};

const GROWS: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::GrowsSecularly { rate_order: 3 })];
const SECULAR: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 3 })];
const BOUNDED: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Bounded)];
const CONSTANT: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Constant)];
const FALLS: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::Falls)];

/// Runs of 64 s with these rates at halved steps; the second is shown.
fn drift(class: DriftClass, rates: &[f64]) -> EnergyDrift {
    let rung = |(index, rate): (usize, &f64)| EnergyRung {
        step: step(index),
        steps: 64 << index,
        rate: *rate,
        level: 0.25,
        of_largest: 0.5,
        rounding: 1e-15,
        ..EnergyRung::default()
    };
    EnergyDrift {
        rungs: rates.iter().enumerate().map(rung).collect(),
        class,
        shown: 1,
        ..EnergyDrift::default()
    }
}

fn verdict(claims: &[Claim], drift: EnergyDrift, quantity: &str) -> Verdict {
    let mut made = Made::new("free-asymmetric", claims);
    made.evidence.drift = Some(drift);
    made.verdict(Energy, quantity)
}

#[test]
fn a_class_passes_where_it_is_claimed_and_is_undecided_where_there_is_none() {
    for (class, bounded, constant) in [
        (Exact, Pass, Pass),
        (Bounded, Pass, Fail),
        (Secular, Fail, Fail),
        (Growing, Fail, Fail),
        (Undecided, Inconclusive, Inconclusive),
    ] {
        let at = |claims| verdict(claims, drift(class, &power(3.0)), "rotational-energy-drift");
        assert_eq!([at(BOUNDED).verdict, at(CONSTANT).verdict], [bounded, constant], "{class}");
        assert_eq!(numbers(&at(BOUNDED)), [Some(0.25), None, None]);
    }
}

#[test]
fn a_rate_that_no_step_is_small_enough_for_is_not_judged() {
    let at = |level: f64, rates: &[f64]| {
        let mut drift = drift(Undecided, rates);
        drift.rungs.last_mut().expect("a run").level = level;
        verdict(GROWS, drift, "rotational-energy-rate").verdict
    };
    // The energy of the finest run changes by as much as itself, and the rates fall for no order.
    let open = [1.0, 0.3, 0.9, 0.2, 0.8, 0.3];
    assert_eq!([at(1.0, &open), at(1.0f64.next_down(), &open)], [NotApplicable, Inconclusive]);
    // A promise of a bound is judged by its class.
    let mut large = drift(Secular, &power(3.0));
    large.rungs.iter_mut().for_each(|rung| rung.level = 1.0);
    assert_eq!(verdict(BOUNDED, large, "rotational-energy-drift").verdict, Fail);
}

#[test]
fn without_long_runs_nothing_is_said_of_the_energy() {
    for claims in [GROWS, SECULAR, BOUNDED, CONSTANT, FALLS] {
        assert_eq!(Made::new("free-asymmetric", claims).ruling(Energy, "rotational-energy"), NotApplicable);
    }
}

/// With one number of the last run changed.
fn changed(change: impl FnOnce(&mut EnergyRung)) -> EnergyDrift {
    let mut drift = drift(Secular, &power(3.0));
    change(drift.rungs.last_mut().expect("a run"));
    drift
}

#[test]
fn the_energy_does_not_pass_what_the_momentum_allows_but_for_rounding() {
    let at = |most| verdict(GROWS, changed(|rung| rung.of_largest = most), "rotational-energy-bound");
    assert_eq!([at(1.0).verdict, at(1.0 + 1e-15).verdict, at(1.0 + 3e-15).verdict], [Pass, Pass, Fail]);
    assert_eq!(numbers(&at(0.75)), [Some(0.75), Some(0.0), Some(1.0 + 1e-15)]);
}

#[test]
fn an_energy_that_falls_gains_at_most_ten_roundings() {
    let at = |gain| verdict(FALLS, changed(|rung| rung.gain = gain), "rotational-energy-gain");
    assert_eq!([at(0.0).verdict, at(9.99e-15).verdict, at(10.01e-15).verdict], [Pass, Pass, Fail]);
    assert_eq!(numbers(&at(0.0)), [Some(0.0), Some(0.0), Some(10.0)]);
}

#[test]
fn the_rate_has_at_least_the_claimed_order_exactly_that_in_a_generic_scene_and_its_sign() {
    for (order, sign, generic, grows, secular) in [
        (2.0, 1.0, false, Fail, Fail),
        (3.0, 1.0, false, Pass, Pass),
        (3.0, -1.0, false, Fail, Pass),
        (4.0, 1.0, false, Pass, Pass),
        (3.0, 1.0, true, Pass, Pass),
        (4.0, 1.0, true, Fail, Fail),
    ] {
        let rulings = [GROWS, SECULAR].map(|claims| {
            let mut made = Made::new("free-asymmetric", claims);
            made.evidence.setting.generic = generic;
            made.evidence.drift = Some(drift(Secular, &power(order).map(|rate| sign * rate)));
            made.ruling(Energy, "rotational-energy-rate")
        });
        assert_eq!(rulings, [grows, secular], "{order} {sign} {generic}");
    }
    let next: Vec<f64> = (0..8).map(step).map(|h| h.powi(3) * (1.0 + h)).collect();
    let shown = verdict(SECULAR, drift(Secular, &next), "rotational-energy-rate");
    let [slope, low, high] = numbers(&shown).map(|number| number.expect("a number"));
    // One component with a positive next term has its slope at a bound, to rounding.
    assert!(low < 3.0 && 3.0 < high && low < slope && slope < high + 1e-12, "{slope} [{low}, {high}]");
}

#[test]
fn a_rate_without_an_order_is_ruled_by_its_class() {
    let doubled: Vec<f64> = power(3.0).iter().zip([1.0, 2.0].repeat(4)).map(|(rate, by)| rate * by).collect();
    for (class, rates, expected) in [
        (Exact, &power(3.0)[..], NotApplicable),
        (Growing, &power(3.0), Fail),
        (Bounded, &power(3.0), Inconclusive),
        (Undecided, &power(3.0), Inconclusive),
        (Secular, &doubled, Inconclusive),
        (Secular, &power(3.0)[..3], Inconclusive),
    ] {
        let found = verdict(GROWS, drift(class, rates), "rotational-energy-rate");
        assert_eq!((found.verdict, numbers(&found)), (expected, [None; 3]), "{class}");
    }
}

#[test]
fn a_rate_counts_where_it_is_ten_times_what_it_may_be_wrong_by() {
    // The rule of orders decides on the third of four runs, whose rate is 1/64.
    let at = |uncertainty: f64, rounding: f64| {
        let mut drift = drift(Secular, &power(3.0)[..4]);
        drift.rungs.iter_mut().for_each(|rung| {
            (rung.uncertainty, rung.rounding) = (uncertainty, rounding);
        });
        rate_order(&drift)
    };
    let most = BELOW / 64.0;
    assert!(matches!(at(0.99 * most, 0.0), Decision::Order(found) if found.order == 3));
    assert_eq!(at(1.01 * most, 0.0), Decision::Undecided(Doubt::Rounding { clear: 2 }));
    // A rounding of the energy over the 64 s of a run is one of a rate.
    assert!(matches!(at(0.0, 64.0 * 0.99 * most), Decision::Order(_)));
    assert_eq!(at(0.0, 64.0 * 1.01 * most), Decision::Undecided(Doubt::Rounding { clear: 2 }));
}
