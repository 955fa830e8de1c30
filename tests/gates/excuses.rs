//! What excuses a slope outside the band: undecided then, and never a pass.

use polhode::internals::gates::Control;
use polhode::internals::measure::regression::Fit;
use polhode::record::DriftClass as Class;
use polhode::record::Ruling::{self, Broken, Fail, Inconclusive, Pass};
use polhode::record::{ClaimName, Verdict};
use polhode::schemes::{Claim, EnergyOfFreeBody, Quantity, When};

use super::case::Made;
use super::energies::drift;
use super::orders::{SECOND, power};

/// What is said of the first of two quantities by a scheme that takes no generic scene.
fn two(first: &[f64], second: &[f64]) -> (Ruling, String) {
    let made = Made::new("kovalevskaya", SECOND);
    let mut made =
        made.with_errors(Quantity::Position, first, 1e-15).with_errors(Quantity::Velocity, second, 1e-15);
    made.control = Some(Control::default());
    let verdict = made.verdict("order", "position-end");
    (verdict.verdict, verdict.detail)
}

#[test]
fn a_slope_above_the_band_is_excused_by_another_quantity_that_shows_the_order() {
    let steep = power(3.0);
    for (other, expected, words) in [
        (power(2.0), Inconclusive, "; other quantities of the same runs show the claimed order"),
        // Slopes of 2.14 and 2.02 in turn: an interval that reaches across an end of the band.
        ([0.0, 2.14, 4.16, 6.3, 8.32, 10.46].map(|n| 0.5f64.powf(n)), Inconclusive, "show the claimed order"),
        // Neither another fault, nor slopes that have not settled, nor exactness, nor too few rungs is an excuse.
        (power(3.0), Fail, "above the band"),
        (power(1.0), Fail, "above the band"),
        ([1.0, 3.0, 1.0, 3.0, 1.0, 3.0], Fail, "above the band"),
        ([0.0; 6], Fail, "above the band"),
        ([1.0, 0.25, 0.0625, 0.0, 0.0, 0.0], Fail, "above the band"),
    ] {
        let (ruling, detail) = two(&steep, &other);
        assert!(ruling == expected && detail.contains(words), "{other:?}: {ruling:?}, {detail}");
    }
}

#[test]
fn another_quantity_is_no_excuse_where_a_generic_scene_denies_the_order_and_none_before_one_is_asked_for() {
    let ruling = |control: Option<Control>| {
        let made = Made::new("kovalevskaya", SECOND).with_errors(Quantity::Position, &power(3.0), 1e-15);
        let mut made = made.with_errors(Quantity::Velocity, &power(2.0), 1e-15);
        made.control = control;
        made.ruling("order", "position-end")
    };
    let said = |rulings: &[(&str, &str, Ruling)]| ruling(Some(control(rulings)));
    let (fails, passes) = (("order", "position-max", Fail), ("order", "velocity-max", Pass));
    let of_energy = ("energy", "rotational-energy-rate", Fail);
    assert_eq!([ruling(None), said(&[fails])], [Fail; 2]);
    // What fails and passes there says neither.
    assert_eq!([said(&[]), said(&[fails, passes]), said(&[of_energy])], [Inconclusive; 3]);
}

/// A control with these rulings on claims and quantities.
fn control(rulings: &[(&str, &str, Ruling)]) -> Control {
    let verdict = |(claim, quantity, ruling): &(&str, &str, Ruling)| Verdict {
        scene: "generic".to_owned(),
        claim: ClaimName::ALL.into_iter().find(|name| name.word() == *claim).expect("a claim"),
        quantity: (*quantity).to_owned(),
        verdict: *ruling,
        ..Verdict::default()
    };
    Control { verdicts: rulings.iter().map(verdict).collect() }
}

