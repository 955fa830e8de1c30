//! Quantiles, intervals and windows at their bounds, and numbers that are known in closed form.

use super::*;

fn ladder(error: impl Fn(f64) -> f64, floor: f64) -> Vec<(f64, f64, f64)> {
    (0..10).map(|k| 0.5f64.powi(k)).map(|h| (h, error(h), floor)).collect()
}

#[test]
fn quantiles_of_student_are_those_of_the_tables() {
    // The incomplete beta function, inverted to 30 digits. The expansion leaves out its next term, 1.6/ν⁴, and further ones.
    let known = [
        (11, 2.200_985_160),
        (12, 2.178_812_830),
        (15, 2.131_449_546),
        (20, 2.085_963_447),
        (30, 2.042_272_456),
        (60, 2.000_297_822),
        (120, 1.979_930_405),
    ];
    for (freedom, quantile) in known {
        let apart = student(freedom) - quantile;
        let bound = 1.8 / (freedom as f64).powi(4) + 1e-9;
        assert!(apart.abs() < bound, "{freedom}: {apart:e}");
    }
    assert_eq!([student(1), student(2), student(10)], [12.706, 4.303, 2.228]);
}

#[test]
fn an_interval_is_students_quantile_times_the_residuals_over_the_spread() {
    // ln e is off by d, −2 d and d: the slope stays, and the residuals are 6 d² with one degree of freedom.
    let d = 0.01;
    let ladder =
        [(1.0, d), (0.0, -2.0 * d), (-1.0, d)].map(|(x, off): (f64, f64)| (x.exp(), (2.0 * x + off).exp()));
    let fit = fit_power(&ladder).expect("three rungs");
    let width = 12.706 * 6f64.sqrt() * d / 2f64.sqrt();
    for (found, expected) in [(fit.slope, 2.0), (fit.low, 2.0 - width), (fit.high, 2.0 + width)] {
        assert!((found - expected).abs() < 1e-13, "{fit:?}");
    }
}

#[test]
fn a_fit_needs_three_rungs_of_numbers_that_have_a_logarithm() {
    let good = [(1.0, 1.0), (0.5, 0.25), (0.25, 0.0625)];
    assert!(fit_power(&good).is_some() && fit_power(&good[..2]).is_none());
    for place in 0..3 {
        for bad in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            let (mut steps, mut errors) = (good, good);
            (steps[place].0, errors[place].1) = (bad, bad);
            assert_eq!((fit_power(&steps), fit_power(&errors)), (None, None), "{bad} at {place}");
        }
    }
}

fn window(rungs: &[(f64, f64, f64)]) -> std::ops::Range<usize> {
    match find_window(rungs) {
        Ladder::Window { rungs, .. } => rungs,
        other => panic!("no window: {other:?}"),
    }
}

#[test]
fn a_window_is_the_six_finest_rungs_of_the_longest_run_that_stands_clear() {
    let whole = ladder(|h| 10.0 * h * h, 0.0);
    assert_eq!(window(&whole), 4..10);
    let mut five = whole[..5].to_vec();
    // Ten times the floor does not stand clear of it.
    five[4].2 = five[4].1 / 10.0;
    assert_eq!(five[4].1, 10.0 * five[4].2);
    assert_eq!(window(&five), 0..4);
    let mut runs = whole[..8].to_vec();
    (runs[0].1, runs[2].1) = (f64::INFINITY, 0.0);
    assert_eq!(window(&runs), 3..8);
    assert_eq!(find_window(&runs[..6]), Ladder::TooFew { clear: 3 });
    let mut three = whole[..4].to_vec();
    three[0].1 = f64::INFINITY;
    assert_eq!(find_window(&three), Ladder::TooFew { clear: 3 });
}

#[test]
fn slopes_of_a_window_agree_to_0_15_at_any_ratio_of_steps() {
    for ratio in [2.0f64, 10.0] {
        for (apart, settled) in [(0.14, true), (0.16, false)] {
            let (mut error, mut rungs) = (1.0, Vec::new());
            for k in 0..6 {
                rungs.push((ratio.powi(-k), error, 0.0));
                error *= ratio.powf(-2.0 - if k % 2 == 0 { apart } else { 0.0 });
            }
            let found = find_window(&rungs);
            assert_eq!(matches!(found, Ladder::Window { .. }), settled, "{ratio}, {apart}: {found:?}");
            assert_eq!(found == Ladder::Unsettled, !settled);
        }
    }
}

#[test]
fn only_rungs_below_a_hundred_floors_may_bend() {
    // Second order, and first in the last two rungs, where errors are 4.9e-4 and 2.4e-4.
    let bent = |floor: f64| -> Vec<_> {
        let error = |k: i32| if k < 6 { 0.25f64.powi(k) } else { 0.25f64.powi(5) * 0.5f64.powi(k - 5) };
        (0..8).map(|k| (0.5f64.powi(k), error(k), floor)).collect()
    };
    assert_eq!(window(&bent(8e-6)), 0..6);
    assert_eq!([find_window(&bent(2e-6)), find_window(&bent(0.0))], [Ladder::Unsettled, Ladder::Unsettled]);
}

#[test]
fn scatter_is_the_lower_quartile_of_the_changes_of_slope_over_what_noise_makes_of_them() {
    let off = |rungs: &[(f64, f64)]| -> Vec<(f64, f64)> {
        rungs.iter().map(|(h, off)| (*h, h * h * off.exp())).collect()
    };
    let (a, b) = (2f64.ln(), 4f64.ln());
    let one = scatter(&off(&[(8.0, 0.03), (4.0, -0.05), (1.0, 0.02)]));
    let unit = (1.0 / (a * a) + (1.0 / a + 1.0 / b) * (1.0 / a + 1.0 / b) + 1.0 / (b * b)).sqrt();
    assert!((one - 3.139 * (0.08 / a + 0.07 / b) / unit).abs() < 1e-13, "{one}");
    // Changes of 0.01 and 0.03 over √6: a quarter of the way from the one to the other.
    let two = scatter(&off(&[(8.0, 0.0), (4.0, 0.0), (2.0, 0.01), (1.0, 0.05)]));
    assert!((two - 3.139 * 0.015 / 6f64.sqrt()).abs() < 1e-13, "{two}");
    assert_eq!(scatter(&off(&[(8.0, 0.0), (4.0, 1.0)])), 0.0);
}

#[test]
fn a_misfit_depends_neither_on_the_unit_of_the_step_nor_on_how_often_a_rung_is_told() {
    let rungs: Vec<_> =
        (0..6).map(|k| (0.5f64.powi(k), 0.5f64.powi(k) * (1.0 + 0.1 * f64::from(k % 2)), 0.0)).collect();
    let found = misfit(&rungs, 1).expect("a term of first order");
    let scaled = |unit: f64| rungs.iter().map(|(h, e, off)| (unit * h, *e, *off)).collect::<Vec<_>>();
    // In the far unit the fourth power of a step that is not taken over the coarsest one underflows.
    for other in [scaled(1e3), scaled(1e-90), [rungs.clone(), rungs.clone()].concat()] {
        let other = misfit(&other, 1).expect("a term of first order");
        assert!(found > 1.0 && (other / found - 1.0).abs() < 1e-9, "{found} {other}");
    }
}

#[test]
fn the_secular_rate_of_a_parabola_is_its_slope_in_the_middle() {
    let time: Vec<f64> = (0..16).map(f64::from).collect();
    let value: Vec<f64> = time.iter().map(|t| t * t).collect();
    let rate = secular_rate(&time, &value).expect("enough samples");
    assert!((rate - 15.0).abs() < 1e-12, "{rate}");
}
