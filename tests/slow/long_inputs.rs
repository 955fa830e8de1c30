//! Logs without a bound.

use std::process::Command;

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
