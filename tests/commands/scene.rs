//! `polhode scene`, and what is said of scene files.

use std::fs;

use polhode::scenes::Scene;

use crate::common::program::{code, polhode, scratch, stderr, stdout};

#[test]
fn a_scene_is_shown_as_its_file() {
    let shown = polhode(&["scene", "show", "kovalevskaya"]);
    assert_eq!(code(&shown), 0);
    assert_eq!(stdout(&shown), include_str!("../../references/scenes/kovalevskaya.toml"));
    assert!(stderr(&shown).lines().all(|line| line.starts_with('#')) && !stderr(&shown).is_empty());
    assert!(stderr(&polhode(&["scene", "show", "kovalevskaya", "--quiet"])).is_empty());
    assert_eq!(code(&polhode(&["scene", "show", "kovalevskya"])), 64);
}

#[test]
fn a_new_scene_runs_names_its_schema_and_is_kept() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    for (name, from) in [("mine", None), ("top.toml", Some("kovalevskaya"))] {
        let path = at(name);
        let mut command = vec!["scene", "new", &path];
        command.extend(from.iter().flat_map(|from| ["--from", from]));
        let made = polhode(&command);
        assert_eq!(code(&made), 0, "{}", stderr(&made));
        let file = if name.ends_with(".toml") { path.clone() } else { format!("{path}.toml") };
        let text = fs::read_to_string(&file).expect("a file");
        let schema = text.lines().next().and_then(|line| line.strip_prefix("#:schema ./")).expect("a schema");
        assert!(folder.path().join(schema).is_file());
        assert_eq!(Scene::parse(&text, &file).expect("a scene").name, name.trim_end_matches(".toml"));
        assert_eq!(code(&polhode(&["run", &file, "--scheme", "euler", "--steps", "4"])), 0);
        fs::write(&file, "my notes").expect("written");
        assert_eq!(code(&polhode(&command)), 74);
        assert_eq!(fs::read_to_string(&file).expect("kept"), "my notes");
        command.push("--force");
        assert_eq!(code(&polhode(&command)), 0);
        assert_eq!(fs::read_to_string(&file).expect("a file"), text);
    }
    assert_eq!(code(&polhode(&["scene", "new", &at("other"), "--from", "kovalevskya"])), 64);
    assert!(!folder.path().join("other.toml").exists());
}

#[test]
fn all_faults_of_a_scene_are_said_with_file_and_line() {
    let folder = scratch();
    let file = folder.path().join("bad.toml").to_string_lossy().into_owned();
    fs::write(&file, "name = \"a\"\nduration = \"ten\"\n[body]\nmass = -1.0\ninertia = [1, 2, 2.5]\n")
        .expect("written");
    for command in [["run", file.as_str()], ["gate", file.as_str()]] {
        let refused = polhode(&command);
        assert_eq!(code(&refused), 65);
        for place in [":2:", ":4:"] {
            assert!(stderr(&refused).contains(&format!("{file}{place}")), "{}", stderr(&refused));
        }
    }
}

#[test]
fn a_step_of_more_than_a_radian_is_warned_of() {
    let lines = |steps: &str| {
        let run = polhode(&["run", "free-rod", "--scheme", "euler", "--steps", steps, "--format", "csv"]);
        assert_eq!(code(&run), 0);
        stderr(&run).lines().filter(|line| line.contains("warning")).count()
    };
    assert_eq!((lines("1"), lines("10000")), (1, 0));
}
