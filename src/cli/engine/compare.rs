//! `polhode engine compare`: foreign programs beside one another and beside our schemes, as a separate page.

use std::path::PathBuf;

use clap::Args;

use crate::campaign::{self, Campaign};
use crate::cli::Failure;
use crate::cli::output::{Force, Format, Listing, print, try_parent};
use crate::cli::progress::with_bar;
use crate::cli::select::Selection;
use crate::record::{PeerRow, Records};
use crate::report;

/// Options of `polhode engine compare`.
#[derive(Args, Clone, Debug)]
pub(super) struct Options {
    /// Folder to write engines.md, engines.json and pictures into [default: reports/engines]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
    #[command(flatten)]
    selection: Selection,
    /// Form of the table
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

pub(super) fn compare(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (scenes, contestants) = (options.selection.scenes()?, options.selection.contestants(false)?);
    if !contestants.iter().any(|contestant| contestant.program().is_some()) {
        let how = "name at least one engine: --scheme 'engine:python3 my_engine.py'";
        return Err(Failure::Usage(how.to_owned()));
    }
    try_parent(options.out.as_ref())?;
    let out = options.out.clone().unwrap_or_else(|| PathBuf::from("reports/engines"));
    report::try_folder(&out, "engines.json", &["engines.md"], options.force.given)?;
    let grid = Campaign::of(scenes.clone(), contestants.clone());
    let mut records = with_bar(quiet, "measuring", |progress| Campaign { progress, ..grid }.run());
    with_bar(quiet, "comparing", |progress| {
        campaign::add_peers(&mut records, &scenes, &contestants, None, progress);
    });
    report::write_engines(&records, &out)?;
    print(&table(&records).write(options.format))?;
    if !quiet {
        eprintln!("polhode: the page is {}", out.join("engines.md").display());
    }
    Ok(0)
}

/// The errors of everyone at equal steps; a program by the name that it gives itself.
fn table(records: &Records) -> Listing {
    let number = |value: Option<f64>| value.map_or("–".to_owned(), |value| format!("{value:.2e}"));
    let name = |scheme: &str| {
        let engine = records.engines.iter().find(|engine| engine.scheme == scheme);
        engine.map_or_else(|| scheme.to_owned(), |engine| engine.label())
    };
    let row = |row: &PeerRow| {
        [
            row.scene.clone(),
            name(&row.scheme),
            format!("{:.1e}", row.step_s),
            number(row.orientation_end_rad),
            number(row.position_end_m),
            number(row.rotational_energy_max),
            row.nanoseconds_per_step.map_or("–".to_owned(), |cost| format!("{cost:.0}")),
            row.why.clone().unwrap_or_default(),
        ]
    };
    let header = ["scene", "scheme", "step s", "angle rad", "position m", "energy", "ns a step", "why"];
    Listing::of(header, records.peers.iter().map(row))
}