#[test]
fn a_slope_above_the_band_is_excused_by_a_generic_scene_where_the_claimed_order_holds() {
    let ruling = |slope: f64, rulings: &[(&str, &str, Ruling)]| {
        let mut made =
            Made::new("kovalevskaya", SECOND).with_errors(Quantity::Position, &power(slope), 1e-15);
        made.control = Some(control(rulings));
        let verdict = made.verdict("order", "position-end");
        assert_eq!(
            verdict.detail.contains("generic shows the claimed order"),
            verdict.verdict == Inconclusive
        );
        verdict.verdict
    };
    let shown = ("order", "position-max", Pass);
    assert_eq!(ruling(3.0, &[shown]), Inconclusive);
    assert_eq!(ruling(3.0, &[shown, ("order", "velocity-max", Inconclusive)]), Inconclusive);
    // What does not hold everywhere there, what only some other claim says, and nothing at all.
    for other in [Fail, Broken] {
        assert_eq!(ruling(3.0, &[shown, ("order", "velocity-max", other)]), Fail);
    }
    assert_eq!(ruling(3.0, &[("constant", "position-max", Pass)]), Fail);
    assert_eq!(ruling(3.0, &[("order", "position-max", Inconclusive)]), Fail);
    assert_eq!(ruling(3.0, &[]), Fail);
    // It says nothing of a lower whole order.
    assert_eq!(ruling(1.0, &[shown]), Fail);
}

#[test]
fn a_rate_above_its_band_is_excused_by_a_generic_body_whose_rate_has_the_claimed_order() {
    const GROWS: &[Claim] = &[Claim::Energy(EnergyOfFreeBody::GrowsSecularly { rate_order: 3 })];
    let ruling = |slope: f64, rate: f64, of_generic: Ruling| {
        let order = Some(Fit { slope, low: slope, high: slope });
        let mut made = Made::new("free-asymmetric", GROWS);
        made.drift = Some(drift(Class::Secular, order, |rung| rung.rate = rate));
        made.control = Some(control(&[("energy", "rotational-energy-rate", of_generic)]));
        made.ruling("energy", "rotational-energy-rate")
    };
    assert_eq!(
        [ruling(5.0, 1.0, Pass), ruling(5.0, 1.0, Fail), ruling(5.0, 1.0, Inconclusive)],
        [Inconclusive, Fail, Fail]
    );
    let growing = |of_generic: Ruling| {
        let mut made = Made::new("free-asymmetric", GROWS);
        made.drift = Some(drift(Class::Growing, None, |_| ()));
        made.control = Some(control(&[("energy", "rotational-energy-rate", of_generic)]));
        made.ruling("energy", "rotational-energy-rate")
    };
    assert_eq!([growing(Pass), growing(Fail)], [Inconclusive, Fail]);
    // Neither an order that is too low nor a rate of the wrong sign.
    assert_eq!([ruling(2.0, 1.0, Pass), ruling(5.0, -1.0, Pass), ruling(3.0, 1.0, Fail)], [Fail, Fail, Pass]);
}

#[test]
fn a_control_is_asked_for_where_an_order_fails_and_nowhere_else() {
    let asks = |slope: f64, other: f64| {
        let made = Made::new("kovalevskaya", SECOND).with_errors(Quantity::Position, &power(slope), 1e-15);
        let made = made.with_errors(Quantity::Velocity, &power(other), 1e-15);
        made.asks_for_control()
    };
    assert_eq!([asks(3.0, 3.0), asks(3.0, 1.0), asks(1.0, 1.0)], [true; 3]);
    assert_eq!([asks(2.0, 2.0), asks(3.0, 2.0)], [false, true]);
    // A failure of another claim asks for none, and that of a rate does.
    let counted = Made::new("free-asymmetric", &[Claim::Evaluations(3)]);
    assert!(counted.ruling("evaluations", "evaluations") == Fail && !counted.asks_for_control());
    let mut rate =
        Made::new("free-asymmetric", &[Claim::Energy(EnergyOfFreeBody::Secular { rate_order: 3 })]);
    rate.drift = Some(drift(Class::Secular, Some(Fit { slope: 5.0, low: 5.0, high: 5.0 }), |_| ()));
    assert!(rate.asks_for_control());
}

