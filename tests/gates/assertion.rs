//! `assert_order` as a user's own test would call it.

use std::panic::{AssertUnwindSafe, catch_unwind};

use polhode::model::{Broken, Model};
use polhode::schemes::{Card, Rk4Quaternion, Scheme, Step};
use polhode::simulate::Contestant;
use polhode::{assert_order_in, assert_order_in_body_axes};

/// Rates at a point of the step, held over all of it: order 2 at the middle, 1 elsewhere.
#[derive(Clone, Copy)]
struct Held<const PERCENT: u32>;

impl<const PERCENT: u32> Scheme for Held<PERCENT> {
    fn card(&self) -> Card {
        Card { name: "held", title: "Rates of one point, held", family: "test", source: "", claims: &[] }
    }

    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let part = f64::from(PERCENT) / 100.0;
        let first = model.rates(t, from)?;
        model.advance(from, h * part, &first, &mut work.states[0]);
        let held = model.rates(t + h * part, &work.states[0])?;
        model.advance(from, h, &held, to);
        Ok(())
    }
}

fn panic_of(assertion: impl FnOnce()) -> String {
    let panic = catch_unwind(AssertUnwindSafe(assertion)).expect_err("it panics");
    panic.downcast_ref::<String>().cloned().unwrap_or_default()
}

#[test]
fn an_order_that_is_so_passes() {
    polhode::assert_order(&Held::<50>, 2);
    assert_order_in_body_axes(&Rk4Quaternion, 4);
    assert_order_in(&Contestant::new(Held::<0>), 1, &["dzhanibekov", "references/scenes/kovalevskaya.toml"]);
}

#[test]
fn an_order_that_is_another_panics_with_every_scene_and_quantity_and_what_was_measured() {
    let too_high = panic_of(|| polhode::assert_order(&Held::<51>, 2));
    assert!(
        too_high.starts_with("held: order 1.00 measured, 2 claimed, in 21 of 21 quantities\n"),
        "{too_high}"
    );
    for scene in ["free-asymmetric", "kovalevskaya", "tether-springs", "gravity-drag"] {
        assert!(too_high.contains(&format!("{scene}, orientation: fail")), "{too_high}");
    }
    let too_low = panic_of(|| polhode::assert_order(&Held::<50>, 1));
    // A higher order is wrong as a whole, in the generic scenes.
    assert!(too_low.starts_with("held: order 2.00 measured, 1 claimed, in 2 of "), "{too_low}");
    for scene in ["free-asymmetric", "tether-springs"] {
        assert!(too_low.contains(&format!("{scene}, all: fail")), "{too_low}");
    }
}

#[test]
fn a_scene_that_is_not_there_or_decides_nothing_is_no_pass() {
    let contestant = Contestant::new(Held::<50>);
    assert!(panic_of(|| assert_order_in(&contestant, 2, &["no-such-scene"])).contains("no-such-scene"));
    let none = panic_of(|| assert_order_in(&contestant, 2, &["slow-sphere"]));
    assert!(none.contains("no order could be measured"), "{none}");
}
