//! `polhode stability`: where methods fail.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use super::output::{Force, Format, print, try_parent};
use super::progress::with_bar;
use super::resume::with_journal;
use super::select::Selection;
use crate::campaign::{self, Journal};
use crate::interrupt;
use crate::record;
use crate::record::stability::Stability;
use crate::report;
use crate::scenes::Scene;
use crate::simulate::Contestant;
use crate::study::stability::{self, Study};

/// Options of `polhode stability`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    selection: Selection,
    /// Folder to write into
    #[arg(
        long,
        value_name = "DIR",
        help = "Folder to write into [default: reports/latest/stability, reports/<subject>/stability where scenes or schemes are named]"
    )]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
    /// Maps of 256 × 256 cells and long runs of 1e7 steps
    #[arg(long)]
    full: bool,
    /// Cells along either axis of a map; 0 for no maps [default: 48, or 256 with --full]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(..=1024))]
    cells: Option<u16>,
    /// Steps of the long runs, up to 1e9; 0 for none [default: 300000, or 10000000 with --full]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(..=1_000_000_000))]
    long: Option<u64>,
    /// Go on where a killed run into the same place stopped
    #[arg(long)]
    resume: bool,
    /// Write the limits and lines that the gate and the list hold, as references/stability.json
    #[arg(long, value_name = "FILE")]
    store: Option<PathBuf>,
    /// Form of the table
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  polhode stability                                       every scheme in every built-in scene
  polhode stability --scheme peskin-rk2 --scene dzhanibekov --cells 0 --long 0
  polhode stability --full                                maps of 256 × 256 cells, 1e7 steps

The largest usable step of a scheme is the one below which every step tried is usable, in three meanings: the motion stays bounded;
its energy stays within 1 %; its orientation within 0.1 rad. Written: stability.json, stability.md and pictures.";

/// Cells of the maps and steps of the long runs, where nothing is said and with `--full`.
const CELLS: (u16, u16) = (48, 256);
const LONG: (u64, u64) = (300_000, 10_000_000);
/// The scheme of the maps where none is named, and the maps that others are drawn on beside it.
const MAPPED: &str = "peskin-rk2";
const COMPARED: [(&str, &str); 4] = [
    ("spring-damping", "semi-implicit-euler-implicit-gyro"),
    ("spring-damping", "rk4-quaternion"),
    ("free-spin-step", "semi-implicit-euler-implicit-gyro"),
    ("bounce", "rk4-quaternion"),
];

pub(super) fn stability(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (scenes, contestants) = match options.store {
        Some(_) => {
            let named = stability::LINE_SCENES.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>();
            (named?, Contestant::all())
        }
        None => {
            let all = !options.selection.names_schemes();
            (options.selection.scenes()?, options.selection.contestants(all)?)
        }
    };
    try_parent(options.out.as_ref())?;
    let out = options.out.clone().unwrap_or_else(|| options.selection.folder("latest").join("stability"));
    match &options.store {
        Some(_) => options.force.try_json(options.store.as_ref())?,
        None => report::try_folder(&out, "stability.json", &["stability.md"], options.force.given)?,
    }
    let file = options.store.clone().unwrap_or_else(|| out.join("stability.json"));
    with_journal(Some(&file), (options.resume, options.force, quiet), |journal| {
        let study = measure(options, (scenes, contestants), journal, quiet);
        match &options.store {
            Some(path) => store(study, path)?,
            None => write(options, &study, &out, quiet)?,
        }
        Ok(0)
    })
}

/// Writes what the gate and the list hold. Half of it is worth nothing to them.
fn store(study: Stability, path: &Path) -> Result<(), Failure> {
    if interrupt::requested() {
        return Ok(());
    }
    let kept = Stability {
        limits: Vec::new(),
        maps: Vec::new(),
        long_runs: Vec::new(),
        energy_law: Vec::new(),
        kink_orders: Vec::new(),
        machine: record::Machine::default(),
        made_at: String::new(),
        ..study
    };
    Ok(record::write_json(path, &kept)?)
}

fn write(options: &Options, study: &Stability, out: &Path, quiet: bool) -> Result<(), Failure> {
    // Pictures of half a study are not worth the wait.
    let pictures = !interrupt::requested();
    report::write_stability(study, out, pictures)?;
    print(&match options.format {
        Format::Text => report::stability_table(study),
        Format::Json => format!("{:#}\n", serde_json::json!(study)),
    })?;
    if !quiet {
        eprintln!("polhode: the study is {}", out.join("stability.md").display());
    }
    Ok(())
}

fn measure(
    options: &Options,
    (scenes, contestants): (Vec<Scene>, Vec<Contestant>),
    journal: Option<&Journal>,
    quiet: bool,
) -> Stability {
    let storing = options.store.is_some();
    let of_full = |pair: (u64, u64)| if options.full { pair.1 } else { pair.0 };
    let cells = options.cells.unwrap_or(if options.full { CELLS.1 } else { CELLS.0 });
    let long_steps = options.long.unwrap_or(of_full(LONG));
    let named = options.selection.names_schemes();
    let study = Study {
        maps: if cells == 0 || storing { Vec::new() } else { maps(&contestants, named) },
        cells: usize::from(cells),
        long: match long_steps {
            0 => Vec::new(),
            _ if storing => Vec::new(),
            _ if named => contestants.clone(),
            _ => Contestant::main(),
        },
        long_steps,
        scenes,
        contestants,
        journal,
        progress: &|_, _| (),
    };
    let study = with_bar(quiet, "searching", |progress| Study { progress, ..study }.run());
    Stability { machine: campaign::machine(), made_at: campaign::now(), ..study }
}

/// Every map of the schemes that were named; or of one, with some of others beside it.
fn maps(contestants: &[Contestant], named: bool) -> Vec<(&'static str, Contestant)> {
    let of = |scheme: &str| contestants.iter().find(|c| c.card.name == scheme).cloned();
    let all = |contestant: &Contestant| stability::MAP_NAMES.map(|name| (name, contestant.clone())).to_vec();
    if named {
        return contestants.iter().filter(|c| !c.is_foreign()).flat_map(all).collect();
    }
    let others = COMPARED.iter().filter_map(|(name, scheme)| Some((*name, of(scheme)?)));
    of(MAPPED).iter().flat_map(all).chain(others).collect()
}
