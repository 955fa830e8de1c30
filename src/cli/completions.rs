//! `polhode completions`: what a shell completes, and man pages, from the parser itself.

use std::path::{Path, PathBuf};

use clap::{Args, Command};
use clap_complete::Shell;

use super::Failure;
use super::output::print;
use crate::record;

/// Options of `polhode completions`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// The shell
    #[arg(value_enum, required_unless_present = "man")]
    shell: Option<Shell>,
    /// Write a man page for each command into this folder
    #[arg(long, value_name = "DIR", conflicts_with = "shell")]
    man: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  polhode completions bash > ~/.local/share/bash-completion/completions/polhode
  polhode completions --man ~/.local/share/man/man1";

pub(super) fn completions(options: &Options, mut command: Command) -> Result<u8, Failure> {
    if let Some(folder) = &options.man {
        command.build();
        man(folder, &command, "polhode")?;
        return Ok(0);
    }
    if let Some(shell) = options.shell {
        let mut script = Vec::new();
        clap_complete::generate(shell, &mut command, "polhode", &mut script);
        print(&String::from_utf8_lossy(&script))?;
    }
    Ok(0)
}

/// The page of a command and those of its subcommands: polhode.1, polhode-gate.1, …
fn man(folder: &Path, command: &Command, name: &str) -> Result<(), Failure> {
    let path = folder.join(format!("{name}.1"));
    record::try_place(&path, false, |head| head.contains(".TH polhode"))?;
    let mut page = Vec::new();
    let fail = |source| Failure::Write { name: path.display().to_string(), source };
    clap_mangen::Man::new(command.clone()).render(&mut page).map_err(fail)?;
    record::write_whole(&path, &page)?;
    let own = command.get_subcommands().filter(|one| !one.is_hide_set() && one.get_name() != "help");
    own.into_iter().try_for_each(|one| man(folder, one, &format!("{name}-{}", one.get_name())))
}
