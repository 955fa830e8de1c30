//! The built-in scenes: all are read, and start as their stored solutions do.

#![allow(clippy::excessive_precision, reason = "digits as the stored solutions print them")]

use std::path::PathBuf;

use nalgebra::Vector3;
use polhode::scenes::{FILES, built_in};

use crate::common::scene;
use crate::given::start_of;

#[test]
fn all_built_in_scenes_are_read_and_say_why() {
    let scenes = built_in();
    assert_eq!(scenes.len(), FILES.len());
    assert!(scenes.len() >= 28);
    for (scene, (name, _)) in scenes.iter().zip(FILES) {
        assert_eq!(&scene.name, name);
        assert!(scene.built_in && !scene.title.is_empty() && !scene.why.is_empty(), "{name}");
        assert!(scene.title != scene.name, "{name}");
    }
    let mut names: Vec<_> = scenes.iter().map(|scene| &scene.name).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), scenes.len());
}

#[test]
fn scenes_that_carry_no_order_give_their_reason() {
    assert!(scene("bouncing-body").not_for_order.is_some_and(|reason| reason.len() > 20));
    assert!(scene("free-asymmetric").not_for_order.is_none());
}

#[test]
fn every_built_in_scene_has_a_file_and_every_file_is_built_in() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("references/scenes");
    let mut files: Vec<String> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    files.sort();
    let mut listed: Vec<String> = FILES.iter().map(|(name, _)| format!("{name}.toml")).collect();
    listed.sort();
    assert_eq!(files, listed);
}

/// Ω and total energy at t = 0, copied from the stored reference solutions (40 digits there).
const STARTS: &[(&str, [f64; 3], f64)] = &[
    ("free-asymmetric", UNEVEN_SPIN, 2.3818927048931830723),
    ("dzhanibekov", [0.010416666666666666667, 2.0, 0.0026041666666666666667], 5.000091552734375),
    ("free-oblate", [0.44444444444444444444, 0.22222222222222222222, 0.75], 1.4027777777777777778),
    ("exact-separatrix", [0.33333333333333333333, -1.6, 0.33333333333333333333], 3.45),
    ("free-rod", [0.64646464646464646465, 0.0, 0.32323232323232323232], 1.4330808080808080808),
    ("lagrange-top-pivot-spring", [0.14285714285714285714, 0.0, 8.0], 36.008928571428571429),
    ("lagrange-top-pivot-spring-undamped", [0.14285714285714285714, 0.0, 8.0], 36.008928571428571429),
    ("lagrange-fast-top", [0.22222222222222222222, 0.11111111111111111111, 10.0], 27.069444444444444444),
    ("kovalevskaya", [0.5, 0.25, 1.5], 1.9375),
    ("gravity-drag", UNEVEN_SPIN, 282.26079895489318307),
    ("tether-springs", UNEVEN_SPIN, 10.206111454893183072),
    ("gravity-gradient", [0.33333333333333333333, 0.4, 0.5], -5.2198316477095273144),
];

/// Ω at t = 0 of the body of five unequal masses.
const UNEVEN_SPIN: [f64; 3] = [0.27913392496230336108, -0.31745081825607550556, 0.23719815433230404876];

#[test]
fn the_starts_are_those_of_the_stored_reference_solutions() {
    for (name, spin, energy) in STARTS {
        let scene = scene(name);
        let start = start_of(&scene);
        // A matrix inverse of condition below 10, and sums of fewer than 20 products: some 30 u.
        assert!((start.angular_velocity - Vector3::from(*spin)).amax() < 4e-15 * (1.0 + spin[2]), "{name}");
        let kinetic = scene.system.kinetic_energy(&start);
        // Drag has no potential; all that is left then is gravity's -M g·X = 9.5 × 9.75 × 2.
        let potential = scene.system.potential_energy(&start).unwrap_or(9.5 * 9.75 * 2.0);
        assert!(
            (kinetic + potential - energy).abs() < 1e-14 * (1.0 + energy.abs()),
            "{name}: {kinetic} {potential}"
        );
    }
    // The two without an energy: a torque and a field that depend on time.
    let field = start_of(&scene("time-dependent-field"));
    assert!((field.angular_velocity - Vector3::from(UNEVEN_SPIN)).amax() < 4e-15);
    let sciml = start_of(&scene("sciml-rigidbody-wpd"));
    assert!((sciml.angular_velocity - Vector3::new(1.0, 0.0, 0.9)).amax() < 4e-16);
}

#[test]
fn the_heavy_asymmetric_top_has_exactly_its_moments_about_the_pivot() {
    let system = scene("heavy-asymmetric-top").system;
    assert_eq!(system.body.inertia, nalgebra::Matrix3::from_diagonal(&Vector3::new(2.0, 2.5, 1.25)));
    assert_eq!(system.body.center * system.body.mass, Vector3::new(0.25, 0.0, 1.0));
    assert_eq!(system.origin(), Vector3::zeros());
    assert_eq!(system.start.angular_momentum, Vector3::new(0.5, 0.25, 3.0));
}

#[test]
fn the_sleeping_top_is_above_its_threshold_and_stands_on_the_origin() {
    let system = scene("sleeping-top").system;
    let moments = system.body.moments;
    let spin = system.start.angular_momentum.norm() / moments.z;
    let threshold = (4.0 * 0.1 * 9.81 * 0.03 * moments.x).sqrt() / moments.z;
    assert!((80.0..82.0).contains(&threshold) && spin > 1.4 * threshold, "{spin} {threshold}");
    // Two products of numbers of size 0.03, rounded to 16 digits in the file.
    assert!(system.origin().amax() < 1e-17);
}

#[test]
fn the_charged_body_is_generic() {
    let system = scene("charged-body-in-fields").system;
    let (inertia, moments) = (system.body.inertia, system.body.moments);
    assert!([(0, 1), (0, 2), (1, 2)].iter().all(|entry| inertia[*entry].abs() > 0.1), "{inertia}");
    assert!((moments.x - moments.y).abs() > 0.5 && (moments.y - moments.z).abs() > 0.5, "{moments}");
    assert!((moments.x - moments.z).abs() > 0.5);
    assert!(system.start.position.amax() > 0.25);
    assert_eq!(system.least().name(), "forced");
}
