//! The commands from outside: exit codes, formats, and what they do with bad input.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn polhode(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_polhode")).args(arguments).output().expect("the program runs")
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("an exit code")
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("JSON on stdout")
}

fn scratch() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
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
fn a_step_that_does_not_divide_the_duration_names_the_nearest_that_do() {
    let output = polhode(&["run", "free-asymmetric", "--scheme", "euler", "--step", "0.3"]);
    assert_eq!(code(&output), 64);
    let text = stderr(&output);
    assert!(
        text.contains("0.3076923076923077 (26 steps)") && text.contains("0.2962962962962963 (27 steps)"),
        "{text}"
    );
}

#[test]
fn wrong_usage_is_64_and_tells_what_there_is() {
    for (arguments, word) in [
        (vec!["gate", "--scheme", "peskin"], "peskin-rk2"),
        (vec!["gate", "--scene", "kovalevskaia"], "kovalevskaya"),
        (vec!["run", "free-rod", "--scheme", "euler"], "--step"),
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
        vec!["--help"],
        vec!["gate", "--help"],
        vec!["run", "--help"],
        vec!["advise", "--help"],
        vec!["sweep", "--help"],
        vec!["report", "--help"],
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
fn the_gate_is_0_where_all_holds_1_where_a_claim_fails_and_2_where_nothing_is_decided() {
    let gate = |arguments: &[&str]| code(&polhode(&[&["gate", "--quiet"], arguments].concat()));
    assert_eq!(gate(&["--scheme", "peskin-rk2", "--scene", "kovalevskaya"]), 0);
    let folder = scratch();
    let records = folder.path().join("records.json");
    let records = records.to_string_lossy();
    assert_eq!(gate(&["--scheme", "peskin-rk2", "--scene", "kovalevskaya", "--json", &records]), 0);
    // A baseline whose constants are a tenth of what they are: every constant fails.
    let text = fs::read_to_string(&*records).expect("written");
    let mut value: Value = serde_json::from_str(&text).expect("JSON");
    for order in value["orders"].as_array_mut().expect("orders") {
        if let Some(constant) = order["constant"].as_f64() {
            order["constant"] = (constant / 10.0).into();
        }
    }
    let worse = folder.path().join("worse.json");
    fs::write(&worse, value.to_string()).expect("written");
    let worse = worse.to_string_lossy();
    assert_eq!(gate(&["--scheme", "peskin-rk2", "--scene", "kovalevskaya", "--baseline", &worse]), 1);
    // The body falls through the centre of an attracting point: no reference, nothing decided.
    let through = folder.path().join("through.toml");
    let scene = "name = \"through\"\nduration = 4.0\n[body]\npoints = [{ mass = 1.0, position = [0, 0, 0] }]\n\
                 [initial]\nposition = [1, 0, 0]\n[[forces]]\nlaw = \"central-gravity\"\nmu = 1.0\n";
    fs::write(&through, scene).expect("written");
    assert_eq!(gate(&["--scheme", "peskin-rk2", "--scene", &through.to_string_lossy()]), 2);
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

#[test]
fn one_thread_and_two_give_the_same_numbers_to_the_last_bit() {
    let folder = scratch();
    let records = |name: &str, jobs: &str| {
        let path = folder.path().join(name);
        let path_text = path.to_string_lossy().into_owned();
        let scenes = ["--scene", "kovalevskaya", "--scene", "dzhanibekov", "--scene", "gravity-drag"];
        let output =
            polhode(&[&["gate", "--quiet", "--jobs", jobs, "--json", &path_text][..], &scenes].concat());
        assert_eq!(code(&output), 0);
        let mut value: Value =
            serde_json::from_str(&fs::read_to_string(Path::new(&path_text)).expect("written")).expect("JSON");
        value["made_at"] = Value::Null;
        value["machine"] = Value::Null;
        for row in value["measurements"].as_array_mut().expect("rows") {
            row["nanoseconds_per_step"] = Value::Null;
        }
        for row in value["scenes"].as_array_mut().expect("rows") {
            row["reduction_speedup"] = Value::Null;
        }
        value
    };
    let one = records("one.json", "1");
    assert_eq!(one, records("two.json", "2"));
    assert_eq!(one, records("again.json", "2"));
}

#[test]
fn a_gate_writes_junit_and_annotations() {
    let folder = scratch();
    let path = folder.path().join("junit.xml");
    let output = polhode(&[
        "gate",
        "--quiet",
        "--github",
        "--scheme",
        "euler",
        "--scene",
        "thin-body",
        "--junit",
        &path.to_string_lossy(),
    ]);
    assert_eq!(code(&output), 0);
    assert!(fs::read_to_string(&path).expect("written").contains("<testsuite"));
    assert!(String::from_utf8_lossy(&output.stdout).contains("::notice"));
}

#[test]
fn a_report_has_all_its_files() {
    let folder = scratch();
    let out = folder.path().join("deep/report");
    let output = polhode(&["report", "--quiet", "--scene", "free-oblate", "--out", &out.to_string_lossy()]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for name in ["index.html", "report.md", "records.json", "records.csv", "plots/overview.png"] {
        assert!(out.join(name).exists(), "{name}");
    }
    let header = fs::read_to_string(out.join("records.csv")).expect("written");
    assert!(header.starts_with("scene,scheme,model,step_s,steps,metric,value,unit,uncertainty,status,why"));
}

#[cfg(unix)]
#[test]
fn an_interrupted_report_leaves_what_was_measured_readable() {
    use std::time::Duration;
    let folder = scratch();
    let out = folder.path().join("report");
    let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(["report", "--quiet", "--out", &out.to_string_lossy()])
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the program runs");
    std::thread::sleep(Duration::from_millis(700));
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill runs");
    assert!(killed.success());
    let status = child.wait().expect("it ends");
    assert_eq!(status.code(), Some(130));
    let text = fs::read_to_string(out.join("records.json")).expect("written all the same");
    let records: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(records["complete"], false);
}

#[test]
fn a_comparison_is_1_where_the_second_is_worse_and_0_where_it_is_not() {
    let compare = |a: &str, b: &str| polhode(&["compare", a, b, "--quiet", "--scene", "kovalevskaya"]);
    assert_eq!(code(&compare("peskin-rk2", "euler")), 1);
    let output = compare("euler", "peskin-rk2");
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(String::from_utf8_lossy(&output.stdout).contains("0 worse"));
    assert_eq!(code(&compare("euler", "no-such-scheme")), 64);
    let folder = scratch();
    let records = folder.path().join("records.json");
    let records = records.to_string_lossy();
    let scene = ["--scene", "kovalevskaya", "--scheme", "peskin-rk2"];
    assert_eq!(code(&polhode(&[&["gate", "--quiet", "--json", &records], &scene[..]].concat())), 0);
    assert_eq!(code(&polhode(&["compare", &records, &records])), 0);
    assert_eq!(code(&polhode(&["compare", &records, "euler"])), 64);
}

#[test]
fn an_engine_that_cannot_be_run_is_69() {
    assert_eq!(code(&polhode(&["gate", "--scheme", "engine:true"])), 69);
}

#[test]
fn a_gate_measures_no_cost_and_a_report_does() {
    let folder = scratch();
    let path = folder.path().join("gate.json").to_string_lossy().into_owned();
    let only = ["--scheme", "peskin-rk2", "--scene", "free-asymmetric", "--quiet"];
    polhode(&[&["gate", "--json", &path][..], &only].concat());
    let out = folder.path().join("report").to_string_lossy().into_owned();
    let output = polhode(&[&["report", "--out", &out][..], &only].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let read = |path: &Path| -> Value {
        serde_json::from_str(&fs::read_to_string(path).expect("written")).expect("JSON")
    };
    let rows = |records: &Value, named: bool| {
        let rows = records["measurements"].as_array().expect("rows").clone();
        let ladder = rows.into_iter().filter(|row| row["metric"] == "orientation-end");
        ladder.filter(|row| row["nanoseconds_per_step"].is_f64() == named).count()
    };
    let gate = read(Path::new(&path));
    assert_eq!((rows(&gate, true), rows(&gate, false) > 5), (0, true));
    assert_eq!(gate["costs"].as_array().map(Vec::len), Some(0));
    let report = read(&Path::new(&out).join("records.json"));
    assert_eq!((rows(&report, true) > 5, rows(&report, false)), (true, 0));
    // The free body and its points, and the first again.
    let costs = report["costs"].as_array().expect("costs");
    assert_eq!(costs.len(), 3);
    for row in costs {
        assert_eq!(row["evaluations_per_step"].as_f64(), Some(2.0));
        assert!(row["seconds"].as_f64() >= Some(0.25) && row["nanoseconds_per_step"].as_f64() > Some(0.0));
    }
}
