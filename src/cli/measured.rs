//! A campaign under the settings of the folder, for the commands that judge it.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::Failure;
use super::config::Config;
use super::progress::with_bar;
use super::select::Selection;
use crate::campaign::{Campaign, Estimate, Journal};
use crate::gates::Baseline;
use crate::record::Records;

/// The records that are compared with: those named on the command line, then those of the settings.
pub(super) fn baseline_file(named: Option<&PathBuf>) -> Option<&Path> {
    named.or(Config::current().gate.baseline.as_ref()).map(PathBuf::as_path)
}

/// What is on record, with the tolerances of the settings. Without a file it is that of the built-in scenes.
pub(super) fn baseline(file: Option<&Path>) -> Result<Baseline, Failure> {
    let baseline = match file {
        Some(path) => Baseline::from_records(&Records::read(path)?),
        None => Baseline::built_in(),
    };
    Ok(baseline.with_tolerances(Config::current().tolerances.clone()))
}

/// Measures schemes in scenes within `budget`, each scheme held to `order` or to that of the settings where there is one.
pub(super) fn measured(
    selection: &Selection,
    (order, budget): (Option<u32>, Option<Duration>),
    baseline: Baseline,
    journal: Option<&Journal>,
    quiet: bool,
) -> Result<Records, Failure> {
    let config = Config::current();
    let mut contestants = selection.contestants(false)?;
    if let Some(order) = order.or(config.gate.order) {
        contestants = contestants.into_iter().map(|contestant| contestant.claiming(order)).collect();
    }
    let grid = Campaign::of(selection.scenes()?, contestants);
    let bounds = |scene: &str, _: &str| config.bounds(scene);
    let say = |Estimate { seconds, cells, cut }: Estimate| {
        if !quiet {
            eprintln!(
                "polhode: all runs take about {seconds:.2} s; the budget cuts those of {cut} of {cells} schemes in scenes"
            );
        }
    };
    Ok(with_bar(quiet, "measuring", |progress| {
        Campaign { baseline, bounds: &bounds, budget, estimated: &say, journal, progress, ..grid }.run()
    }))
}
