//! A gate that is killed leaves whole rows, and goes on from there.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::common::program::{code, polhode_in, scratch, stderr};

const GATE: [&str; 8] = ["gate", "--jobs", "1", "--json", "now.json", "--scheme", "peskin-rk2", "--scheme"];
const SCENES: [&str; 7] =
    ["euler", "free-asymmetric", "kovalevskaya", "dzhanibekov", "free-oblate", "free-rod", "tether-springs"];

fn gate(folder: &Path, more: &[&str]) -> Value {
    let output = polhode_in(folder, &[&GATE[..], &SCENES, more].concat());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(!folder.join("now.json.rows").exists());
    let text = fs::read_to_string(folder.join("now.json")).expect("written");
    let mut records: Value = serde_json::from_str(&text).expect("JSON");
    (records["made_at"], records["machine"]) = (Value::Null, Value::Null);
    records
}

#[cfg(unix)]
#[test]
fn a_killed_gate_resumes_and_ends_with_the_records_of_an_unbroken_one() {
    let whole = gate(scratch().path(), &["--quiet"]);
    let folder = scratch();
    let rows = folder.path().join("now.json.rows");
    let lines = || fs::read_to_string(&rows).unwrap_or_default().matches('\n').count();
    for wanted in [2, 5, 9] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_polhode"))
            .current_dir(folder.path())
            .args([&GATE[..], &SCENES, &["--resume", "--quiet"]].concat())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program runs");
        // At a moment that the journal names, not the clock.
        while lines() < wanted && child.try_wait().expect("a status").is_none() {
            std::thread::yield_now();
        }
        let _ = child.kill();
        child.wait().expect("it ends");
        let text = fs::read_to_string(&rows).unwrap_or_default();
        let torn = if text.ends_with('\n') { 0 } else { 1 };
        let readable = text.lines().filter(|line| serde_json::from_str::<Value>(line).is_ok()).count();
        assert!(readable + torn >= text.lines().count(), "{text}");
    }
    // A line that was cut is measured again.
    let text = fs::read_to_string(&rows).expect("rows");
    fs::write(&rows, &text[..text.len() - 10]).expect("written");
    assert_eq!(gate(folder.path(), &["--resume", "--quiet"]), whole);
    // Without --resume nothing is kept.
    assert_eq!(gate(folder.path(), &["--quiet"]), whole);
}
