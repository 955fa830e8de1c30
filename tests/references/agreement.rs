//! The sources of a reference, and what it makes of them.

use polhode::model::difference;
use polhode::reference::{Reference, Role};

use super::building::largest;
use crate::common::{scene, stored_of};

/// Every source besides the best estimate is held against it; a closed form where there is one.
#[test]
fn every_source_is_there_with_its_role_and_agrees() {
    for name in
        ["free-asymmetric", "kovalevskaya", "lagrange-fast-top", "sciml-rigidbody-wpd", "gravity-gradient"]
    {
        let scene = scene(name);
        let stored = stored_of(name);
        let reference = Reference::of(&scene.system, scene.duration, 16, Some(&stored)).expect("a reference");
        let told: Vec<_> = reference.sources.iter().map(|s| (s.name.as_str(), s.role)).collect();
        let closed = ["free-asymmetric", "lagrange-fast-top"].contains(&name);
        let last = if name == "sciml-rigidbody-wpd" { Role::Check } else { Role::Exact };
        let mut expected = vec![("taylor", Role::Best)];
        expected.extend(closed.then_some(("closed form", Role::Second)));
        expected.extend([("dop853", Role::Second), ("tsit45", Role::Second), ("stored", last)]);
        assert_eq!(told, expected, "{name}");
        for source in &reference.sources[1..] {
            let apart = largest(&source.disagreement.expect("a disagreement"));
            // Measured: 5e-12 of tsit45 on the fast top, 5e-14 and less elsewhere.
            assert!(apart < 5e-11, "{name}: {} {apart:e}", source.name);
        }
    }
}

#[test]
fn the_stored_solution_replaces_the_estimate_and_narrows_its_uncertainty() {
    for name in ["free-asymmetric", "dzhanibekov", "tether-springs", "sciml-rigidbody-wpd"] {
        let scene = scene(name);
        let stored = stored_of(name);
        let alone = Reference::of(&scene.system, scene.duration, 16, None).expect("a reference");
        let with = Reference::of(&scene.system, scene.duration, 16, Some(&stored)).expect("a reference");
        for j in 0..=16 {
            assert_eq!(with.times[j], j as f64 * scene.duration / 16.0);
            let quarter = j % 4 == 0 && j > 0 && name != "sciml-rigidbody-wpd";
            let (before, after) = (alone.uncertainty[j], with.uncertainty[j]);
            // At a stored time only the rounding of the number is left.
            let narrower = |(before, after): &(f64, f64)| *after <= before * 1.01;
            let no_narrower = |(before, after): &(f64, f64)| after >= before;
            let expected: &dyn Fn(&(f64, f64)) -> bool = if quarter { &narrower } else { &no_narrower };
            assert!(before.zip(after).values().all(expected));
            let moved = difference(&scene.system.body, &alone.states[j], &with.states[j]);
            assert!(
                moved.zip(before).values().all(|(moved, before)| *moved <= 2.0 * before),
                "{name} {j}: {moved:?}"
            );
        }
    }
}
