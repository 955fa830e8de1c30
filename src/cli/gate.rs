//! `polhode gate`: judge every claim.

use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use super::Failure;
use super::select::Selection;
use crate::campaign::Campaign;
use crate::gates::{self, Baseline};
use crate::record::{self, Records};
use crate::report;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Options of `polhode gate`.
#[derive(Args, Clone, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    selection: Selection,
    /// Records whose error constants must be met to 5 % [default: those on record for the built-in scenes]
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Write a JUnit report
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write annotations for GitHub Actions to stdout
    #[arg(long)]
    github: bool,
    /// Write the records
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Print every verdict, not only those that do not pass
    #[arg(long)]
    verbose: bool,
}

const EXAMPLES: &str = "\
Examples:
  polhode gate                                    the main schemes in every built-in scene
  polhode gate --scheme all                       every scheme
  polhode gate --scheme euler --scene kovalevskaya --verbose
  polhode gate --scene my-body.toml --json now.json
  polhode gate --scene my-body.toml --baseline before.json   error constants within 5 %

Exit code: 0 every claim holds or is a known deviation, 1 one fails, 2 one is undecided.";

pub(super) fn gate(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let baseline = match &options.baseline {
        Some(path) => Baseline::from_records(&Records::read(path)?),
        None => Baseline::built_in(),
    };
    let records = measure(&options.selection, false, baseline, false, quiet)?;
    if let Some(path) = &options.json {
        record::write_json(path, &records)?;
    }
    if let Some(path) = &options.junit {
        record::write_whole(path, report::junit(&records).as_bytes())?;
    }
    super::run::print(&report::verdict_table(&records, options.verbose))?;
    if options.github {
        super::run::print(&report::annotations(&records))?;
    }
    Ok(gates::exit_code(&records.verdicts))
}

/// Measures and judges a selection, with a progress bar on stderr.
pub(super) fn measure(
    selection: &Selection,
    full: bool,
    baseline: Baseline,
    series: bool,
    quiet: bool,
) -> Result<Records, Failure> {
    Ok(measure_with(selection.scenes()?, selection.contestants(full)?, baseline, series, quiet))
}

/// Measures and judges a grid, with a progress bar on stderr.
pub(super) fn measure_with(
    scenes: Vec<Scene>,
    contestants: Vec<Contestant>,
    baseline: Baseline,
    series: bool,
    quiet: bool,
) -> Records {
    let bar = progress_bar(quiet, "measuring");
    let progress = |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    };
    let records =
        Campaign { baseline, series, progress: &progress, ..Campaign::of(scenes, contestants) }.run();
    bar.finish_and_clear();
    records
}

/// A bar on stderr with the time left; nothing where stderr is no terminal.
pub(super) fn progress_bar(quiet: bool, what: &'static str) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len}, {eta} left");
    ProgressBar::new(0).with_prefix(what).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
