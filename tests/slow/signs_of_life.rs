//! Long commands without a terminal say again and again that they are at work.

#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::common::program::scratch;

/// Commands that take minutes and more, each with what its lines begin with.
const COMMANDS: [(&str, &str); 9] = [
    ("gate --scheme all --json now.json", "polhode: measuring, "),
    ("bless --scheme all --reason why", "polhode: measuring, "),
    ("report --out report", "polhode: "),
    ("compare kahan-li-8 gauss-legendre-6", "polhode: measuring"),
    ("stability --out stability", "polhode: searching, "),
    ("run kovalevskaya --steps 100000000000 --every 100000 --out run.json", "polhode: running, "),
    ("sweep long.toml --vary step=1e-6:2e-6:100 --out sweep.csv", "polhode: running"),
    ("reference long.toml", "polhode: solving"),
    ("self-test --random 100000", "polhode: judging, "),
];

/// Ten days at a radian a second.
const LONG: &str = "name = \"long\"\nduration = 1e6\n[body]\nmass = 1.0\ninertia = [1, 2, 2.5]\n[initial]\nangular_velocity = [1, 1, 1]\n";

fn begun(folder: &Path, line: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_polhode"))
        .current_dir(folder)
        .args(line.split(' '))
        .args(["--jobs", "1"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program runs")
}

#[test]
fn long_commands_without_a_terminal_write_a_line_again_and_again() {
    let begun = COMMANDS.map(|(line, start)| {
        let folder = scratch();
        fs::write(folder.path().join("long.toml"), LONG).expect("written");
        let child = begun(folder.path(), line);
        (folder, child, line, start)
    });
    for (_folder, mut child, line, start) in begun {
        let lines = BufReader::new(child.stderr.take().expect("a pipe")).lines();
        // Two lines, of which the second comes as long after the first as that after the beginning.
        let found = lines.map_while(Result::ok).filter(|line| line.starts_with(start)).take(2).count();
        child.kill().expect("killed");
        child.wait().expect("it ends");
        assert_eq!(found, 2, "{line}");
    }
}
