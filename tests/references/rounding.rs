//! The floor of rounding is measured by copies of a run. What rounding really does is seen by running the same steps in a turned
//! world: the motion is the same, every rounding is another.

use nalgebra::Vector3;
use polhode::internals::measure::{self, Climbed};
use polhode::internals::model::Change;
use polhode::internals::reference::{Reference, stored};
use polhode::internals::rotation;
use polhode::model::{PerQuantity, Quantity, difference};
use polhode::scenes::{self, Scene};
use polhode::simulate::{Contestant, Form, Plan};

use crate::common::contestant;

/// Errors below this many floors are taken for rounding.
const CLEAR: f64 = measure::CLEAR;

/// What the iteration of an implicit equation may leave, relative: copies of a run do not show it, since they leave alike.
const SOLVED_TO: f64 = 1e-12;

/// Where a force has a kink a rounding may decide on which side a step ends.
const KINK: &str = "bouncing-body";

/// A ladder whose floors are those of rounding alone: against a reference that claims to know everything.
fn ladder(scene: &Scene, contestant: &Contestant) -> Climbed {
    let stored = stored::find(&scene.name).expect("readable");
    let mut reference =
        Reference::of(&scene.system, scene.duration, 64, stored.as_ref()).expect("a reference");
    reference.uncertainty.iter_mut().for_each(|uncertainty| *uncertainty = PerQuantity::all(0.0));
    measure::climb(contestant, &scene.system, &reference, Some(2))
}

/// A run that is farther from the truth than this part of the body's size has gone another way, and so does what roundings become.
const FOLLOWS: f64 = 0.1;

/// Largest difference of the finest run from itself in two turned worlds, over its floor; by quantity. `None` where it does not follow
/// the truth.
fn of_floor(scene: &Scene, contestant: &Contestant) -> Option<PerQuantity<f64>> {
    let climbed = ladder(scene, contestant);
    let rung = climbed.rungs.iter().rev().find(|rung| rung.outcome.broken.is_none())?;
    if rung.errors[Quantity::BodyPoint].max > FOLLOWS * scene.system.body.extent() {
        return None;
    }
    let plan = Plan { step: rung.step, steps: rung.steps, every: rung.steps };
    let own = *contestant.run(&scene.system, Form::Least, &plan).states.last()?;
    let mut largest = PerQuantity::all(0.0);
    for turn in [Vector3::new(0.9, -1.3, 0.4), Vector3::new(-0.3, 1.1, 1.7)] {
        let change = Change { turn: rotation::turn(&turn), ..Change::none() };
        let other = contestant.run(&change.apply(&scene.system), Form::Least, &plan);
        let apart = difference(&scene.system.body, &change.undo(other.states.last()?), &own);
        for (quantity, apart) in apart {
            // A quantity that does not move at all has neither rounding nor a floor.
            if apart > 0.0 {
                let left = rung.outcome.solves as f64 * SOLVED_TO * climbed.ladder.sizes[quantity];
                let floor = rung.floors[quantity].end.max(left / CLEAR);
                largest[quantity] = f64::max(largest[quantity], apart / floor);
            }
        }
    }
    Some(largest)
}

#[test]
fn the_floor_of_rounding_covers_what_rounding_does_in_every_scene() {
    let (mut all, mut above, mut astray) = (Vec::new(), Vec::new(), 0);
    for scheme in ["peskin-rk2", "rk4-quaternion", "implicit-midpoint"] {
        let contestant = contestant(scheme);
        for scene in scenes::built_in() {
            if scene.only_for_stability.is_some()
                || contestant.refusal(&scene.system).is_some()
                || (scheme == "implicit-midpoint" && scene.name == KINK)
            {
                continue;
            }
            let Some(ratios) = of_floor(&scene, &contestant) else {
                println!("{scheme} does not follow the truth in {}", scene.name);
                astray += 1;
                continue;
            };
            for (quantity, ratio) in ratios {
                if ratio > CLEAR {
                    above.push(format!(
                        "{scheme} in {}: {} by {ratio:.1} floors",
                        scene.name,
                        quantity.name()
                    ));
                }
                if ratio > 0.0 {
                    all.push((ratio, scheme, scene.name.clone(), quantity.name()));
                }
            }
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.iter().take(12).for_each(|row| println!("{row:?}"));
    assert!(above.is_empty(), "{above:#?}");
    let median = all[all.len() / 2].0;
    println!("{} differences, median {median:.3} of the floor", all.len());
    // It is no floor of another order of magnitude either.
    assert!(astray <= 9, "{astray} runs of three schemes");
    assert!(all.len() > 200 && median > 0.01, "{} {median}", all.len());
}
