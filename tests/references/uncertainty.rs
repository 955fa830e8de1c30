//! What a reference says of its own error holds, and is no blank cheque.

use polhode::internals::reference::stored::{self, Solution};
use polhode::internals::rotation;
use polhode::model::{PerQuantity, Quantity, Snapshot, System, difference};
use polhode::reference::{Reference, Role};
use polhode::scenes::{self, Scene};

use crate::common::stored_of;

/// Scenes with a stored solution of everything, and that.
fn known() -> impl Iterator<Item = (Scene, Vec<Snapshot>)> {
    scenes::built_in().into_iter().filter_map(|scene| {
        match stored::find(&scene.name).expect("sound")?.solution(&scene.system).expect("a solution") {
            Solution::Motion(states) => Some((scene, states)),
            Solution::Spin(_) => None,
        }
    })
}

/// Half a unit in the last place of each quantity: what any f64 is wrong by.
fn half_a_unit(system: &System, state: &Snapshot) -> PerQuantity<f64> {
    let position = rotation::length(&state.position);
    let extent = system.body.extent();
    let spin = rotation::length(&state.angular_velocity);
    let sizes = PerQuantity::from([
        position + rotation::length(&system.body.center),
        rotation::length(&state.velocity) + spin * rotation::length(&system.body.center),
        1.0,
        spin,
        rotation::length(&state.angular_momentum),
        position + extent,
    ]);
    sizes.map(|size| 0.5 * f64::EPSILON * size)
}

/// Largest error over the stated uncertainty, and largest uncertainty over the error (or half a unit), at the quarters.
fn ratios(scene: &Scene, exact: &[Snapshot], reference: &Reference) -> [(f64, Quantity); 2] {
    let samples = reference.times.len() - 1;
    let mut found = [(0.0, Quantity::Position); 2];
    for (j, exact) in (1..=4).map(|quarter| quarter * samples / 4).zip(exact) {
        let error = difference(&scene.system.body, &reference.states[j], exact);
        let floor = half_a_unit(&scene.system, exact);
        for (quantity, error) in error {
            let stated = reference.uncertainty[j][quantity];
            let known = error.max(floor[quantity]);
            if error > 0.0 && error / stated > found[0].0 {
                found[0] = (error / stated, quantity);
            }
            if known > 0.0 && stated / known > found[1].0 {
                found[1] = (stated / known, quantity);
            }
        }
    }
    found
}

#[test]
fn the_stated_uncertainty_covers_the_true_error_and_is_never_a_thousand_times_too_large() {
    let mut count = 0;
    for (scene, exact) in known() {
        let stored = stored_of(&scene.name);
        for with in [None, Some(&stored)] {
            let reference = Reference::of(&scene.system, scene.duration, 64, with).expect("a reference");
            let [(least, of), (most, too)] = ratios(&scene, &exact, &reference);
            // Measured: up to 0.24, and 8: the rounding of four units that is told over half a unit.
            assert!(least <= 1.0, "{}: {of:?}, {least}", scene.name);
            assert!(most <= 1e3, "{}: {too:?}, {most}", scene.name);
            assert_eq!(reference.sources[0].role, Role::Best);
            assert!(reference.sources.iter().all(|s| s.role != Role::Failed), "{:?}", reference.sources);
            count += 1;
        }
    }
    assert!(count >= 60, "{count}");
}

#[test]
fn the_solvers_alone_cover_their_error_too() {
    for (scene, exact) in known() {
        let reference = Reference::of_solvers(&scene.system, scene.duration, 64).expect("a reference");
        let [(least, of), (most, too)] = ratios(&scene, &exact, &reference);
        // Measured: up to 0.87, in L of dzhanibekov; 879, in the orientation of mujoco-middle-axis, and 1,225 in the velocity of
        // the top on the ground, where each touch and leave costs tsit45 more than dop853, whose spread is all that is known.
        let largest = if scene.name == "tippe-top" { 2e3 } else { 1e3 };
        assert!(least <= 1.0, "{}: {of:?}, {least}", scene.name);
        assert!(most <= largest, "{}: {too:?}, {most}", scene.name);
    }
}

/// What a gate drops is dropped for the rounding of f64, in which errors are taken, and never for what is not known of the truth.
#[test]
fn no_reference_of_a_judged_scene_is_known_less_well_than_its_numbers_are_rounded() {
    let mut count = 0;
    for scene in scenes::built_in().into_iter().filter(|scene| scene.only_for_stability.is_none()) {
        let stored = stored::find(&scene.name).expect("sound");
        let reference =
            Reference::of(&scene.system, scene.duration, 64, stored.as_ref()).expect("a reference");
        // That of a stored solution, a unit or so, counts for the times before it too.
        let units = reference.states.iter().map(|state| half_a_unit(&scene.system, state));
        let largest = units.fold(PerQuantity::all(0.0), PerQuantity::max);
        for (state, stated) in reference.states.iter().zip(&reference.uncertainty) {
            let rounding = largest.map(|x| 8.0 * x);
            for (quantity, rounding) in rounding {
                assert!(
                    stated[quantity] <= rounding * (1.0 + 1e-9),
                    "{}: {quantity:?} at {} s: {:e} > {:e}",
                    scene.name,
                    state.time,
                    stated[quantity],
                    rounding
                );
            }
        }
        count += 1;
    }
    assert!(count >= 37, "{count}");
}
