//! The program on a terminal: as wide as it is, in colour, with progress that does not come into the data.

#![cfg(unix)]

use std::fs;
use std::io::Read;
use std::path::Path;

use portable_pty::{CommandBuilder, PtySize, native_pty_system};

use crate::common::program::{code, polhode, scratch, stderr, stdout};

/// What begins a code of a terminal.
const CODE: char = '\u{1b}';
/// A gate that passes at once, and one that goes through enough cells to show a bar.
const GATE: [&str; 5] = ["gate", "free-rod", "kovalevskaya", "--scheme", "euler"];

/// What a command writes on a terminal of so many columns, and its exit code. `shell` is the line that runs `"$@"`.
fn on_terminal(
    columns: u16,
    folder: &Path,
    shell: &str,
    arguments: &[&str],
    variables: &[(&str, &str)],
) -> (String, u32) {
    let size = PtySize { rows: 24, cols: columns, pixel_width: 0, pixel_height: 0 };
    let pair = native_pty_system().openpty(size).expect("a terminal");
    let mut command = CommandBuilder::new("sh");
    command.args(["-c", shell, "sh", env!("CARGO_BIN_EXE_polhode")]);
    command.args(arguments);
    command.cwd(folder);
    command.env("TERM", "xterm-256color");
    command.env_remove("NO_COLOR");
    variables.iter().for_each(|(name, value)| command.env(name, value));
    let mut child = pair.slave.spawn_command(command).expect("the program runs");
    drop(pair.slave);
    let mut reader = pair.master.try_clone_reader().expect("a reader");
    let mut bytes = Vec::new();
    // Linux ends the reading by an error where the other side is closed.
    let _ = reader.read_to_end(&mut bytes);
    let status = child.wait().expect("it ends");
    (String::from_utf8_lossy(&bytes).into_owned(), status.exit_code())
}

/// Letters of the longest line, codes left out.
fn longest(text: &str) -> usize {
    let length = |line: &str| {
        let mut parts = line.split(CODE);
        let first = parts.next().map_or(0, |part| part.chars().count());
        // A code ends with its first letter.
        let after = |part: &str| part.chars().skip_while(|sign| !sign.is_ascii_alphabetic()).skip(1).count();
        first + parts.map(after).sum::<usize>()
    };
    text.lines().map(|line| length(line.trim_end_matches('\r'))).max().unwrap_or(0)
}

#[test]
fn tables_and_help_are_no_wider_than_the_terminal() {
    let folder = scratch();
    for arguments in [
        &["list", "scenes"][..],
        &["list", "metrics"],
        &["list", "claims"],
        &["run", "--help"],
        &["gate", "--help"],
    ] {
        let [narrow, wide] = [80, 120].map(|columns| {
            let (text, code) = on_terminal(columns, folder.path(), "exec \"$@\"", arguments, &[]);
            assert!(code <= 1, "{arguments:?}: {code}: {text}");
            longest(&text)
        });
        assert!(narrow <= 80 && narrow <= wide && wide <= 120, "{arguments:?}: {narrow}, {wide}");
    }
    // A sentence after a table is no row of it, and may be longer.
    let (text, _) =
        on_terminal(80, folder.path(), "exec \"$@\"", &["compare", "euler", "peskin-rk2", "free-rod"], &[]);
    let rules: String = text.lines().filter(|line| line.contains('─')).collect::<Vec<_>>().join("\n");
    assert!(longest(&rules) > 40 && longest(&rules) <= 80, "{text}");
    // A list uses the room that there is.
    let (text, _) = on_terminal(120, folder.path(), "exec \"$@\"", &["list", "scenes"], &[]);
    assert_eq!(longest(&text), 100);
}

#[test]
fn a_verdict_is_in_colour_on_a_terminal_and_not_where_the_user_wants_none() {
    let folder = scratch();
    let gate = |more: &[&str], variables: &[(&str, &str)]| {
        let (text, code) =
            on_terminal(80, folder.path(), "exec \"$@\" --quiet", &[&GATE[..], more].concat(), variables);
        assert!(code <= 2, "{text}");
        text
    };
    let green = "\u{1b}[32mpass\u{1b}[0m";
    assert!(gate(&[], &[]).contains(green));
    assert!(!gate(&[], &[("NO_COLOR", "1")]).contains(CODE));
    assert!(!gate(&["--color", "never"], &[]).contains(CODE));
    assert!(gate(&["--color", "always"], &[("NO_COLOR", "1")]).contains(green));
    let piped = polhode(&GATE);
    assert!(code(&piped) <= 2 && !stdout(&piped).contains(CODE) && !stderr(&piped).contains(CODE));
    let forced = polhode(&[&GATE[..], &["--color", "always"]].concat());
    assert!(stdout(&forced).contains(green));
}

#[test]
fn a_failure_is_red() {
    let folder = scratch();
    let arguments = ["gate", "free-asymmetric", "--scheme", "peskin-rk2", "--order", "3", "--quiet"];
    let (text, code) = on_terminal(80, folder.path(), "exec \"$@\"", &arguments, &[]);
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("\u{1b}[31m"), "{text}");
}

#[test]
fn progress_goes_to_stderr_and_needs_a_terminal() {
    let folder = scratch();
    let to_file = |shell: &str| on_terminal(80, folder.path(), shell, &GATE, &[]).0;
    let file = || fs::read_to_string(folder.path().join("file")).expect("written");
    // The bar is on the terminal and not in the data.
    assert!(to_file("exec \"$@\" >file").contains("measuring"));
    let data = file();
    assert!(!data.is_empty() && !data.contains(CODE) && !data.contains("measuring") && !data.contains('\r'));
    // The verdicts are on the terminal; what goes to a file is no bar.
    assert!(to_file("exec \"$@\" 2>file").contains("euler"));
    assert!(!file().contains(CODE) && !file().contains('\r'));
    assert!(!to_file("exec \"$@\" --quiet >file").contains("measuring"));
}
