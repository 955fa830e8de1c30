//! A run that did not end goes on after an engine was changed: the rows of the engine are those of its present program.

#![cfg(target_os = "linux")]

use std::fs;

use crate::common::program::{code, polhode_in, stderr};
use crate::stage::{Stage, example};

/// Lines of a file of rows: a heading, and a row a scene and scheme.
fn lines(stage: &Stage) -> Vec<String> {
    let text = fs::read_to_string(stage.path("now.json.rows")).expect("rows");
    text.lines().map(str::to_owned).collect()
}

#[test]
fn rows_of_an_engine_that_was_changed_are_measured_anew_and_other_rows_are_kept() {
    let stage = Stage::new();
    let scheme = stage.script(&format!("exec '{}'", example()));
    // The records are written and the next file cannot be, so that the rows stay as after a kill.
    let gate = |more: &[&str]| {
        let scenes = ["free-asymmetric", "mujoco-free-box"];
        let options =
            ["--scheme", "euler", "--scheme", &scheme, "--json", "now.json", "--junit", "/dev/full"];
        let output = polhode_in(&stage.path("."), &[&["gate"], &scenes[..], &options, more].concat());
        assert_eq!(code(&output), 74, "{}", stderr(&output));
        lines(&stage)
    };
    let first = gate(&[]);
    assert_eq!(first.len(), 5);
    assert_eq!(gate(&["--resume"]), first);
    stage.script(&format!("# mended\nexec '{}'", example()));
    let second = gate(&["--resume"]);
    assert_eq!((second.len(), &second[..5]), (7, &first[..]));
    assert!(second[5..].iter().all(|line| line.contains("engine.sh")), "{second:?}");
    assert_eq!(gate(&["--resume"]), second);
}
