//! Which integrator and step `polhode inspect` reads from a model file, and what it says of them, held against runs.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::common::program::{code, json, polhode, scratch, stderr, stdout};

fn stepping(path: &Path) -> Value {
    json(&polhode(&["inspect", &path.to_string_lossy(), "--format", "json"]))["stepping"].clone()
}

fn robots(part: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references/robots").join(part)
}

#[test]
fn the_integrator_and_the_step_in_force_are_said() {
    let model = |option: &str| {
        format!(
            "<mujoco>{option}<worldbody><body><freejoint/><geom type=\"box\" size=\".1 .2 .3\"/></body></worldbody></mujoco>"
        )
    };
    for (option, integrator, step) in [
        ("", "Euler", 0.002),
        ("<option integrator=\"RK4\" timestep=\"0.01\"/>", "RK4", 0.01),
        ("<option timestep=\"0.005\"/><option integrator=\"implicitfast\"/>", "implicitfast", 0.005),
    ] {
        let folder = scratch();
        let path = folder.path().join("model.xml");
        fs::write(&path, model(option)).expect("written");
        let found = stepping(&path);
        assert!(found["integrator"].as_str().expect("a name").starts_with(integrator));
        assert_eq!((&found["step_s"], &found["step_given"]), (&step.into(), &(!option.is_empty()).into()));
        assert_eq!(found["advice"]["body"], "(body 0)");
        assert!(stdout(&polhode(&["inspect", &path.to_string_lossy()])).contains("advise: (body 0) alone"));
    }
}

/// MJCF has a default for both; URDF has neither, and SDF none without `<physics>`.
#[test]
fn files_of_every_kind_say_what_their_format_has() {
    let mut count = [0, 0];
    for entry in ["broken", "controls"].iter().flat_map(|part| fs::read_dir(robots(part)).expect("a folder"))
    {
        let path = entry.expect("an entry").path();
        let name = path.to_string_lossy().into_owned();
        if name.contains("rejected-by-mujoco") {
            continue;
        }
        let found = stepping(&path);
        let is_mjcf = name.ends_with(".mjcf.xml");
        count[usize::from(is_mjcf)] += 1;
        if is_mjcf {
            assert_eq!((&found["step_s"], &found["step_given"]), (&0.002.into(), &false.into()), "{name}");
            assert_eq!(found["nearest_scheme"], "semi-implicit-euler-explicit-gyro", "{name}");
        } else {
            assert!(found.is_null(), "{name}: {found}");
        }
    }
    assert_eq!(count, [27, 4]);
}

/// The largest error of the orientation over a run of a scene, at sixteen equal distances [rad].
fn error(folder: &Path, scene: &str, scheme: &str, steps: u64) -> f64 {
    let every = (steps / 16).to_string();
    let run = [
        "run",
        scene,
        "--scheme",
        scheme,
        "--steps",
        &steps.to_string(),
        "--every",
        &every,
        "--format",
        "csv",
    ];
    let run = polhode(&run);
    assert_eq!(code(&run), 0, "{}", stderr(&run));
    let log = folder.join("log.csv");
    fs::write(&log, &run.stdout).expect("written");
    let judged = json(&polhode(&["judge", &log.to_string_lossy(), "--scene", scene, "--format", "json"]));
    let findings = judged["logs"][0]["findings"].as_array().expect("findings");
    let orientation = findings.iter().find(|one| one["quantity"] == "orientation").expect("a finding");
    orientation["max"].as_f64().expect("a number")
}

/// Model files of three formats with a stepping of their own, and the nearest scheme of each.
fn models() -> [(&'static str, String, &'static str); 4] {
    let text = |part: &str| fs::read_to_string(robots(part)).expect("a file");
    let sdf = text("controls/poses.sdf");
    let physics = |engine: &str| {
        let open = format!(
            "<world name=\"w\"><physics type=\"{engine}\"><max_step_size>0.01</max_step_size></physics><model name"
        );
        sdf.replace("<model name", &open).replace("</model>", "</model></world>")
    };
    let option = "<option integrator=\"RK4\" timestep=\"0.02\"/><worldbody>";
    let runge_kutta = text("controls/equivalent.mjcf.xml").replacen("<worldbody>", option, 1);
    [
        ("a.xml", text("controls/compiler-changes.mjcf.xml"), "semi-implicit-euler-explicit-gyro"),
        ("b.xml", runge_kutta, "rk4-quaternion"),
        ("c.sdf", physics("dart"), "semi-implicit-euler-explicit-gyro"),
        ("d.sdf", physics("bullet"), "semi-implicit-euler-implicit-gyro"),
    ]
}

#[test]
fn what_advise_says_of_them_is_what_a_run_shows() {
    for (name, model, scheme) in models() {
        let folder = scratch();
        let (path, out) = (folder.path().join(name), folder.path().join("scenes"));
        fs::write(&path, model).expect("written");
        let inspect =
            ["inspect", &path.to_string_lossy(), "--out", &out.to_string_lossy(), "--format", "json"];
        let advice = json(&polhode(&inspect))["stepping"]["advice"].clone();
        assert_eq!(advice["scheme"], scheme, "{name}: {advice}");
        let body = advice["body"].as_str().expect("a name").to_owned();
        let mut scenes = fs::read_dir(&out).expect("a folder").map(|entry| entry.expect("an entry").path());
        let own =
            |path: &PathBuf| path.file_stem().is_some_and(|stem| stem.to_string_lossy().ends_with(&body));
        let scene = scenes.find(own).expect("the scene of the body");
        let number = |key: &str| advice[key].as_f64();
        let steps = |step: f64| (number("duration_s").expect("a time") / step).round() as u64;
        let seen = |step: f64| error(folder.path(), &scene.to_string_lossy(), scheme, steps(step));
        let said = number("orientation_error_max_rad").expect("an error");
        let found = seen(number("step_s").expect("a step"));
        // Both references are good to 1e-12 rad or so, and the scene in the file has all digits.
        assert!((said - found).abs() < 1e-9, "{name}: {said:e} and {found:e}");
        if let Some(largest) = number("largest_step_s") {
            assert!(seen(largest) <= number("tolerance_rad").expect("a limit"), "{name}");
        }
    }
}
