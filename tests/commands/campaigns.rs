//! `gate`, `report` and `compare`: exit codes, files, interruption.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::common::program::{code, polhode, polhode_in, scratch, stderr, stdout};

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
fn a_green_gate_is_a_line_a_scheme_and_a_summary_and_a_red_one_a_line_more_a_scene() {
    let gate = |more: &[&str]| {
        let scenes = ["--scene", "kovalevskaya", "--scene", "free-oblate", "--scene", "tether-springs"];
        let output = polhode(&[&["gate", "--quiet", "--scheme", "euler"][..], &scenes, more].concat());
        (code(&output), stdout(&output))
    };
    let (green, text) = gate(&[]);
    // euler, the references, a blank line and the summary.
    assert_eq!((green, text.lines().count()), (0, 4), "{text}");
    let (red, text) = gate(&["--order", "2"]);
    let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("fail: euler in ")).collect();
    assert_eq!((red, lines.len()), (1, 3), "{text}");
    assert!(
        lines.iter().all(|line| line.contains(" off by ") && line.contains("2 claimed: order 1")),
        "{text}"
    );
}

#[test]
fn a_comparison_with_nothing_is_2_and_says_so() {
    let folder = scratch();
    let records = |scene: &str| {
        let path = folder.path().join(format!("{scene}.json")).to_string_lossy().into_owned();
        let gate = ["gate", "--quiet", "--scheme", "peskin-rk2", "--scene", scene, "--json", &path];
        assert_eq!(code(&polhode(&gate)), 0);
        path
    };
    let (own, other) = (records("kovalevskaya"), records("free-asymmetric"));
    let gate = |baseline: &str| {
        polhode(&[
            "gate",
            "--quiet",
            "--scheme",
            "peskin-rk2",
            "--scene",
            "kovalevskaya",
            "--baseline",
            baseline,
        ])
    };
    let matched = gate(&own);
    assert_eq!(code(&matched), 0, "{}", stderr(&matched));
    let said = stderr(&matched);
    let line = said.lines().find(|line| line.ends_with("constants compared")).expect("a line");
    let counts: Vec<usize> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
    assert!(counts.len() == 2 && counts[0] == counts[1] && counts[0] > 0, "{said}");
    let unmatched = gate(&other);
    assert_eq!(code(&unmatched), 2);
    assert!(stderr(&unmatched).contains("nothing was compared with the baseline"), "{}", stderr(&unmatched));
    let compared = polhode(&["compare", &own, &other]);
    assert_eq!(code(&compared), 2);
    assert!(stderr(&compared).contains("nothing was compared"), "{}", stderr(&compared));
}

#[test]
fn a_scene_in_which_nothing_moves_is_no_green_light() {
    let folder = scratch();
    let write = |name: &str, start: &str| {
        let text = format!(
            "name = \"{name}\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = [1, 2, 2.5]\n[initial]\n{start}\n"
        );
        fs::write(folder.path().join(format!("{name}.toml")), text).expect("written");
    };
    write("still", "");
    write("drifting", "velocity = [1, 0, 0]");
    write("turning", "angular_velocity = [0, 0, 1]");
    let gate = |arguments: &[&str]| {
        let output =
            polhode_in(folder.path(), &[&["gate", "--scheme", "euler", "--quiet"], arguments].concat());
        (code(&output), stderr(&output).contains("'still'"))
    };
    assert_eq!(gate(&["still.toml", "drifting.toml", "--json", "now.json"]), (2, true));
    let again = polhode_in(folder.path(), &["gate", "--from", "now.json"]);
    assert_eq!(code(&again), 2, "{}", stdout(&again));
    assert_eq!(gate(&["drifting.toml", "turning.toml"]), (0, false));
}

