//! What excuses a slope outside the band: undecided then, and never a pass.

use polhode::claim::{Claim, Quantity};
use polhode::record::Ruling::{self, Fail, Inconclusive};

use super::case::Made;
use super::orders::{SECOND, power};

fn two(first: &[f64], second: &[f64]) -> (Ruling, String) {
    let made = Made::new("kovalevskaya", SECOND);
    let made =
        made.with_errors(Quantity::Position, first, 1e-15).with_errors(Quantity::Velocity, second, 1e-15);
    let verdict = made.verdict("order", "position-end");
    (verdict.verdict, verdict.detail)
}

#[test]
fn a_slope_above_the_band_is_excused_by_another_quantity_that_shows_the_order_or_has_not_settled() {
    let steep = power(3.0);
    for (other, expected, words) in [
        (power(2.0), Inconclusive, "show the claimed order"),
        // Slopes of 2.14 and 2.02 in turn: an interval that reaches across an end of the band.
        ([0.0, 2.14, 4.16, 6.3, 8.32, 10.46].map(|n| 0.5f64.powf(n)), Inconclusive, "show the claimed order"),
        ([1.0, 3.0, 1.0, 3.0, 1.0, 3.0], Inconclusive, "have not settled"),
        // Neither another fault, nor exactness, nor too few rungs is an excuse.
        (power(3.0), Fail, "above the band"),
        (power(1.0), Fail, "above the band"),
        ([0.0; 6], Fail, "above the band"),
        ([1.0, 0.25, 0.0625, 0.0, 0.0, 0.0], Fail, "above the band"),
    ] {
        let (ruling, detail) = two(&steep, &other);
        assert!(ruling == expected && detail.contains(words), "{other:?}: {ruling:?}, {detail}");
    }
}

#[test]
fn a_slope_that_falls_away_from_a_whole_order_is_on_its_way_and_one_that_comes_to_rest_is_not() {
    // Slopes of the runs, one a halving: near three and falling from it, near two and falling to it, and three at rest.
    let errors = |slopes: [f64; 5]| -> [f64; 6] {
        let mut log = 0.0;
        std::array::from_fn(|k| {
            log -= if k == 0 { 0.0 } else { slopes[k - 1] };
            2f64.powf(log)
        })
    };
    for (slopes, expected) in [
        ([2.95, 2.94, 2.92, 2.89, 2.85], Inconclusive),
        ([2.85, 2.89, 2.92, 2.94, 2.95], Fail),
        ([3.0, 3.0, 3.0, 3.0, 3.0], Fail),
    ] {
        let made = Made::new("kovalevskaya", &[Claim::Order(1)]);
        let verdict =
            made.with_errors(Quantity::Position, &errors(slopes), 1e-15).verdict("order", "position-end");
        assert_eq!(verdict.verdict, expected, "{slopes:?}: {}", verdict.detail);
    }
    // Nearer to the order below, a slope that falls may be about to rest there, and that order is not the claimed one.
    let made = Made::new("kovalevskaya", &[Claim::Order(1)]);
    let made = made.with_errors(Quantity::Position, &errors([2.13, 2.12, 2.1, 2.07, 2.06]), 1e-15);
    assert_eq!(made.ruling("order", "position-end"), Fail);
}

#[test]
fn a_slope_below_the_band_is_excused_only_where_half_of_the_quantities_have_not_settled() {
    let unsettled = [1.0, 3.0, 1.0, 3.0, 1.0, 3.0];
    assert_eq!(two(&power(1.0), &power(2.0)).0, Fail);
    let (ruling, detail) = two(&power(1.0), &unsettled);
    assert!(ruling == Inconclusive && detail.contains("half of the quantities"), "{detail}");
    let made = Made::new("kovalevskaya", SECOND);
    let made = made.with_errors(Quantity::Position, &power(1.0), 1e-15);
    let made = made.with_errors(Quantity::Velocity, &power(1.0), 1e-15);
    let made = made.with_errors(Quantity::Orientation, &unsettled, 1e-15);
    assert_eq!(made.ruling("order", "position-end"), Fail);
}
