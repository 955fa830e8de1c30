//! `polhode init`: settings for a folder.

use std::path::Path;

use clap::Args;

use super::Failure;
use super::config;
use super::output::{Force, print};
use crate::record;

/// Options of `polhode init`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Print the JSON Schema of the file
    #[arg(long)]
    schema: bool,
    #[command(flatten)]
    force: Force,
}

const EXAMPLES: &str = "\
Examples:
  polhode init                                     polhode.toml, every line of it a comment
  polhode init --schema > polhode.schema.json      for the completion of an editor";

pub(super) fn init(options: &Options) -> Result<u8, Failure> {
    if options.schema {
        print(&format!("{:#}\n", config::schema()))?;
        return Ok(0);
    }
    let path = Path::new(config::NAME);
    record::try_place(path, options.force.given, |_| false)?;
    record::write_whole(path, config::commented().as_bytes())?;
    eprintln!("polhode: wrote {}", config::NAME);
    Ok(0)
}
