//! A closed form among the other sources of a reference.

use polhode::internals::reference::{Reference, Role, closed};
use polhode::model::Quantity;

use crate::common::scene;

#[test]
fn a_run_too_long_for_the_series_rests_on_its_closed_form() {
    let scene = scene("free-asymmetric");
    let reference = Reference::of(&scene.system, 16384.0, 16, None).expect("a reference");
    let told: Vec<_> = reference.sources.iter().map(|s| (s.name.as_str(), s.role)).collect();
    let expected = [
        ("closed form", Role::Best),
        ("taylor", Role::Failed),
        ("dop853", Role::Second),
        ("tsit45", Role::Second),
    ];
    assert_eq!(told, expected);
    let state = reference.states.last().expect("a state");
    assert_eq!(*state, closed::solve(&scene.system, &[16384.0]).expect("a closed form").states[0]);
    let largest = reference.largest_uncertainty()[Quantity::Orientation];
    assert!(largest > 1e-13 && largest < 1e-9, "{largest:e}");
}

/// A closed form, or a series, of another body than the other sources see.
#[test]
fn sources_that_contradict_each_other_show_in_the_uncertainty() {
    let mut system = scene("free-asymmetric").system;
    let sound = Reference::of(&system, 8.0, 16, None).expect("a reference").largest_uncertainty();
    assert!(sound[Quantity::Orientation] < 1e-14, "{sound:?}");
    system.body.moments.x *= 1.0 + 1e-6;
    let closed_is_wrong = Reference::of(&system, 8.0, 16, None).expect("a reference").largest_uncertainty();
    assert!(
        closed_is_wrong[Quantity::Orientation] > 1e-7 && closed_is_wrong[Quantity::Orientation] < 1e-4,
        "{closed_is_wrong:?}"
    );
}
