//! `polhode.toml` and `polhode init`.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::common::program::{code, json, polhode, polhode_in, scratch, stderr, stdout};

#[test]
fn the_schema_on_record_is_the_one_that_is_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("references/config.schema.json");
    let on_record: Value = serde_json::from_str(&fs::read_to_string(path).expect("a file")).expect("JSON");
    let printed = json(&polhode(&["init", "--schema"]));
    assert!(on_record == printed, "polhode init --schema > references/config.schema.json");
}

#[test]
fn a_file_of_settings_is_written_once_and_changes_nothing() {
    let folder = scratch();
    let init = |more: &[&str]| code(&polhode_in(folder.path(), &[&["init"], more].concat()));
    assert_eq!(init(&[]), 0);
    let path = folder.path().join("polhode.toml");
    fs::write(&path, fs::read_to_string(&path).expect("written") + "scenes = [\"free-rod\"]\n")
        .expect("written");
    assert_eq!(init(&[]), 74);
    assert!(fs::read_to_string(&path).expect("kept").contains("\nscenes = "));
    assert_eq!(init(&["--force"]), 0);
    let gate = ["gate", "--quiet", "--scheme", "euler", "free-rod"];
    assert_eq!(stdout(&polhode_in(folder.path(), &gate)), stdout(&polhode(&gate)));
}

#[test]
fn the_command_line_comes_before_the_file_and_the_file_before_the_defaults() {
    let folder = scratch();
    let settings = "schemes = [\"euler\"]\nscenes = [\"kovalevskaya\"]\n[gate]\norder = 2\n\
                    [[ladders]]\nscene = \"kovalevskaya\"\ncoarsest = 128\nfinest = 2048\n";
    fs::write(folder.path().join("polhode.toml"), settings).expect("written");
    let gate = |more: &[&str]| {
        let output = polhode_in(folder.path(), &[&["gate", "--quiet", "--json", "now.json"], more].concat());
        let text = fs::read_to_string(folder.path().join("now.json")).expect("written");
        let records: Value = serde_json::from_str(&text).expect("JSON");
        let of = |key: &str| {
            let rows = records["evidence"].as_array().expect("rows").iter();
            rows.map(|row| row[key].as_str().expect("a name").to_owned()).collect::<Vec<_>>()
        };
        let steps = records["evidence"][0]["ladder"]["rungs"]["steps"].as_array().expect("runs").iter();
        let steps = steps.map(|steps| steps.as_u64().expect("a number")).collect::<Vec<_>>();
        (code(&output), of("scheme"), of("scene"), steps)
    };
    let own = |text: &str| vec![text.to_owned()];
    let steps = vec![128, 256, 512, 1024, 2048];
    assert_eq!(gate(&[]), (1, own("euler"), own("kovalevskaya"), steps.clone()));
    assert_eq!(gate(&["--order", "1"]), (0, own("euler"), own("kovalevskaya"), steps));
    let (_, schemes, scenes, steps) = gate(&["--scheme", "peskin-rk2", "free-asymmetric"]);
    assert_eq!((schemes, scenes), (own("peskin-rk2"), own("free-asymmetric")));
    assert!(steps[0] < 128, "{steps:?}");
}

#[test]
fn every_fault_of_the_file_is_65_with_the_word_that_is_wrong() {
    let folder = scratch();
    let other = folder.path().join("other.toml");
    let faults =
        "shemes = [\"euler\"]\n\n[gate]\nordre = 2\norder = \"two\"\n[engines]\neuler = \"python3 x.py\"\n";
    fs::write(&other, faults).expect("written");
    let output = polhode_in(folder.path(), &["gate", "--config", "other.toml"]);
    assert_eq!(code(&output), 65);
    let said = stderr(&output);
    for place in ["other.toml:1:1", "other.toml:4:1", "other.toml:5:9", "other.toml:7:1"] {
        assert!(said.contains(place), "{said}");
    }
    for word in ["'shemes'", "'ordre'", "\"two\"", "'euler'"] {
        assert!(said.contains(word), "{said}");
    }
    assert_eq!(code(&polhode_in(folder.path(), &["gate", "--config", "none.toml"])), 74);
}