#[test]
fn two_scenes_of_one_name_are_bad_input() {
    let folder = scratch();
    let path = folder.path().join("mine.toml").to_string_lossy().into_owned();
    let scene = "name = \"free-rod\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = [1, 1, 1]\n";
    fs::write(&path, scene).expect("written");
    for command in [
        vec!["gate", "--scheme", "euler", "--scene", &path, "--scene", "free-rod"],
        vec!["gate", "--scheme", "euler", "free-rod", "--scene", "free-rod"],
        vec!["compare", "euler", "peskin-rk2", "free-rod", &path],
    ] {
        let output = polhode(&command);
        assert_eq!(code(&output), 65, "{command:?}: {}", stderr(&output));
        assert!(stderr(&output).contains("two scenes are called 'free-rod'"), "{}", stderr(&output));
    }
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
fn a_gate_writes_for_build_servers() {
    let folder = scratch();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let summary = path("summary.md");
    fs::write(&summary, "of an earlier command\n").expect("written");
    let files = ["junit", "markdown", "sarif", "benchmark", "bencher"];
    let gate = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
        command.args(["gate", "--quiet", "--github", "--scheme", "euler", "thin-body"]);
        for name in files {
            command.args([format!("--{name}"), path(name)]);
        }
        command.env("GITHUB_STEP_SUMMARY", &summary).output().expect("the program runs")
    };
    let output = gate();
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let text = stdout(&output);
    let annotations: Vec<&str> = text.lines().filter(|line| line.starts_with("::")).collect();
    assert_eq!(annotations.len(), 1, "{text}");
    assert!(annotations[0].starts_with("::notice file=references/scenes/thin-body.toml,line=1,"), "{text}");
    let read = |name: &str| fs::read_to_string(path(name)).expect("written");
    let parsed = |name: &str| -> Value { serde_json::from_str(&read(name)).expect("JSON") };
    assert!(read("junit").contains("<testsuite"));
    let added = fs::read_to_string(&summary).expect("a summary");
    assert!(added.starts_with("of an earlier command\n") && added.ends_with(&read("markdown")));
    let sarif = parsed("sarif");
    let run = &sarif["runs"][0];
    let rules: Vec<&Value> = run["tool"]["driver"]["rules"].as_array().expect("rules").iter().collect();
    for result in run["results"].as_array().expect("results") {
        assert!(rules.iter().any(|rule| rule["id"] == result["ruleId"]));
    }
    let rows = parsed("benchmark").as_array().expect("rows").clone();
    assert!(
        rows.iter().all(|row| row["name"].is_string() && row["unit"].is_string() && row["value"].is_f64())
    );
    let bencher = parsed("bencher");
    let measures: usize = bencher
        .as_object()
        .expect("benchmarks")
        .values()
        .map(|one| one.as_object().map_or(0, |m| m.len()))
        .sum();
    assert_eq!(measures, rows.len());
    // Its own files it replaces, another's it keeps.
    assert_eq!(code(&gate()), 0);
    for name in files {
        fs::write(path(name), "my notes").expect("written");
        assert_eq!(code(&gate()), 74, "{name}");
        fs::remove_file(path(name)).expect("removed");
    }
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

#[test]
fn a_records_file_is_drawn_again_without_a_run_and_gives_the_tables_of_a_paper() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (first, again) = (at("first"), at("again"));
    let made = ["report", "--quiet", "free-oblate", "--scheme", "euler", "--out", &first];
    assert_eq!(code(&polhode(&made)), 0);
    let records = at("first/records.json");
    let output = polhode(&["report", "--quiet", "--from", &records, "--out", &again]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for name in ["records.json", "orders.csv", "constants.csv", "drifts.csv", "plots/drift-rates.png"] {
        let read = |folder: &str| fs::read(Path::new(folder).join(name)).expect("written");
        assert!(read(&first) == read(&again), "{name}");
    }
    let tables = stdout(&polhode(&["report", "--quiet", "--from", &records, "--format", "latex"]));
    assert!(tables.contains("\\begin{tabular}") && tables.contains("euler"));
    assert_eq!(code(&polhode(&["report", "--from", &records, "--format", "word"])), 64);
    let cut = at("cut.json");
    let text = fs::read_to_string(&records).expect("written");
    fs::write(&cut, &text[..text.len() / 2]).expect("written");
    assert_eq!(code(&polhode(&["report", "--quiet", "--from", &cut, "--out", &at("none")])), 65);
    assert!(!folder.path().join("none/index.html").exists());
}

#[test]
fn a_capsule_is_replayed_to_the_bit_and_a_row_that_differs_is_1() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (out, capsule) = (at("out"), at("capsule.json"));
    let made =
        ["report", "--quiet", "free-oblate", "--scheme", "euler", "--out", &out, "--capsule", &capsule];
    assert_eq!(code(&polhode(&made)), 0);
    let replayed = polhode(&["replay", "--quiet", &capsule]);
    assert_eq!(code(&replayed), 0, "{}", stdout(&replayed));
    // The same numbers from another scheme, with hashes that belong to them: rows differ.
    let text = fs::read_to_string(&capsule).expect("written");
    let other = at("other.json");
    fs::write(&other, text.replace("\"schemes\":[\"euler\"]", "\"schemes\":[\"peskin-rk2\"]"))
        .expect("written");
    let replayed = polhode(&["replay", "--quiet", &other]);
    assert_eq!(code(&replayed), 1, "{}", stderr(&replayed));
    // A number that was edited does not have its hash.
    fs::write(
        &other,
        text.replace("free-oblate\",\"scheme\":\"euler\"", "free-oblate\",\"scheme\":\"eulers\""),
    )
    .expect("written");
    assert_eq!(code(&polhode(&["replay", "--quiet", &other])), 65);
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
    assert!(out.join("records.csv").exists() && !out.join("plots").exists(), "nothing is drawn");
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