/// What is said of the first of two quantities below the band, where a generic scene shows the claimed order and where none does.
fn below(change: impl Fn(&mut Made), first: &[f64], second: &[f64]) -> [Ruling; 2] {
    [Pass, Fail].map(|of_generic| {
        let mut made = Made::new("kovalevskaya", SECOND)
            .with_errors(Quantity::Position, first, 1e-15)
            .with_errors(Quantity::Velocity, second, 1e-15);
        made.control = Some(control(&[("order", "position-max", of_generic)]));
        change(&mut made);
        let verdict = made.verdict("order", "position-end");
        let told = verdict.detail.contains("generic shows the claimed order");
        assert_eq!(told, verdict.verdict == Inconclusive, "{}", verdict.detail);
        verdict.verdict
    })
}

const UNSETTLED: [f64; 6] = [1.0, 3.0, 1.0, 3.0, 1.0, 3.0];

#[test]
fn a_slope_below_the_band_is_excused_where_half_of_the_quantities_have_not_settled() {
    assert_eq!(below(|_| (), &power(1.0), &UNSETTLED), [Inconclusive, Fail]);
    assert_eq!(below(|_| (), &power(1.0), &power(2.0)), [Fail; 2]);
    let third = |made: &mut Made| *made = made.clone().with_errors(Quantity::Orientation, &power(1.0), 1e-15);
    assert_eq!(below(third, &power(1.0), &UNSETTLED), [Fail; 2]);
    // Without a generic scene there is no excuse.
    assert_eq!(two(&power(1.0), &UNSETTLED).0, Fail);
}

#[test]
fn quantities_that_are_promised_exact_are_none_of_those_that_have_not_settled() {
    const EXACT: &[Claim] = &[
        Claim::Order(2),
        Claim::Exact(Quantity::Position, When::NoForce),
        Claim::Exact(Quantity::Velocity, When::NoForce),
    ];
    let mut made = Made::new("free-asymmetric", EXACT)
        .with_errors(Quantity::Position, &[0.0; 6], 1e-15)
        .with_errors(Quantity::Velocity, &[0.0; 6], 1e-15)
        .with_errors(Quantity::Orientation, &power(1.0), 1e-15)
        .with_errors(Quantity::AngularVelocity, &UNSETTLED, 1e-15);
    made.control = Some(control(&[("order", "orientation-max", Pass)]));
    assert_eq!(made.ruling("order", "orientation-end"), Inconclusive);
    let made = made.with_errors(Quantity::AngularMomentum, &power(1.0), 1e-15);
    assert_eq!(made.ruling("order", "orientation-end"), Fail);
}

#[test]
fn a_slope_below_the_band_is_excused_where_nobody_knows_the_motion() {
    let open = |part: f64| {
        move |made: &mut Made| {
            let open = part * made.scene.system.body.extent();
            made.evidence.rungs[5].floors[Quantity::BodyPoint].max = open;
        }
    };
    assert_eq!(below(open(0.0999), &power(1.0), &power(1.0)), [Fail; 2]);
    assert_eq!(below(open(0.1001), &power(1.0), &power(1.0)), [Inconclusive, Fail]);
}

#[test]
fn a_slope_below_the_band_is_excused_between_two_whole_orders_unless_it_falls() {
    /// Errors whose slopes, one a halving, are these.
    fn errors(slopes: [f64; 5]) -> [f64; 6] {
        let mut log = 0.0;
        std::array::from_fn(|k| {
            log -= if k == 0 { 0.0 } else { slopes[k - 1] };
            2f64.powf(log)
        })
    }
    let ruling = |slopes| below(|_| (), &errors(slopes), &power(2.0));
    for slopes in [[1.7; 5], [1.2; 5], [1.6, 1.63, 1.66, 1.69, 1.72], [1.72, 1.69, 1.66, 1.67, 1.65]] {
        assert_eq!(ruling(slopes), [Inconclusive, Fail], "{slopes:?}");
    }
    // At the order below, and below that; and where a term of a lower order takes over. A fall of less than 0.04 in all is none.
    for slopes in
        [[1.0; 5], [1.14; 5], [0.5; 5], [1.72, 1.69, 1.66, 1.63, 1.6], [1.741, 1.73, 1.72, 1.71, 1.70]]
    {
        assert_eq!(ruling(slopes), [Fail; 2], "{slopes:?}");
    }
    assert_eq!(ruling([1.71, 1.705, 1.7, 1.69, 1.68]), [Inconclusive, Fail]);
}
