//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::gate::{measure_with, progress_bar};
use super::peers;
use super::select::{self, Selection};
use crate::gates::{self, Baseline};
use crate::record::Records;
use crate::report;
use crate::scenes::Scene;
use crate::schemes;

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

/// Scenes on which every scheme is measured where none is named: free, held at a point under gravity, and under springs.
const EVERY_SCHEME: [&str; 3] = ["free-asymmetric", "heavy-asymmetric-top", "tether-springs"];

/// The selection, or the main schemes on every scene and all of them on three. Beside the main ones all others stand apart.
fn records(options: &Options, quiet: bool) -> Result<Records, Failure> {
    let selection = &options.selection;
    let contestants = selection.contestants(options.full)?;
    let mut records =
        measure_with(selection.scenes()?, contestants.clone(), Baseline::built_in(), true, quiet);
    let main: Vec<&str> = schemes::MAIN.to_vec();
    if options.full {
        records.schemes.iter_mut().for_each(|row| row.apart = !main.contains(&row.name.as_str()));
    } else if selection.is_default() {
        let others = select::everyone().into_iter().filter(|c| !main.contains(&c.card.name)).collect();
        let scenes = EVERY_SCHEME.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
        let mut more = measure_with(scenes, others, Baseline::built_in(), false, quiet);
        more.schemes.iter_mut().for_each(|row| row.apart = true);
        records.take_in(more);
    }
    peers::stand_beside(&mut records, &selection.scenes()?, &contestants, quiet);
    Ok(records)
}

pub(super) fn report(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let records = records(options, quiet)?;
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
