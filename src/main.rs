//! Polhode's command line.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(polhode::internals::main(std::env::args_os()))
}
