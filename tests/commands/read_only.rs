//! Folders that take no file.

#![cfg(target_os = "linux")]

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Output};

use crate::common::program::{code, scratch, stderr};

/// Commands that write into a folder `read-only`; those that measure would take minutes.
const COMMANDS: [&str; 16] = [
    "gate --scheme all --json read-only/f",
    "gate --scheme all --junit read-only/f",
    "gate --scheme all --sarif read-only/f",
    "bless --scheme all --reason why --baseline read-only/f",
    "report --full --out read-only",
    "report --full --out read-only/new",
    "report --full --out new --capsule read-only/f",
    "stability --out read-only",
    "run kovalevskaya --steps 100000000000 --every 1000000 --out read-only/f",
    "run kovalevskaya --steps 100000000000 --every 1000000 --plot read-only/f.png",
    "sweep kovalevskaya --vary step=1e-6:2e-6:100 --out read-only/f.csv",
    "reference kovalevskaya --digits 30 --out read-only/f",
    "judge log.csv --scene free-rod --json read-only/f",
    "engine new --language c --out read-only/f",
    "scene new read-only/f",
    "completions --man read-only",
];

/// Runs a command that may not write where its user may not: the superuser leaves that right behind.
fn without_privilege(folder: &std::path::Path, line: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_polhode");
    let words = line.split(' ');
    let mut command = if rustix::process::geteuid().is_root() {
        let mut command = Command::new("setpriv");
        command.args(["--bounding-set=-dac_override", program]);
        command
    } else {
        Command::new(program)
    };
    command.current_dir(folder).args(words).output().expect("the program runs")
}

#[test]
fn a_folder_that_takes_no_file_is_found_before_measuring() {
    let folder = scratch();
    let closed = folder.path().join("read-only");
    fs::create_dir(&closed).expect("made");
    fs::set_permissions(&closed, Permissions::from_mode(0o555)).expect("closed");
    fs::write(folder.path().join("log.csv"), "t,qw,qx,qy,qz\n0,1,0,0,0\n0.1,1,0,0,0\n").expect("written");
    for line in COMMANDS {
        let output = without_privilege(folder.path(), line);
        assert_eq!(code(&output), 74, "{line}: {}", stderr(&output));
        assert!(stderr(&output).contains("read-only"), "{line}: {}", stderr(&output));
        assert_eq!(fs::read_dir(&closed).expect("a folder").count(), 0, "{line}");
    }
}
