//! `polhode expect`: predictions beside runs, and lines that can be pasted.

use std::fs;
use std::process::Command;

use serde_json::Value;

use crate::common::program::{code, json, polhode, scratch, stderr, stdout};

fn expected(scene: &str, scheme: &str, step: &str) -> Value {
    let output = polhode(&["expect", scene, "--scheme", scheme, "--step", step, "--format", "json"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    json(&output)
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn a_prediction_holds_in_a_run_at_its_step() {
    for (scheme, order) in [("peskin-rk2", 2), ("rk4-quaternion", 4), ("euler", 1)] {
        let answer = expected("free-asymmetric", scheme, "0.01");
        let rows = answer["expected"].as_array().expect("rows");
        let row = rows.iter().find(|row| row["quantity"] == "orientation").expect("a row");
        assert_eq!(row["order"], order);
        assert_eq!(row["constant_on_record"], true);
        let checked = answer["checked_at_s"].as_array().expect("two");
        assert!(number(&checked[0]) >= 0.01 && number(&checked[1]) <= 0.01);
        // The orientation at the end of a run at this very step against one of a hundredth of the error.
        let end = |scheme: &str, step: &str| {
            let run = ["run", "free-asymmetric", "--scheme", scheme, "--step", step, "--every", "100000000"];
            let states = json(&polhode(&run))["states"].as_array().expect("states").clone();
            let q = states[states.len() - 1]["orientation_wxyz"].as_array().expect("four").clone();
            q.iter().map(number).collect::<Vec<f64>>()
        };
        let (a, b) = (end(scheme, "0.01"), end("gauss-legendre-6", "0.002"));
        let away = |sign: f64| a.iter().zip(&b).map(|(a, b)| (a - sign * b).powi(2)).sum::<f64>().sqrt();
        // The chord of two unit quaternions is 2 sin of a quarter of the angle between the rotations.
        let angle = 4.0 * (away(1.0).min(away(-1.0)) / 2.0).asin();
        let (end, band) = (number(&row["end"]), number(&row["end_band"]));
        assert!((angle / end - 1.0).abs() <= band, "{scheme}: {angle:e} is not {end:e} within {band}");
    }
}

#[test]
fn the_python_line_is_an_assertion_that_holds_and_fails() {
    let output = polhode(&["expect", "kovalevskaya", "--scheme", "peskin-rk2", "--step", "0.01"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = stdout(&output);
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("assert ")).collect();
    assert!(!lines.is_empty());
    assert_eq!(text.lines().filter(|line| line.starts_with("assert(")).count(), lines.len());
    assert_eq!(text.lines().filter(|line| line.starts_with("assert!(")).count(), lines.len());
    let folder = scratch();
    let python = |error: f64| {
        let path = folder.path().join("test.py");
        let given = |line: &&str| format!("{} = {error}\n{line}\n", line.split(' ').nth(1).expect("a name"));
        let body: String = lines.iter().map(given).collect();
        fs::write(&path, format!("h = 0.01\n{body}")).expect("written");
        Command::new("python3").arg(&path).output().expect("python3 runs").status.success()
    };
    assert!(python(1e-12));
    assert!(!python(1e3));
}

#[test]
fn a_scene_of_ones_own_has_constants_of_the_runs_and_a_step_too_large_predicts_nothing() {
    let folder = scratch();
    let path = folder.path().join("mine.toml");
    let scene = "name = \"mine\"\nduration = 2.0\n[body]\nmass = 1.0\ninertia = [1.0, 1.5, 2.1]\n\
                 [initial]\nangular_velocity = [1.0, 0.4, 0.7]\n";
    fs::write(&path, scene).expect("written");
    let path = path.to_string_lossy();
    let answer = expected(&path, "peskin-rk2", "0.03");
    let rows = answer["expected"].as_array().expect("rows");
    assert!(rows.iter().any(|row| row["constant_on_record"] == false && row["order"] == 2), "{rows:?}");
    let step = |step: &str| code(&polhode(&["expect", &path, "--scheme", "euler", "--step", step]));
    assert_eq!((step("-1"), step("1e-9"), step("nan")), (64, 64, 64));
    // A free body's centre of mass stays where it is: nothing to predict.
    let position = ["expect", &path, "--scheme", "euler", "--step", "0.01", "--quantity", "position"];
    assert_eq!(code(&polhode(&position)), 2);
}
