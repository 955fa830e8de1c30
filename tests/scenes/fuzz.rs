//! Any text is read or refused: nothing panics, and no NaN gets through.

use polhode::scenes::Scene;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng};

use crate::common::pieces::PIECES;
use crate::given::{EVERY_LAW, HEAD, start_of};

/// Runs a property on the same cases every time.
fn always<S: Strategy>(strategy: S, cases: u32, test: impl Fn(S::Value)) {
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    let seed = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    let mut runner = proptest::test_runner::TestRunner::new_with_rng(config, seed);
    let outcome = runner.run(&strategy, |value| {
        test(value);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

/// Must return, and with finite numbers where it accepts.
fn read_anything(text: &str) {
    if let Ok(scene) = Scene::parse(text, "any.toml") {
        let start = start_of(&scene);
        assert!(scene.duration > 0.0 && scene.system.body.mass > 0.0, "{text}");
        for vector in [start.position, start.velocity, start.angular_velocity, start.angular_momentum] {
            assert!(vector.iter().all(|x| x.is_finite()), "{text}");
        }
    }
}

#[test]
fn random_text_never_panics() {
    always(any::<Vec<u8>>(), 2000, |bytes| read_anything(&String::from_utf8_lossy(&bytes)));
    always("[\\[\\]{}=.,\"'a-c0-9 \n#-]{0,60}", 4000, |text: String| read_anything(&text));
    read_anything(&format!("name = {}", "[".repeat(100_000)));
    read_anything(&format!("a{} = 1", ".a".repeat(100_000)));
}

#[test]
fn random_changes_of_a_scene_never_panic() {
    let text = EVERY_LAW.as_bytes();
    let change = (0..text.len(), 0..12usize, 0..PIECES.len());
    always(proptest::collection::vec(change, 1..4), 8000, |changes| {
        let mut changed = text.to_vec();
        for (start, length, piece) in changes {
            let start = start.min(changed.len());
            let end = (start + length).min(changed.len());
            changed.splice(start..end, PIECES[piece].bytes());
        }
        read_anything(&String::from_utf8_lossy(&changed));
    });
}

#[test]
fn numbers_of_any_size_are_read_or_refused() {
    let number =
        prop_oneof![any::<f64>(), -4.0..4.0f64, Just(0.0), (-320..308i32).prop_map(|e| 10f64.powi(e))];
    always(proptest::collection::vec(number, 12), 8000, |x| {
        let text = format!(
            "{HEAD}[body]\npoints = [ {{ mass = {:?}, position = [{:?}, {:?}, {:?}] }}, {{ mass = {:?}, position = [{:?}, {:?}, {:?}] }} ]\n[initial]\nangular_velocity = [{:?}, {:?}, {:?}]\nvelocity = [{:?}, 0, 0]\n",
            x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11]
        );
        read_anything(&text.replace("NaN", "nan"));
        let text = format!(
            "{HEAD}[body]\nmass = {:?}\ninertia = [{:?}, {:?}, {:?}]\nunphysical_inertia = true\npivot = [{:?}, {:?}, {:?}]\n[initial]\nangular_momentum = [{:?}, {:?}, {:?}]\n",
            x[0],
            x[1].abs(),
            x[2].abs(),
            x[3].abs(),
            x[4],
            x[5],
            x[6],
            x[7],
            x[8],
            x[9]
        );
        read_anything(&text.replace("NaN", "nan"));
    });
}
