//! `polhode report`: measure, judge and draw.

use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::output::print;
use super::progress::{talk, with_bar};
use super::select::Selection;
use crate::campaign::{self, Campaign, SECONDS_A_COST};
use crate::gates;
use crate::record::Records;
use crate::report;
use crate::scenes::Scene;
use crate::schemes;
use crate::simulate::Contestant;

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
    let (scenes, contestants) = (selection.scenes()?, selection.contestants(options.full)?);
    let measure =
        |grid: Campaign| with_bar(quiet, "measuring", |progress| Campaign { progress, ..grid }.run());
    let mut records = measure(Campaign { series: true, ..Campaign::of(scenes.clone(), contestants.clone()) });
    let main: Vec<&str> = schemes::MAIN.to_vec();
    if options.full {
        records.schemes.iter_mut().for_each(|row| row.apart = !main.contains(&row.name.as_str()));
    } else if selection.is_default() {
        let others = Contestant::everyone().into_iter().filter(|c| !main.contains(&c.card.name)).collect();
        let scenes = EVERY_SCHEME.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
        let mut more = measure(Campaign::of(scenes, others));
        more.schemes.iter_mut().for_each(|row| row.apart = true);
        records.take_in(more);
    }
    with_bar(quiet, "comparing", |progress| {
        campaign::add_peers(&mut records, &scenes, &contestants, progress);
    });
    // Alone, after all else: nothing may run beside a clock. The schemes that stand apart are timed in a full report only.
    talk(quiet, "timing steps, one thread");
    campaign::add_costs(&mut records, &scenes, &contestants, SECONDS_A_COST);
    campaign::add_reductions(&mut records, &scenes);
    if selection.is_default() {
        campaign::add_scaling(&mut records, options.full);
    }
    Ok(records)
}

pub(super) fn report(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let records = records(options, quiet)?;
    let write = if options.brief { report::write_brief } else { report::write };
    with_bar(quiet, "drawing", |progress| write(&records, &options.out, progress))?;
    print(&report::verdict_table(&records, false))?;
    if !quiet {
        let page = if options.brief { "report.md" } else { "index.html" };
        eprintln!("polhode: the report is {}", options.out.join(page).display());
    }
    Ok(gates::exit_code(&records.verdicts))
}
