//! What the command line promises, a row a statement, with a command that shows it.
//!
//! A row runs its command by bash in a new folder, where `polhode` is the program of this build, and looks at the exit code and at what
//! was written. Where another test holds a statement, the row names that test, and `every_test_that_a_row_names_exists` finds it.

#![cfg(unix)]

mod continuous_integration;
mod faults;
mod green_lights;
mod nothing_lost;
mod output;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;
use tempfile::TempDir;

use crate::common::program::{code, polhode, scratch, stderr, stdout};
use crate::mutated_commands;

/// A statement and what shows it.
struct Statement {
    says: &'static str,
    /// As a user types it, in a folder with `scene.toml` (free-rod), `log.csv`, `c.toml` (short ladders) and `now.json` (records of them).
    command: &'static str,
    shown: Shown,
}

/// How a statement is shown.
enum Shown {
    /// The command ends with this code, and this holds of what it wrote.
    Here(i32, fn(&Ran) -> bool),
    /// A test: its file and its name.
    Test(&'static str, &'static str),
    /// A script that CI runs.
    Script(&'static str),
}

use Shown::{Here, Script, Test};

/// What a command left.
struct Ran {
    stdout: String,
    stderr: String,
    folder: TempDir,
}

impl Ran {
    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.folder.path().join(name)).unwrap_or_default()
    }

    fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).expect("JSON on stdout")
    }

    fn json_of(&self, name: &str) -> Value {
        serde_json::from_str(&self.text(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn last(&self) -> &str {
        self.stdout.lines().last().unwrap_or_default()
    }

    fn is_silent(&self) -> bool {
        self.stderr.is_empty()
    }
}

fn all() -> impl Iterator<Item = &'static Statement> {
    let lists: [&[Statement]; 5] = [
        &nothing_lost::STATEMENTS,
        &green_lights::STATEMENTS,
        &output::STATEMENTS,
        &faults::STATEMENTS,
        &continuous_integration::STATEMENTS,
    ];
    lists.into_iter().flatten()
}

/// Runs the command of a statement in a copy of a stage.
fn run(statement: &Statement, stage: &Path) -> (i32, Ran) {
    let folder = scratch();
    for entry in fs::read_dir(stage).expect("a folder") {
        let path = entry.expect("an entry").path();
        fs::copy(&path, folder.path().join(path.file_name().expect("a name"))).expect("copied");
    }
    let program = Path::new(env!("CARGO_BIN_EXE_polhode")).parent().expect("a folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let output = Command::new("bash")
        .args(["-o", "pipefail", "-c", statement.command])
        .current_dir(folder.path())
        .env("PATH", path)
        .env_remove("NO_COLOR")
        .env_remove("GITHUB_STEP_SUMMARY")
        .output()
        .expect("bash runs");
    (code(&output), Ran { stdout: stdout(&output), stderr: stderr(&output), folder })
}

/// Holds every statement of a list that its command shows.
fn hold(statements: &[Statement]) {
    let stage = mutated_commands::stage();
    let mut wrong = Vec::new();
    for statement in statements {
        let Here(expected, holds) = statement.shown else { continue };
        let (code, ran) = run(statement, stage.path());
        if code != expected || !holds(&ran) {
            let Statement { says, command, .. } = statement;
            wrong.push(format!("{says}\n  {command}\n  ends with {code}\n{}{}", ran.stdout, ran.stderr));
        }
    }
    assert!(wrong.is_empty(), "{} of {} do not hold:\n{}", wrong.len(), statements.len(), wrong.join("\n\n"));
}

#[test]
fn nothing_of_the_users_is_lost() {
    hold(&nothing_lost::STATEMENTS);
}

#[test]
fn no_green_light_means_nothing() {
    hold(&green_lights::STATEMENTS);
}

#[test]
fn output_answers() {
    hold(&output::STATEMENTS);
}

#[test]
fn files_say_everything_wrong_at_once() {
    hold(&faults::STATEMENTS);
}

#[test]
fn build_servers_are_served() {
    hold(&continuous_integration::STATEMENTS);
}

#[test]
fn every_test_that_a_row_names_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |path: PathBuf| fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    for statement in all() {
        match statement.shown {
            Here(..) => {}
            Test(file, name) => {
                let text = read(root.join(file));
                let head = text.split(&format!("fn {name}() {{")).next().expect("a first part");
                let is_test = head.len() < text.len() && head.trim_end().ends_with("#[test]");
                assert!(is_test, "{file} has no test {name}");
            }
            Script(name) => {
                assert!(root.join(name).is_file() && read(root.join(".ci/run")).contains(name), "{name}");
            }
        }
    }
}

/// The options that a command has by its help, and the words before them: `engine check`.
fn options(words: &[&str], known: &mut BTreeMap<String, String>) -> String {
    let name = words.join(" ");
    let help = || stdout(&polhode(&[&["help"], words].concat()));
    known.entry(name).or_insert_with(help).clone()
}

/// A row names a command that there is, with options that it has.
#[test]
fn every_command_of_a_row_is_one() {
    let mut known = BTreeMap::new();
    // What is mistyped on purpose is no option.
    for statement in all().filter(|statement| !matches!(statement.shown, Here(64, _))) {
        let mut typed = statement.command.split("polhode ").skip(1).peekable();
        assert!(typed.peek().is_some(), "{}", statement.command);
        for rest in typed {
            let mut words = rest.split_whitespace();
            let command = words.next().expect("a command");
            let one = [command, words.clone().next().unwrap_or_default()];
            let named = if ["engine", "scene"].contains(&command) { &one[..] } else { &one[..1] };
            let help = options(named, &mut known);
            assert!(help.contains("Usage: ") || command.starts_with('-'), "{command}: {}", statement.command);
            let end = [";", "|", "&&", "||", ">", ")"];
            for word in words.take_while(|word| !end.contains(word)).filter(|word| word.starts_with("--")) {
                let option = word.trim_end_matches(';').split('=').next().expect("a name");
                assert!(help.contains(option), "{option}: {}", statement.command);
            }
        }
    }
}

#[test]
fn the_table_has_a_row_for_every_statement() {
    let says: Vec<&str> = all().map(|statement| statement.says).collect();
    let mut once = says.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), says.len());
    assert!(says.len() > 90, "{}", says.len());
}

/// Commands that print no table, and what they print.
const WITHOUT_A_TABLE: [(&str, &str); 3] =
    [("init", "a file"), ("scene", "a file"), ("completions", "a script")];

#[test]
fn every_subcommand_that_prints_a_table_has_it_as_json() {
    let help = stdout(&polhode(&["--help"]));
    let names = help.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let mut count = 0;
    for name in names.filter(|name| !name.is_empty() && *name != "help") {
        let inner: &[&str] = if name == "engine" { &["check", "compare"] } else { &[""] };
        for inner in inner {
            let words: Vec<&str> = [name, inner].into_iter().filter(|word| !word.is_empty()).collect();
            let text = stdout(&polhode(&[&["help"], &words[..]].concat()));
            let has = text.split("--format").nth(1).is_some_and(|rest| rest.contains("json"));
            let none = WITHOUT_A_TABLE.iter().any(|(without, _)| *without == name);
            assert!(has != none, "{words:?}");
            count += 1;
        }
    }
    assert_eq!(count, 20);
}
