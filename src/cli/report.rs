//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::gate::{measure, progress_bar};
use super::select::Selection;
use crate::gates::{self, Baseline};
use crate::report;

/// Options of `polhode report`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Folder to write into
    #[arg(long, value_name = "DIR", default_value = "reports/latest")]
    out: PathBuf,
    #[command(flatten)]
    selection: Selection,
    /// Every scheme in every scene
    #[arg(long)]
    full: bool,
    /// Only what a repository can hold: report.md, key pictures, and records without the runs behind them
    #[arg(long)]
    brief: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options { out: "reports/latest".into(), selection: Selection::default(), full: false, brief: false }
    }
}

const EXAMPLES: &str = "\
Examples:
  polhode report                                   into reports/latest: index.html, report.md, plots
  polhode report --scene kovalevskaya --out top
  polhode report --scene my-body.toml --scheme peskin-rk2";

pub(super) fn report(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let records = measure(&options.selection, options.full, Baseline::built_in(), true, quiet)?;
    let bar = progress_bar(quiet, "drawing");
    let progress = |done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    };
    let write = if options.brief { report::write_brief } else { report::write };
    write(&records, &options.out, &progress)?;
    bar.finish_and_clear();
    super::run::print(&report::verdict_table(&records, false))?;
    if !quiet {
        let page = if options.brief { "report.md" } else { "index.html" };
        eprintln!("polhode: the report is {}", options.out.join(page).display());
    }
    Ok(gates::exit_code(&records.verdicts))
}
