//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::output::print;
use super::progress::{with_bar, with_tasks};
use super::select::Selection;
use crate::campaign::{Sizes, Survey};
use crate::gates;
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

/// The selection; where nothing was named every scheme in three scenes, too, and costs against size.
fn survey(options: &Options) -> Result<Survey<'static>, Failure> {
    let (selection, full) = (&options.selection, options.full);
    let whole = selection.is_default();
    Ok(Survey {
        every_scheme: full || whole,
        published: whole,
        precision: whole,
        sizes: whole.then_some(if full { Sizes::Full } else { Sizes::Usual }),
        ..Survey::of(selection.scenes()?, selection.contestants(full)?)
    })
}

pub(super) fn report(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let survey = survey(options)?;
    let records = with_tasks(quiet, |progress| Survey { progress, ..survey }.run());
    let write = if options.brief { report::write_brief } else { report::write };
    with_bar(quiet, "drawing", |progress| write(&records, &options.out, progress))?;
    print(&report::verdict_table(&records, false))?;
    if !quiet {
        let page = if options.brief { "report.md" } else { "index.html" };
        eprintln!("polhode: the report is {}", options.out.join(page).display());
    }
    Ok(gates::exit_code(&records.verdicts))
}
