//! `polhode engine compare`: foreign programs beside one another and beside our schemes, as a page of its own.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::gate::{measure_with, progress_bar};
use super::select::Selection;
use crate::engine::compare::{self, Peers};
use crate::gates::Baseline;
use crate::record::Records;
use crate::report;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Options of `polhode engine compare`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    /// Folder to write engines.md, engines.json and pictures into
    #[arg(long, value_name = "DIR", default_value = "reports/engines")]
    out: PathBuf,
    #[command(flatten)]
    selection: Selection,
}

pub(super) fn compare(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (scenes, contestants) = (options.selection.scenes()?, options.selection.contestants(false)?);
    if !contestants.iter().any(|contestant| contestant.program().is_some()) {
        let how = "name at least one engine: --scheme 'engine:python3 my_engine.py'";
        return Err(Failure::Usage(how.to_owned()));
    }
    let mut records = measure_with(scenes, contestants.clone(), Baseline::built_in(), false, quiet);
    stand_beside(&mut records, &options.selection.scenes()?, &contestants, quiet);
    report::write_engines(&records, &options.out)?;
    if !quiet {
        eprintln!("polhode: the page is {}", options.out.join("engines.md").display());
    }
    Ok(0)
}

/// Adds how the foreign programs among the contestants stand at equal steps; nothing where there are none.
pub(super) fn stand_beside(records: &mut Records, scenes: &[Scene], contestants: &[Contestant], quiet: bool) {
    if !contestants.iter().any(|contestant| contestant.program().is_some()) {
        return;
    }
    let bar = progress_bar(quiet, "comparing");
    let progress = |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    };
    let Peers { rows, twins } = compare::compare(scenes, contestants, &Contestant::all(), &progress);
    bar.finish_and_clear();
    (records.peers, records.twins) = (rows, twins);
}
