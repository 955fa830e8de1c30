//! Gates for a scheme of your own, in your own `cargo test`.
//!
//! ```
//! use polhode::model::{Broken, Model};
//! use polhode::schemes::{Card, Scheme, Workspace};
//!
//! /// Heun's rule: the mean of the rates at both ends.
//! struct Heun;
//!
//! impl Scheme for Heun {
//!     const CARD: Card =
//!         Card { name: "my-heun", title: "Heun's rule", family: "mine", source: "", claims: &[] };
//!     const STATES: usize = 1;
//!
//!     fn step<M: Model>(
//!         model: &M, t: f64, h: f64, from: &M::State, to: &mut M::State, work: &mut Workspace<M>,
//!     ) -> Result<(), Broken> {
//!         let [end] = work.buffers();
//!         let first = model.rates(t, from)?;
//!         model.advance(from, h, &first, end);
//!         let second = model.rates(t + h, end)?;
//!         model.advance(from, h, &(first * 0.5 + second * 0.5), to);
//!         Ok(())
//!     }
//! }
//!
//! polhode::assert_order(&Heun, 2);
//! ```
//!
//! In a test file of your crate the last line stands in a `#[test]`. It panics with every quantity whose order
//! is not the one that is asserted, and with what was measured instead.

use crate::campaign::Campaign;
use crate::claim::Claim;
use crate::gates::Baseline;
use crate::record::{Ruling, Verdict};
use crate::scenes::{Scene, SceneError};
use crate::schemes::{Scheme, TurningScheme};
use crate::simulate::Contestant;

/// Scenes that an order is asserted in: without torque, about a pivot, under forces on points, with time and
/// velocity in the forces.
pub const SCENES: [&str; 4] = ["free-asymmetric", "kovalevskaya", "tether-springs", "gravity-drag"];

/// Asserts that a scheme has an order, from above and from below, in every quantity in the scenes of [`SCENES`].
///
/// # Panics
/// It has another, none can be read, or a run breaks; the message says where and what was measured.
#[track_caller]
pub fn assert_order<S: Scheme>(_scheme: &S, order: u32) {
    assert_order_in(&Contestant::new::<S>(), order, &SCENES);
}

/// The same for a scheme in body axes.
///
/// # Panics
/// As [`assert_order`].
#[track_caller]
pub fn assert_order_in_body_axes<S: TurningScheme>(_scheme: &S, order: u32) {
    assert_order_in(&Contestant::turning::<S>(), order, &SCENES);
}

/// The same for anything that can be measured, in scenes of your own: built-in names or paths of scene files.
///
/// # Panics
/// As [`assert_order`]; or a scene cannot be read.
#[track_caller]
pub fn assert_order_in(contestant: &Contestant, order: u32, scenes: &[&str]) {
    match orders(contestant, order, scenes) {
        Err(error) => panic!("{error}"),
        Ok(verdicts) => {
            if let Some(complaint) = complaint(contestant.card.name, order, scenes, &verdicts) {
                panic!("{complaint}");
            }
        }
    }
}

/// What the order gate says, with `order` in the place of what the scheme claims of itself.
fn orders(contestant: &Contestant, order: u32, scenes: &[&str]) -> Result<Vec<Verdict>, SceneError> {
    let mut contestant = contestant.clone();
    let others = contestant.card.claims.iter().filter(|claim| matches!(claim, Claim::Exact(..)));
    contestant.card.claims = others.copied().chain([Claim::Order(order)]).collect::<Vec<_>>().leak();
    let scenes = scenes.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
    let campaign = Campaign { baseline: Baseline::default(), ..Campaign::of(scenes, vec![contestant]) };
    let judged = |verdict: &Verdict| verdict.claim == "order" || verdict.scheme == "reference";
    Ok(campaign.run().verdicts.into_iter().filter(judged).collect())
}

/// What is wrong, in words; `None` where nothing is.
fn complaint(name: &str, order: u32, scenes: &[&str], verdicts: &[Verdict]) -> Option<String> {
    let wrong: Vec<String> = verdicts
        .iter()
        .filter(|verdict| !matches!(verdict.verdict, Ruling::Pass | Ruling::NotApplicable))
        .map(|verdict| {
            format!(
                "  {}, {}: {}: {}",
                verdict.scene,
                verdict.quantity,
                verdict.verdict.word(),
                verdict.detail
            )
        })
        .collect();
    let passed = verdicts.iter().filter(|v| v.claim == "order" && v.verdict == Ruling::Pass).count();
    if !wrong.is_empty() {
        let count = passed + wrong.len();
        return Some(format!(
            "{name} is not of order {order}: {} of {count} orders\n{}",
            wrong.len(),
            wrong.join("\n")
        ));
    }
    let nothing = format!("{name}: no order could be measured in {}", scenes.join(", "));
    (passed == 0).then_some(nothing)
}
