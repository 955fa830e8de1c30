//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::gate::{measure_with, progress_bar};
use super::peers;
use super::select::Selection;
use crate::campaign;
use crate::gates::{self, Baseline};
use crate::record::Records;
use crate::report;
use crate::scenes::Scene;
use crate::schemes;
use crate::simulate::Contestant;
use crate::study::published;

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

/// Time that each scheme is timed for in each kind of scene [s].
pub(super) const SECONDS_A_COST: f64 = 0.25;

/// Says on stderr what is going on.
fn talk(quiet: bool, words: &str) {
    if !quiet {
        eprintln!("polhode: {words}");
    }
}

/// The selection, or the main schemes on every scene and all of them on three. Beside the main ones all others stand apart.
fn records(options: &Options, quiet: bool) -> Result<Records, Failure> {
    let selection = &options.selection;
    let (scenes, contestants) = (selection.scenes()?, selection.contestants(options.full)?);
    let mut records = measure_with(scenes.clone(), contestants.clone(), Baseline::built_in(), true, quiet);
    let main: Vec<&str> = schemes::MAIN.to_vec();
    if options.full {
        records.schemes.iter_mut().for_each(|row| row.apart = !main.contains(&row.name.as_str()));
    } else if selection.is_default() {
        let others = Contestant::everyone().into_iter().filter(|c| !main.contains(&c.card.name)).collect();
        let scenes = EVERY_SCHEME.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
        let mut more = measure_with(scenes, others, Baseline::built_in(), false, quiet);
        more.schemes.iter_mut().for_each(|row| row.apart = true);
        records.take_in(more);
    }
    peers::stand_beside(&mut records, &scenes, &contestants, quiet);
    // Alone, after all else: nothing may run beside a clock. The schemes that stand apart are timed in a full report only.
    talk(quiet, "timing steps, one thread");
    campaign::add_costs(&mut records, &scenes, &contestants, SECONDS_A_COST);
    campaign::add_reductions(&mut records, &scenes);
    if selection.is_default() {
        match published::rows() {
            Ok(rows) => records.published = rows,
            // What was measured is worth more than what is missing.
            Err(error) => {
                records.complete = false;
                talk(quiet, &format!("no published numbers: {error}"));
            }
        }
        campaign::add_scaling(&mut records, options.full);
    }
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
