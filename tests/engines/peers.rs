//! Engines beside one another: copies side by side, twins found by their trajectories, and the section of the report.

use std::fs;

use polhode::record::{EngineRow, Records};
use serde_json::Value;

use crate::common::program::{code, polhode, stderr, stdout};
use crate::stage::{HELLO, Stage, example};

const SCENE: &str = "tests/engines/three-moments.toml";

/// The engine of the examples, which ignores its arguments: two names of one rule.
fn two() -> [String; 2] {
    [format!("engine:{}", example()), format!("engine:{} again", example())]
}

fn records(path: &std::path::Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).expect("written")).expect("JSON")
}

#[test]
fn several_copies_side_by_side_give_the_numbers_of_one() {
    let stage = Stage::new();
    let gate = |jobs: &str| {
        // A script that says that it was started, and becomes the engine.
        let scheme = stage.script(&format!("echo start >> \"$here/starts-{jobs}\"; exec '{}'", example()));
        let path = stage.path(&format!("{jobs}.json"));
        let name = path.to_string_lossy().into_owned();
        let scenes =
            ["free-asymmetric", "free-oblate", "mujoco-free-box", "dzhanibekov"].map(|s| ["--scene", s]);
        let arguments = ["gate", "--quiet", "--jobs", jobs, "--scheme", &scheme, "--json", &name];
        let output = polhode(&[&arguments[..], &scenes.concat()].concat());
        assert!(code(&output) <= 2, "{}", stderr(&output));
        let rows = records(&path)["measurements"].as_array().expect("rows").clone();
        let numbers = rows.into_iter().map(|mut row| {
            row["nanoseconds_per_step"] = Value::Null;
            row
        });
        (numbers.collect::<Vec<_>>(), stage.text(&format!("starts-{jobs}")).lines().count())
    };
    let ((one, started_once), (four, started)) = (gate("1"), gate("4"));
    assert_eq!(one, four);
    // One that said hello and was kept; with four threads every thread may have a copy, and more than one had.
    assert_eq!(started_once, 1);
    assert!((2..=4).contains(&started), "{started} copies");
}

