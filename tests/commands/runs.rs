//! Single runs and what every command does with bad input: formats, messages, exit codes.

use std::fs;
use std::process::Command;

use serde_json::Value;

use polhode::scenes;
use polhode::simulate::{Form, Plan};

use crate::common::contestant;
use crate::common::program::{code, json, polhode, scratch, stderr};

#[test]
fn a_run_prints_the_numbers_of_the_library_to_the_last_bit_in_every_scene() {
    let mut compared = 0;
    for scene in scenes::built_in().into_iter().filter(|scene| scene.only_for_stability.is_none()) {
        for (model, form) in [("least", Form::Least), ("points", Form::Points)] {
            if form == Form::Points && scene.system.body.points.is_empty() {
                continue;
            }
            let arguments = [
                "run",
                &scene.name,
                "--scheme",
                "peskin-rk2",
                "--steps",
                "64",
                "--every",
                "64",
                "--model",
                model,
            ];
            let run = json(&polhode(&arguments));
            let plan = Plan { step: scene.duration / 64.0, steps: 64, every: 64 };
            let states = contestant("peskin-rk2").run(&scene.system, form, &plan).states;
            let printed = run["states"].as_array().expect("states");
            assert_eq!(printed.len(), states.len(), "{}", scene.name);
            for (printed, state) in printed.iter().zip(&states) {
                let numbers =
                    |key: &str| -> Vec<f64> { serde_json::from_value(printed[key].clone()).expect(key) };
                let q = state.orientation.as_ref();
                assert_eq!(numbers("orientation_wxyz"), [q.w, q.i, q.j, q.k], "{} {model}", scene.name);
                assert_eq!(numbers("position_m"), state.position.as_slice(), "{} {model}", scene.name);
                assert_eq!(
                    numbers("angular_velocity_rad_s"),
                    state.angular_velocity.as_slice(),
                    "{}",
                    scene.name
                );
            }
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared}");
}

#[test]
fn a_run_names_its_precision_and_has_32_digits_in_double_double() {
    let run = |precision| {
        let output =
            polhode(&["run", "kovalevskaya", "--scheme", "euler", "--steps", "60", "--precision", precision]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.contains(&format!("\"precision\": \"{precision}\"")), "{precision}");
        text.split(&['[', ',', ']'][..]).map(|number| number.trim().len()).max().unwrap_or_default()
    };
    let [single, double, precise] = ["f32", "f64", "double-double"].map(run);
    assert!(precise > 32 && double < single + 32, "{single} {double} {precise}");
    let tiny = "name = \"tiny\"\nduration = 1e-12\nbody = { mass = 1e-26, inertia = [1e-47, 2e-47, 2.5e-47] }\n\
                initial = { angular_velocity = [1e12, 2e12, 1e12] }\n";
    let folder = scratch();
    let path = folder.path().join("tiny.toml");
    fs::write(&path, tiny).expect("a file");
    let path = path.to_str().expect("a path");
    let refused = polhode(&["run", path, "--scheme", "euler", "--steps", "4", "--precision", "f32"]);
    assert_eq!(code(&refused), 65, "{}", stderr(&refused));
    assert!(stderr(&refused).contains("leave the range of f32"), "{}", stderr(&refused));
}

#[test]
fn a_run_in_json_has_the_documented_shape() {
    let output =
        polhode(&["run", "tether-springs", "--scheme", "peskin-rk2", "--steps", "100", "--every", "30"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let run = json(&output);
    assert_eq!(run["schema"], "polhode/run/1");
    assert_eq!((&run["scene"], &run["scheme"]), (&"tether-springs".into(), &"peskin-rk2".into()));
    assert_eq!((&run["model"], &run["status"], &run["why"]), (&"forced".into(), &"ok".into(), &Value::Null));
    assert_eq!((run["steps"].as_u64(), run["force_evaluations"].as_u64()), (Some(100), Some(200)));
    assert_eq!(run["step_s"].as_f64(), Some(0.04));
    let states = run["states"].as_array().expect("states");
    let steps: Vec<u64> = states.iter().filter_map(|s| s["step"].as_u64()).collect();
    assert_eq!(steps, [0, 30, 60, 90, 100]);
    for state in states {
        for (key, length) in [
            ("position_m", 3),
            ("velocity_m_s", 3),
            ("orientation_wxyz", 4),
            ("angular_velocity_rad_s", 3),
            ("angular_momentum_kg_m2_s", 3),
        ] {
            assert_eq!(state[key].as_array().map(Vec::len), Some(length), "{key}");
        }
        assert!(state["kinetic_energy_j"].is_f64() && state["potential_energy_j"].is_f64());
    }
}

#[test]
fn a_law_without_a_potential_gives_a_null() {
    let run = json(&polhode(&["run", "gravity-drag", "--scheme", "euler", "--steps", "4"]));
    assert!(run["states"].as_array().expect("states").iter().all(|s| s["potential_energy_j"].is_null()));
}

#[test]
fn a_run_in_csv_has_a_header_and_a_row_a_state() {
    let output = polhode(&["run", "free-rod", "--scheme", "euler", "--steps", "10", "--format", "csv"]);
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(text.starts_with("step,t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz"), "{text}");
    assert_eq!(text.lines().count(), 12);
    let columns = text.lines().next().map(|line| line.split(',').count());
    assert!(text.lines().all(|line| Some(line.split(',').count()) == columns));
}

#[test]
fn a_step_that_does_not_divide_the_duration_is_taken_to_the_nearest_one_and_said() {
    // 8 s: 26 steps of 0.3077 s or 27 of 0.2963 s.
    let output = polhode(&["run", "free-asymmetric", "--scheme", "euler", "--step", "0.3"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("0.2962962962962963 s, 27 steps"), "{}", stderr(&output));
    assert_eq!(json(&output)["steps"], 27);
    let output = polhode(&["run", "free-asymmetric", "--scheme", "euler", "--step", "0.305"]);
    assert_eq!(json(&output)["steps"], 26);
    let exact = polhode(&["run", "free-asymmetric", "--scheme", "euler", "--step", "0.1"]);
    assert_eq!((stderr(&exact).as_str(), &json(&exact)["steps"]), ("", &80.into()));
    let quiet = polhode(&["run", "free-asymmetric", "--quiet", "--step", "0.3"]);
    assert_eq!((code(&quiet), stderr(&quiet).as_str()), (0, ""));
}

#[test]
fn a_run_has_a_scheme_and_a_step_where_none_is_named() {
    let output = polhode(&["run", "free-oblate"]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let run = json(&output);
    assert_eq!((&run["scheme"], &run["status"]), (&"peskin-rk2".into(), &"ok".into()));
    assert!(run["steps"].as_u64() >= Some(512));
    assert!(stderr(&output).contains("peskin-rk2 with a step of "), "{}", stderr(&output));
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_ends_a_run_silently_with_0() {
    use std::io::{BufRead, BufReader};
    use std::process::Stdio;
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["run", "free-rod", "--scheme", "euler", "--steps", "100000000", "--format", "csv"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs");
    let mut line = String::new();
    let mut reader = BufReader::new(child.stdout.take().expect("a pipe"));
    reader.read_line(&mut line).expect("a line");
    drop(reader);
    let before = std::time::Instant::now();
    let output = child.wait_with_output().expect("it ends");
    assert!(line.starts_with("step,t,x"), "{line}");
    assert_eq!((code(&output), stderr(&output).as_str()), (0, ""));
    assert!(before.elapsed() < std::time::Duration::from_secs(5), "{:?}", before.elapsed());
}

#[test]
fn wrong_usage_is_64_and_tells_what_there_is() {
    for (arguments, word) in [
        (vec!["gate", "--scheme", "peskin"], "peskin-rk2"),
        (vec!["gate", "--scene", "kovalevskaia"], "kovalevskaya"),
        (vec!["run", "free-rod", "--scheme", "euler", "--step", "-1"], "--step"),
        (vec!["run", "free-rod", "--scheme", "euler", "--step", "nan"], "--step"),
        (vec!["run", "free-rod", "--scheme", "euler", "--steps", "0"], "--steps"),
        (vec!["dance"], "dance"),
        (vec!["list", "shemes"], "schemes"),
    ] {
        let output = polhode(&arguments);
        assert_eq!(code(&output), 64, "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(word), "{arguments:?}: {}", stderr(&output));
    }
}

#[test]
fn help_is_no_failure_and_shows_examples() {
    for arguments in [
        vec!["help", "gate"],
        vec!["help", "run"],
        vec!["help", "advise"],
        vec!["help", "sweep"],
        vec!["help", "report"],
    ] {
        let output = polhode(&arguments);
        assert_eq!(code(&output), 0);
        assert!(String::from_utf8_lossy(&output.stdout).contains("Examples:"), "{arguments:?}");
    }
}

#[test]
fn bad_input_is_65_with_file_line_and_key() {
    let folder = scratch();
    let path = folder.path().join("bad.toml");
    fs::write(&path, "name = \"bad\"\nduration = 1.0\n[body]\nmass = -1.0\ninertia = [1, 1, 1]\n")
        .expect("written");
    let output = polhode(&["gate", "--scene", &path.to_string_lossy()]);
    assert_eq!(code(&output), 65);
    assert!(stderr(&output).contains("bad.toml:4: body.mass"), "{}", stderr(&output));
    let records = folder.path().join("records.json");
    fs::write(&records, "{}").expect("written");
    let output = polhode(&["gate", "--scene", "free-rod", "--baseline", &records.to_string_lossy()]);
    assert_eq!(code(&output), 65, "{}", stderr(&output));
    let output =
        polhode(&["run", "sciml-rigidbody-wpd", "--scheme", "euler", "--steps", "4", "--model", "points"]);
    assert_eq!(code(&output), 65, "{}", stderr(&output));
}

#[test]
fn files_that_cannot_be_read_or_written_are_74_and_leave_nothing_half_written() {
    let output = polhode(&["gate", "--scene", "no/such/file.toml"]);
    assert_eq!(code(&output), 74);
    let folder = scratch();
    let file = folder.path().join("file");
    fs::write(&file, "in the way").expect("written");
    let inside = file.join("report");
    let output = polhode(&["report", "--quiet", "--scene", "free-rod", "--out", &inside.to_string_lossy()]);
    assert_eq!(code(&output), 74, "{}", stderr(&output));
    let output = polhode(&[
        "run",
        "free-rod",
        "--scheme",
        "euler",
        "--steps",
        "4",
        "--out",
        &inside.to_string_lossy(),
    ]);
    assert_eq!(code(&output), 74, "{}", stderr(&output));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_74() {
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("a full device");
    let output = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["run", "free-rod", "--scheme", "euler", "--steps", "10000"])
        .stdout(full)
        .output()
        .expect("the program runs");
    assert_eq!(code(&output), 74, "{}", stderr(&output));
}

#[test]
fn a_run_that_breaks_keeps_its_states_and_says_when() {
    let folder = scratch();
    let path = folder.path().join("stiff.toml");
    let scene = "name = \"stiff\"\nduration = 1000.0\n[body]\npoints = [{ mass = 1.0, position = [0, 0, 0] }, \
                 { mass = 1.0, position = [1, 0, 0] }, { mass = 1.0, position = [0, 1, 0] }]\n[[forces]]\n\
                 law = \"spring\"\npoint = 0\nanchor = [1, 1, 1]\nstiffness = 1e6\n";
    fs::write(&path, scene).expect("written");
    let output = polhode(&["run", &path.to_string_lossy(), "--scheme", "euler", "--steps", "1000"]);
    assert_eq!(code(&output), 1);
    let run = json(&output);
    assert_eq!(run["status"], "broken");
    assert!(run["why"].as_str().expect("a reason").contains("step"));
    assert!(run["states"].as_array().is_some_and(|states| !states.is_empty()));
}
