//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::output::{Force, print};
use super::progress::{with_bar, with_tasks};
use super::select::Selection;
use crate::campaign::{Sizes, Survey};
use crate::gates;
use crate::record::Records;
use crate::report;

/// Options of `polhode report`.
#[derive(Args, Clone, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Folder to write into [default: reports/latest; reports/<subject> where scenes or schemes are named]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
    #[command(flatten)]
    selection: Selection,
    /// Every scheme in every scene
    #[arg(long)]
    full: bool,
    /// Only what a repository can hold: report.md, key pictures, and records without the runs behind them
    #[arg(long)]
    brief: bool,
    /// Draw these records; nothing is run
    #[arg(long, value_name = "RECORDS", conflicts_with_all = ["schemes", "places", "named", "full"])]
    from: Option<PathBuf>,
    /// One page with everything in it, in the place of a folder of pages
    #[arg(long, conflicts_with = "brief")]
    single_file: bool,
}

const EXAMPLES: &str = "\
Examples:
  polhode report                                   into reports/latest: index.html, report.md, plots
  polhode report kovalevskaya                      into reports/kovalevskaya
  polhode report --from reports/latest/records.json --out reports/again
  polhode report --single-file --out reports/one   one page to send
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
    let stored = options.from.as_deref().map(Records::read).transpose()?;
    let whole = match (options.full, options.brief) {
        (false, false) => "latest",
        (true, _) => "full",
        (false, true) => "brief",
    };
    let out = options.out.clone().unwrap_or_else(|| options.selection.folder(whole));
    let pages = if options.brief { &["report.md"][..] } else { &["report.md", "index.html", "records.csv"] };
    report::try_folder(&out, "records.json", pages, options.force.given)?;
    let records = match stored {
        Some(records) => records,
        None => {
            let survey = survey(options)?;
            with_tasks(quiet, |progress| Survey { progress, ..survey }.run())
        }
    };
    let write = match (options.brief, options.single_file) {
        (true, _) => report::write_brief,
        (_, true) => report::write_single_file,
        _ => report::write,
    };
    with_bar(quiet, "drawing", |progress| write(&records, &out, progress))?;
    print(&report::verdict_table(&records, false))?;
    if !quiet {
        let page = if options.brief { "report.md" } else { "index.html" };
        eprintln!("polhode: the report is {}", out.join(page).display());
    }
    Ok(gates::exit_code(&records.verdicts))
}
