//! Ctrl-C: what was measured is written, nothing is drawn, and the exit code says that the user ended it.

#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::common::program::scratch;

/// A command on its way in a folder.
fn begun(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_polhode"))
        .current_dir(folder)
        .args(arguments)
        .arg("--quiet")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program runs")
}

/// Ends a command by Ctrl-C once something is so.
fn interrupted(mut child: Child, moment: impl Fn(u32) -> bool) -> i32 {
    while !moment(child.id()) {
        assert!(child.try_wait().expect("a status").is_none(), "it ends before");
        std::thread::yield_now();
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill runs").success());
    child.wait().expect("it ends").code().expect("an exit code")
}

/// Whether a process listens to Ctrl-C.
fn listens(process: u32) -> bool {
    const INTERRUPT: u64 = 1 << 1;
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    caught
        .and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .is_some_and(|mask| mask & INTERRUPT != 0)
}

fn lines(path: &Path) -> usize {
    fs::read_to_string(path).unwrap_or_default().matches('\n').count()
}

#[test]
fn what_was_measured_is_written_and_nothing_is_drawn() {
    for (arguments, file) in [
        (&["gate", "--scheme", "all", "--json", "now.json"][..], "now.json"),
        (&["report", "--out", "."], "records.json"),
        (&["stability", "--out", "."], "stability.json"),
    ] {
        let folder = scratch();
        let at = |name: &str| folder.path().join(name);
        let rows = at(&format!("{file}.rows"));
        let child = begun(folder.path(), arguments);
        assert_eq!(interrupted(child, |_| lines(&rows) > 3), 130, "{arguments:?}");
        let records: Value =
            serde_json::from_str(&fs::read_to_string(at(file)).expect("written")).expect("JSON");
        assert_eq!(records["complete"], false, "{arguments:?}");
        let written = ["evidence", "limits"].map(|key| records[key].as_array().map_or(0, Vec::len));
        assert!(written.iter().sum::<usize>() > 0, "{arguments:?}");
        assert!(rows.exists() && !at("plots").exists() && !at("maps").exists(), "{arguments:?}");
    }
}

#[test]
fn a_sweep_writes_the_rows_that_are_whole() {
    let folder = scratch();
    let at = |name: &str| folder.path().join(name);
    let arguments = ["sweep", "free-asymmetric", "--vary", "step=1e-6:1e-2:100000:log", "--out", "f.csv"];
    let child = begun(folder.path(), &arguments);
    assert_eq!(interrupted(child, |_| lines(&at("f.csv.rows")) > 3), 130);
    let table = fs::read_to_string(at("f.csv")).expect("written");
    let mut rows = table.lines();
    let columns = rows.next().expect("a header").split(',').count();
    assert!(rows.clone().count() > 0);
    assert!(rows.all(|row| row.split(',').count() == columns && row.contains(",ok,")), "{table}");
    assert!(!at("f.png").exists());
}

#[test]
fn an_interrupted_self_test_says_in_json_that_it_is_not_complete() {
    let folder = scratch();
    let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
    command.args(["self-test", "--format", "json", "--quiet"]).current_dir(folder.path());
    let child = command.stdout(fs::File::create(folder.path().join("found.json")).expect("a file")).spawn();
    assert_eq!(interrupted(child.expect("the program runs"), listens), 130);
    let text = fs::read_to_string(folder.path().join("found.json")).expect("written");
    let found: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((&found["schema"], &found["kind"]), (&"polhode/self-test/1".into(), &"defects".into()));
    assert_eq!((&found["complete"], &found["sound"]), (&false.into(), &false.into()));
    assert!(found["defects"].is_array() && found["held_against_the_copy"].is_array());
}

/// Sixteen million rows.
#[test]
fn a_long_log_is_not_read_to_its_end() {
    let folder = scratch();
    let path = folder.path().join("log.csv");
    let row = "0.5,1,0,0,0\n".repeat(1 << 20);
    let mut file = fs::File::create(&path).expect("a file");
    std::io::Write::write_all(&mut file, b"t,qw,qx,qy,qz\n").expect("written");
    (0..16).for_each(|_| std::io::Write::write_all(&mut file, row.as_bytes()).expect("written"));
    let arguments = ["judge", "log.csv", "--scene", "free-rod", "--tolerance", "10"];
    let output = fs::File::create(folder.path().join("said")).expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
    let child = command.current_dir(folder.path()).args(arguments).stdout(output).spawn().expect("it runs");
    assert_eq!(interrupted(child, listens), 130);
    assert_eq!(fs::read(folder.path().join("said")).expect("a file"), b"");
}

#[test]
fn commands_without_records_end_too() {
    for arguments in [
        &["self-test"][..],
        &["self-test", "--random", "100000"],
        &["advise", "tether-springs", "--tolerance", "1e-9"],
        &["run", "kovalevskaya", "--steps", "100000000000", "--every", "1000000000", "--out", "run.json"],
    ] {
        let folder = scratch();
        let child = begun(folder.path(), arguments);
        assert_eq!(interrupted(child, listens), 130, "{arguments:?}");
        let text = fs::read_to_string(folder.path().join("run.json")).unwrap_or("{}".to_owned());
        serde_json::from_str::<Value>(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    }
}
