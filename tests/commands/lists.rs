//! `polhode list forces` from outside.

use polhode::simulate::Contestant;

use crate::common::program::{code, polhode, scratch, stderr, stdout};

#[test]
fn a_list_for_programs_has_the_rows_of_the_list_for_people() {
    for what in ["schemes", "scenes", "metrics", "claims"] {
        let rows: Vec<serde_json::Value> =
            serde_json::from_str(&stdout(&polhode(&["list", what, "--format", "json"]))).expect("JSON");
        let lines = stdout(&polhode(&["list", what])).lines().take_while(|line| !line.is_empty()).count();
        assert_eq!(rows.len(), lines - 1, "{what}");
        assert!(rows.iter().all(|row| row.as_object().is_some_and(|row| row.len() >= 3)), "{what}");
    }
    assert_eq!(code(&polhode(&["list", "schemes", "euler", "--format", "json"])), 64);
}

#[test]
fn every_rule_is_explained_by_its_name() {
    for claim in polhode::record::ClaimName::ALL {
        let output = polhode(&["list", "claims", claim.word()]);
        assert_eq!(code(&output), 0);
        let text = stdout(&output);
        let line = text.lines().next().expect("a line");
        assert!(line.starts_with(&format!("{claim}: ")) && line.ends_with('.'), "{text}");
    }
}

#[test]
fn schemes_scenes_metrics_and_claims_are_a_line_each_of_100_columns() {
    for (what, least) in
        [("schemes", Contestant::everyone().len()), ("scenes", 50), ("metrics", 6), ("claims", 200)]
    {
        let list = polhode(&["list", what]);
        assert_eq!(code(&list), 0, "{}", stderr(&list));
        let text = stdout(&list);
        let rows: Vec<&str> = text.lines().take_while(|line| !line.is_empty()).collect();
        assert!(rows.len() > least, "{what}: {}", rows.len());
        assert!(rows.iter().all(|row| row.chars().count() <= 100), "{text}");
    }
    let schemes = stdout(&polhode(&["list", "schemes"]));
    let row = schemes.lines().find(|line| line.starts_with("peskin-rk2 ")).expect("a row");
    let fields: Vec<&str> = row.split_whitespace().collect();
    assert_eq!(fields[1..5], ["2", "2", "the", "note"], "{row}");
}

#[test]
fn a_name_shows_the_card() {
    let card = |arguments: &[&str]| stdout(&polhode(arguments));
    let scheme = card(&["list", "schemes", "peskin-rk2"]);
    for word in ["order 2 in every quantity", "fails where", "h·ω", "peskin2021"] {
        assert!(scheme.contains(word), "{word}: {scheme}");
    }
    let scene = card(&["list", "scenes", "tether-springs"]);
    assert!(scene.contains("spring") && scene.contains("duration     4 s"), "{scene}");
    let claim = card(&["list", "claims", "symplectic"]);
    assert!(claim.contains("moser-veselov") && !claim.contains("peskin-rk2"), "{claim}");
    assert!(card(&["list", "metrics", "orientation"]).starts_with("orientation [rad]: "));
}

#[test]
fn a_mistyped_scheme_or_scene_is_answered_with_the_three_nearest() {
    for (arguments, near) in [
        (vec!["gate", "--scheme", "peskin"], "did you mean peskin-"),
        (vec!["gate", "--scheme", "rk4-quaternon"], "did you mean rk4-quaternion, "),
        (vec!["list", "schemes", "eulr"], "did you mean euler, "),
        (vec!["run", "kovalevskaia", "--scheme", "euler", "--steps", "4"], "did you mean kovalevskaya, "),
        (vec!["advise", "zzz", "--tolerance", "1"], "did you mean "),
    ] {
        let output = polhode(&arguments);
        assert_eq!(code(&output), 64, "{arguments:?}");
        let said = stderr(&output);
        assert!(said.contains(near), "{said}");
        let names =
            said.split("did you mean ").nth(1).and_then(|rest| rest.split('?').next()).expect("names");
        assert_eq!(
            names.split(&[',', ' '][..]).filter(|word| word.contains('-') || word.len() > 2).count(),
            3,
            "{names}"
        );
        assert!(said.len() < 600, "{said}");
    }
}

#[test]
fn a_scene_is_named_by_position_or_by_option_in_every_command() {
    let folder = scratch();
    let out = folder.path().join("out").to_string_lossy().into_owned();
    for command in [
        vec!["gate", "--quiet", "--scheme", "euler"],
        vec!["compare", "euler", "peskin-rk2", "--quiet"],
        vec!["run", "--scheme", "euler", "--steps", "4"],
        vec!["advise", "--tolerance", "1e-2", "--scheme", "euler"],
        vec!["sweep", "--quiet", "--vary", "step=0.1:0.2:2", "--scheme", "euler"],
        vec!["reference", "--digits", "5"],
        vec!["expect", "--scheme", "euler", "--step", "0.01"],
        vec!["scene", "show"],
        vec!["stability", "--quiet", "--scheme", "euler", "--cells", "0", "--long", "0", "--out", &out],
    ] {
        for scene in [&["free-oblate"][..], &["--scene", "free-oblate"]] {
            let output = polhode(&[&command[..], scene].concat());
            assert_eq!(code(&output), 0, "{command:?} {scene:?}: {}", stderr(&output));
        }
    }
    assert_eq!(code(&polhode(&["run", "--scheme", "euler", "--steps", "4"])), 64);
}

#[test]
fn the_forces_are_listed_as_blocks_and_one_of_them_alone() {
    let all = polhode(&["list", "forces"]);
    assert_eq!(code(&all), 0, "{}", stderr(&all));
    let spring = polhode(&["list", "forces", "spring"]);
    assert_eq!(code(&spring), 0, "{}", stderr(&spring));
    assert!(stdout(&spring).contains("law = \"spring\"") && stdout(&all).contains(&stdout(&spring)));
    for wrong in
        [["list", "forces", "sprung"], ["list", "scenes", "kovalevskya"], ["list", "claims", "--schema"]]
    {
        assert_eq!(code(&polhode(&wrong)), 64, "{wrong:?}");
    }
}

#[test]
fn the_schema_is_json() {
    let schema = polhode(&["list", "forces", "--schema"]);
    assert_eq!(code(&schema), 0, "{}", stderr(&schema));
    let schema: serde_json::Value = serde_json::from_str(&stdout(&schema)).expect("JSON");
    assert_eq!(schema["$schema"], "http://json-schema.org/draft-07/schema#");
}
