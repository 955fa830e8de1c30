//! Help, completions, man pages, colour.

use std::process::{Command, Stdio};

use crate::common::program::{code, polhode, scratch, stdout};

const COMMANDS: [&str; 18] = [
    "report",
    "gate",
    "bless",
    "init",
    "compare",
    "run",
    "advise",
    "expect",
    "sweep",
    "engine",
    "stability",
    "judge",
    "inspect",
    "reference",
    "self-test",
    "list",
    "completions",
    "engine compare",
];

#[test]
fn help_is_one_screen_and_the_long_form_has_examples() {
    for name in COMMANDS {
        let words: Vec<&str> = name.split(' ').collect();
        let short = polhode(&[&words[..], &["--help"]].concat());
        assert_eq!(code(&short), 0, "{name}");
        let text = stdout(&short);
        assert!(text.lines().count() <= 24, "{name}: {} lines\n{text}", text.lines().count());
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }
    for name in ["gate", "expect", "bless"] {
        assert!(stdout(&polhode(&["help", name])).contains("Examples:"), "{name}");
    }
}

#[test]
fn the_program_alone_shows_the_three_commands_to_begin_with() {
    for words in [&[][..], &["--help"]] {
        let output = polhode(words);
        assert_eq!(code(&output), 0);
        assert!(stdout(&output).lines().count() <= 24, "{}", stdout(&output));
    }
    let text = stdout(&polhode(&[]));
    assert_eq!(text.lines().filter(|line| line.starts_with("  polhode ")).count(), 3);
    for name in &COMMANDS[..17] {
        assert!(text.split_whitespace().any(|word| word == *name), "{name}: {text}");
    }
}

#[test]
fn completions_and_man_pages_know_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let output = polhode(&["completions", shell]);
        assert_eq!(code(&output), 0);
        let text = stdout(&output);
        assert!(COMMANDS[..17].iter().all(|name| text.contains(name)), "{shell}");
    }
    // The script of bash is one.
    let mut bash = Command::new("bash").args(["-n"]).stdin(Stdio::piped()).spawn().expect("bash runs");
    std::io::Write::write_all(
        &mut bash.stdin.take().expect("a pipe"),
        &polhode(&["completions", "bash"]).stdout,
    )
    .expect("written");
    assert!(bash.wait().expect("ends").success());
    let folder = scratch();
    let man = || code(&polhode(&["completions", "--man", &folder.path().to_string_lossy()]));
    assert_eq!((man(), man()), (0, 0));
    for name in &COMMANDS[..17] {
        let page = std::fs::read_to_string(folder.path().join(format!("polhode-{name}.1"))).expect("a page");
        assert!(page.contains(".TH"), "{name}");
    }
    assert_eq!(code(&polhode(&["completions"])), 64);
}

#[test]
fn pass_and_fail_are_coloured_where_that_is_wanted() {
    let gate = |color: &str, no_color: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_polhode"));
        command.args(["gate", "--quiet", "--scheme", "peskin-rk2", "free-rod", "--color", color]);
        stdout(&command.env("NO_COLOR", no_color).output().expect("the program runs"))
    };
    let green = "\u{1b}[32mpass\u{1b}[0m";
    assert!(gate("always", "").contains(green) && gate("always", "1").contains(green));
    for plain in [gate("auto", ""), gate("auto", "1"), gate("never", "")] {
        assert!(!plain.contains('\u{1b}') && plain.contains("pass"));
    }
}