#[test]
fn a_report_with_engines_has_a_section_on_them_with_versions_and_twins() {
    let stage = Stage::new();
    let [one, other] = two();
    let out = stage.path("report");
    let output = polhode(&[
        "report",
        "--quiet",
        "--scheme",
        &one,
        "--scheme",
        &other,
        "--scheme",
        "rk4-quaternion",
        "--scene",
        SCENE,
        "--out",
        &out.to_string_lossy(),
    ]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let records = records(&out.join("records.json"));
    let engine = &records["engines"][0];
    assert_eq!((&engine["name"], &engine["version"]), (&"example".into(), &"0.1".into()));
    assert_eq!((&engine["integrator"], &engine["single_precision"]), (&"RK4".into(), &false.into()));
    let steps: Vec<f64> = records["peers"]
        .as_array()
        .expect("rows")
        .iter()
        .filter(|row| row["scheme"] == one.as_str())
        .filter_map(|row| row["step_s"].as_f64())
        .collect();
    assert_eq!(steps, [0.01, 0.001]);
    let twins = records["twins"].as_array().expect("twins");
    let coarse: Vec<_> = twins.iter().filter(|twin| twin["step_s"] == 0.01).collect();
    // The classical RK4 that normalises its quaternion at the end of a step is another rule than the one that does not.
    assert_eq!(coarse.len(), 1, "{coarse:?}");
    assert_eq!((&coarse[0]["one"], &coarse[0]["other"]), (&one.as_str().into(), &other.as_str().into()));
    assert_eq!(coarse[0]["to_rounding"], true);
    let (markdown, html) = ("report.md", "pages/engines.html");
    for (file, words) in
        [(markdown, "## Engines"), (html, "they agree to rounding"), (markdown, "they agree to rounding")]
    {
        assert!(fs::read_to_string(out.join(file)).expect("written").contains(words), "{file}: {words}");
    }
    assert!(out.join("plots/engines-three-moments.png").exists());
}

#[test]
fn a_report_without_engines_says_nothing_of_them() {
    let stage = Stage::new();
    let out = stage.path("report");
    let output = polhode(&[
        "report",
        "--quiet",
        "--scheme",
        "euler",
        "--scene",
        SCENE,
        "--out",
        &out.to_string_lossy(),
    ]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(!fs::read_to_string(out.join("report.md")).expect("written").contains("## Engines"));
    assert!(!out.join("pages/engines.html").exists());
    assert!(records(&out.join("records.json"))["engines"].is_null());
}

#[test]
fn engines_are_compared_on_a_page_of_their_own() {
    let stage = Stage::new();
    let [one, _] = two();
    let out = stage.path("page");
    let folder = out.to_string_lossy();
    let compare =
        ["engine", "compare", "--quiet", "--scheme", &one, "--scheme", "peskin-rk2", "--scene", SCENE];
    let output = polhode(&[&compare[..], &["--out", &folder]].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    let page = fs::read_to_string(out.join("engines.md")).expect("written");
    for words in ["**example RK4**", "| peskin-rk2 |", "(engines-three-moments.svg)", "double"] {
        assert!(page.contains(words), "{words}: {page}");
    }
    let svg = fs::read_to_string(out.join("engines-three-moments.svg")).expect("written");
    assert!(svg.starts_with("<svg font-family=") && svg.contains("xmlns="));
    assert!(out.join("engines.json").exists());
    let none = polhode(&["engine", "compare", "--scheme", "euler", "--scene", SCENE, "--out", &folder]);
    assert_eq!(code(&none), 64);
}

#[test]
fn single_precision_is_seen_and_may_be_said() {
    // A body at rest in numbers that are f32, beside the same in numbers that are not.
    for (third, single) in [(f64::from(1.0f32 / 3.0), true), (1.0 / 3.0, false)] {
        let stage = Stage::new();
        let state = format!(
            r#"{{\"step\":'$k',\"position\":[{third},{third},{third}],\"orientation\":[1,0,0,0],\"velocity\":[0,0,0],\"angular_velocity\":[0,0,0]}}"#
        );
        let state = state.replace('\\', "");
        let script = format!(
            "{HELLO}; while read -r line; do id=$(echo \"$line\" | sed 's/.*\"id\":\\([0-9]*\\).*/\\1/')\n\
             steps=$(echo \"$line\" | sed 's/.*\"steps\":\\([0-9]*\\).*/\\1/')\n\
             every=$(echo \"$line\" | sed 's/.*\"every\":\\([0-9]*\\).*/\\1/')\n\
             list=''; k=0; while :; do list=\"$list\"'{state}'; [ $k -ge $steps ] && break; k=$((k + every))\n\
             [ $k -gt $steps ] && k=$steps; list=\"$list,\"; done\n\
             echo '{{\"id\":'$id',\"states\":['\"$list\"']}}'; done"
        );
        let scheme = stage.script(&script);
        let out = stage.path("page");
        let compare = ["engine", "compare", "--quiet", "--scheme", &scheme, "--scene", "slow-sphere"];
        let output = polhode(&[&compare[..], &["--out", &out.to_string_lossy()]].concat());
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert_eq!(records(&out.join("engines.json"))["engines"][0]["single_precision"], single, "{third}");
    }
    let stage = Stage::new();
    let said = stage.script("read -r line; echo '{\"polhode\":1,\"name\":\"x\",\"precision\":\"half\"}'");
    let output = polhode(&["gate", "--scheme", &said]);
    assert_eq!(code(&output), 69);
    assert!(stderr(&output).contains("single or double"), "{}{}", stderr(&output), stdout(&output));
}

#[test]
fn the_published_comparison_is_of_the_pinned_versions_and_finds_who_has_one_rule() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = |path: &str| fs::read_to_string(root.join(path)).expect("a file");
    let published = Records::read(&root.join("reports/published/engines.json")).expect("a records file");
    let pins =
        text("references/engines/requirements.txt") + &text("references/engines/rapier-f64/Cargo.toml");
    let how = "make it anew with tests/engines/publish";
    for engine in &published.engines {
        assert!(pins.contains(&format!("={}", engine.version)), "{}: {how}", engine.scheme);
        assert_eq!(engine.single_precision, engine.integrator.starts_with("f32"), "{}", engine.scheme);
        assert!(!engine.scheme.contains(" /"), "a path of one machine: {}", engine.scheme);
    }
    let table = text("tests/engines/expected.tsv");
    let rows = table.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).count();
    assert_eq!(published.engines.len(), rows, "{how}");
    let label = |scheme: &str| {
        published.engines.iter().find(|row| row.scheme == scheme).map_or(scheme.to_owned(), EngineRow::label)
    };
    for scene in ["three-moments", "thrown-body"] {
        let coarsest =
            published.twins.iter().filter(|t| t.scene == scene).map(|t| t.step_s).fold(0.0, f64::max);
        let one_rule = |a: &str, b: &str| {
            published.twins.iter().any(|twin| {
                let pair = [label(&twin.one), label(&twin.other)];
                let here = twin.scene == scene && twin.step_s == coarsest && twin.to_rounding;
                here && pair.contains(&a.to_owned()) && pair.contains(&b.to_owned())
            })
        };
        for (a, b) in [
            ("mujoco Euler", "bullet multi-body"),
            ("mujoco Euler", "dart semi-implicit"),
            ("mujoco implicitfast", "bullet rigid-body"),
            ("mujoco RK4", "exudyn RK44"),
            ("drake discrete", "drake semi_explicit_euler"),
            ("drake discrete", "semi-implicit-euler-explicit-gyro"),
        ] {
            assert!(one_rule(a, b), "{scene}: {a} and {b}: {how}");
        }
        for (a, b) in [("mujoco Euler", "drake discrete"), ("mujoco Euler", "mujoco implicit")] {
            assert!(!one_rule(a, b), "{scene}: {a} and {b}");
        }
    }
    assert!(
        text("reports/published/engines.md")
            .contains("**mujoco Euler = bullet multi-body = dart semi-implicit**")
    );
}
