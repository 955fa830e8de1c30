//! Polhode's command line.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(polhode::cli::main(std::env::args_os()))
}
