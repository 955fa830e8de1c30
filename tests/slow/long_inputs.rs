//! Logs without a bound.

use std::process::Command;

use crate::common::program::{scratch, stderr, stdout};

/// 10 GB by a pipe: refused after the first of them, in 2 GB of addresses.
#[cfg(target_os = "linux")]
#[test]
fn ten_gigabytes_by_a_pipe_are_65() {
    let rows = "(echo t,qw,qx,qy,qz; yes 0.1,1,0,0,0) | head -c 10G";
    let program = env!("CARGO_BIN_EXE_polhode");
    let line = format!("ulimit -v 2000000; {rows} | {program} judge /dev/stdin --scene free-rod");
    let status = Command::new("bash").args(["-c", &line]).status().expect("bash runs");
    assert_eq!(status.code(), Some(65));
}

/// Three million rows, of which each takes 128 bytes where it is kept: 384 MB. Read in constant memory they take 161 MB, as 1.5 million and
/// twelve million rows do (161 and 184 MB measured), and fourteen columns to the row 71 MB.
#[cfg(target_os = "linux")]
#[test]
fn three_million_rows_are_judged_in_constant_memory() {
    let folder = scratch();
    let program = env!("CARGO_BIN_EXE_polhode");
    let rows = "(echo t,qw,qx,qy,qz; seq -f '%.6f,1,0,0,0' 0 1e-6 3) > log.csv";
    let line = format!("{rows}; ulimit -d 280000; {program} judge log.csv --scene free-rod");
    let output =
        Command::new("bash").args(["-c", &line]).current_dir(folder.path()).output().expect("bash runs");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains(" 3000001 rows"), "{}", stdout(&output));
}
