//! `polhode engine compare`: foreign programs beside one another and beside our schemes, as a separate page.

use std::path::PathBuf;

use clap::Args;

use crate::campaign::{self, Campaign};
use crate::cli::Failure;
use crate::cli::output::Force;
use crate::cli::progress::with_bar;
use crate::cli::select::Selection;
use crate::report;

/// Options of `polhode engine compare`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    /// Folder to write engines.md, engines.json and pictures into
    #[arg(long, value_name = "DIR", default_value = "reports/engines")]
    out: PathBuf,
    #[command(flatten)]
    force: Force,
    #[command(flatten)]
    selection: Selection,
}

pub(super) fn compare(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (scenes, contestants) = (options.selection.scenes()?, options.selection.contestants(false)?);
    if !contestants.iter().any(|contestant| contestant.program().is_some()) {
        let how = "name at least one engine: --scheme 'engine:python3 my_engine.py'";
        return Err(Failure::Usage(how.to_owned()));
    }
    report::try_folder(&options.out, "engines.json", &["engines.md"], options.force.given)?;
    let grid = Campaign::of(scenes.clone(), contestants.clone());
    let mut records = with_bar(quiet, "measuring", |progress| Campaign { progress, ..grid }.run());
    with_bar(quiet, "comparing", |progress| {
        campaign::add_peers(&mut records, &scenes, &contestants, progress);
    });
    report::write_engines(&records, &options.out)?;
    if !quiet {
        eprintln!("polhode: the page is {}", options.out.join("engines.md").display());
    }
    Ok(0)
}
