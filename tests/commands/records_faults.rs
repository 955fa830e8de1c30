//! A file of records with faults: every command that reads it refuses it with 65, and shows each fault with its line.

use std::fs;
use std::path::Path;

use crate::common::program::{code, polhode_in, scratch, stderr};

/// Commands that read records, the name of the file left out.
const READERS: [&[&str]; 5] = [
    &["report", "--quiet", "--out", "out", "--from"],
    &["gate", "--from"],
    &["gate", "free-rod", "--scheme", "euler", "--baseline"],
    &["bless", "--reason", "why", "--baseline", "new.json", "--from"],
    &["compare", "now.json"],
];

/// Replaces the first text after the beginning of another, and returns the line that it stands on.
fn replaced(text: &mut String, after: &str, from: &str, to: &str) -> usize {
    let start = text.find(after).expect("the list");
    let place = start + text[start..].find(from).expect("the text");
    text.replace_range(place..place + from.len(), to);
    1 + text[..place].matches('\n').count()
}

/// The lines of the file that a command marks.
fn marked(folder: &Path, command: &[&str], file: &str) -> Vec<usize> {
    let output = polhode_in(folder, &[command, &[file]].concat());
    let said = stderr(&output);
    assert_eq!(code(&output), 65, "{command:?}: {said}");
    let mark = format!("{file}:");
    let after = said.split(mark.as_str()).skip(1).filter_map(|rest| rest.split(':').next());
    after.filter_map(|line| line.trim().parse().ok()).collect()
}

#[test]
fn every_fault_is_shown_with_its_line_by_every_command_that_reads_records() {
    let folder = scratch();
    let gate = ["gate", "free-rod", "--scheme", "euler", "--quiet", "--json", "now.json"];
    assert_eq!(code(&polhode_in(folder.path(), &gate)), 0);
    let whole = fs::read_to_string(folder.path().join("now.json")).expect("written");
    let mut text = whole.clone();
    let lines = [
        replaced(&mut text, "\"measurements\"", "\"step_s\":1.5", "\"step_s\":\"long\""),
        replaced(&mut text, "\"orders\"", "\"scene\":", "\"scenery\":"),
        replaced(&mut text, "\"verdicts\"", "\"verdict\":\"", "\"verdict\":\"perhaps-"),
    ];
    fs::write(folder.path().join("wrong.json"), &text).expect("written");
    let before = &whole[..whole.find("\"orders\"").expect("the list") + 4];
    fs::write(folder.path().join("cut.json"), before).expect("written");
    let other = whole.replacen("polhode/records/1", "polhode/records/9", 1);
    fs::write(folder.path().join("other.json"), other).expect("written");
    let cut = 1 + before.matches('\n').count();
    for command in READERS {
        assert_eq!(marked(folder.path(), command, "wrong.json"), lines, "{command:?}");
        assert_eq!(marked(folder.path(), command, "cut.json"), [cut], "{command:?}");
        assert_eq!(marked(folder.path(), command, "other.json"), [2], "{command:?}");
    }
    assert_eq!(marked(folder.path(), &["replay"], "other.json"), [2]);
    assert!(!folder.path().join("new.json").exists());
}
