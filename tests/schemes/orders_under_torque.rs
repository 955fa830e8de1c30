//! The order of every scheme of the list on generic scenes with torque: three different moments, spin off every axis.

use std::collections::BTreeMap;

use polhode::campaign::Campaign;
use polhode::gates::Baseline;
use polhode::record::{ClaimName, Records, Ruling};
use polhode::simulate::Contestant;

use crate::common::scene;

/// Positions only, positions and time, positions and velocities, a pivot, and torques without force.
const SCENES: [&str; 7] = [
    "tether-springs",
    "time-dependent-field",
    "charged-body-in-fields",
    "heavy-asymmetric-top",
    "dipole-in-field",
    "gravity-gradient",
    "satellite-gravity-gradient",
];
/// Fewest scenes where the order of everything holds.
const FEWEST: usize = 3;

fn measured() -> Records {
    let scenes = SCENES.map(scene).to_vec();
    for scene in &scenes {
        assert!(!scene.system.torque_free() && scene.not_for_order.is_none(), "{}", scene.name);
    }
    let contestants = Contestant::all();
    Campaign { baseline: Baseline::default(), ..Campaign::of(scenes, contestants) }.run()
}

#[test]
fn every_order_that_is_claimed_holds_in_every_quantity_on_three_of_seven_scenes() {
    let records = measured();
    // Scenes by scheme, with whether all orders hold.
    let mut held: BTreeMap<&str, BTreeMap<&str, bool>> = BTreeMap::new();
    for verdict in records.verdicts.iter().filter(|v| v.claim == ClaimName::Order) {
        let all = held.entry(&verdict.scheme).or_default().entry(&verdict.scene).or_insert(true);
        *all &= verdict.verdict == Ruling::Pass;
    }
    let mut without = Vec::new();
    for contestant in Contestant::all() {
        let name = contestant.card.name;
        if contestant.card.order() == 0 {
            without.push(name);
            continue;
        }
        let scenes = held.get(name).map(|scenes| scenes.values().filter(|all| **all).count());
        assert!(scenes.is_some_and(|count| count >= FEWEST), "{name}: {:?}", held.get(name));
    }
    // Without the gyroscopic term no step is small enough: there is no order to claim.
    assert_eq!(without, ["semi-implicit-euler-no-gyro"]);
}
