//! `polhode gate`: judge every claim.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use super::output::{Force, print};
use super::progress::with_bar;
use super::select::Selection;
use crate::campaign::Campaign;
use crate::gates::{self, Baseline};
use crate::record::{self, ClaimName, Records, Verdict};
use crate::report;

/// Options of `polhode gate`.
#[derive(Args, Clone, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    selection: Selection,
    /// Records whose error constants must be met to 1 %, and the error of every run [default: those on record for the built-in scenes]
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Hold every scheme to this order, in the place of what it claims
    #[arg(long, value_name = "P", value_parser = clap::value_parser!(u32).range(1..=12))]
    order: Option<u32>,
    /// Judge the evidence of this records file; nothing is run
    #[arg(long, value_name = "RECORDS", conflicts_with_all = ["schemes", "places", "named", "order"])]
    from: Option<PathBuf>,
    /// Write a JUnit report
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write annotations for GitHub Actions to stdout
    #[arg(long)]
    github: bool,
    /// Write the records
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
    /// Print what was judged of each scheme in each scene, ten lines at most
    #[arg(long)]
    verbose: bool,
}

const EXAMPLES: &str = "\
Examples:
  polhode gate                                    the main schemes in every built-in scene
  polhode gate --scheme all                       every scheme
  polhode gate --scheme euler --scene kovalevskaya --verbose
  polhode gate --scene my-body.toml --json now.json
  polhode gate --scene my-body.toml --baseline before.json   constants and every error
  polhode gate --scheme 'engine:python3 my_engine.py' --order 2
  polhode gate --from reports/latest/records.json            the same verdicts, without a run

Exit code: 0 every claim holds or is a known deviation, 1 one fails, 2 one is undecided, or
nothing was judged.";

pub(super) fn gate(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.force.try_json(options.json.as_ref())?;
    options.force.try_place(options.junit.as_ref(), |head| head.contains("<testsuites name=\"polhode\""))?;
    let baseline = match &options.baseline {
        Some(path) => Baseline::from_records(&Records::read(path)?),
        None => Baseline::built_in(),
    };
    let partners = options.baseline.is_some().then(|| baseline.clone());
    let records = match &options.from {
        Some(path) => stored(path, &baseline)?,
        None => measured(options, quiet, baseline)?,
    };
    if let Some(path) = &options.json {
        record::write_json(path, &records)?;
    }
    if let Some(path) = &options.junit {
        record::write_whole(path, report::junit(&records).as_bytes())?;
    }
    print(&report::verdict_table(&records, options.verbose))?;
    if options.github {
        print(&report::annotations(&records))?;
    }
    let code = gates::exit_code(&records.verdicts);
    let compared = partners.is_none_or(|baseline| has_partners(&baseline, &records));
    Ok(if code == 0 && !compared { 2 } else { code })
}

fn measured(options: &Options, quiet: bool, baseline: Baseline) -> Result<Records, Failure> {
    let mut contestants = options.selection.contestants(false)?;
    if let Some(order) = options.order {
        contestants = contestants.into_iter().map(|contestant| contestant.claiming(order)).collect();
    }
    let grid = Campaign::of(options.selection.scenes()?, contestants);
    Ok(with_bar(quiet, "measuring", |progress| Campaign { baseline, progress, ..grid }.run()))
}

/// The verdicts on stored evidence.
fn stored(path: &Path, baseline: &Baseline) -> Result<Records, Failure> {
    let mut records = Records::read(path)?;
    records.verdicts = gates::judge_all(&records, baseline);
    Ok(records)
}

/// Whether any row of the baseline is of a scene and scheme that were measured; says how many are not.
fn has_partners(baseline: &Baseline, records: &Records) -> bool {
    let measured = |(content, scheme): &(&str, &str)| {
        records.evidence.iter().any(|row| row.setting.content == *content && row.known_as == *scheme)
    };
    let pairs = baseline.pairs();
    let found = pairs.iter().filter(|pair| measured(pair)).count();
    if found < pairs.len() {
        let (all, missing) = (pairs.len(), pairs.len() - found);
        eprintln!("baseline: {missing} of {all} pairs of a scene and a scheme have no partner here");
    }
    if found == 0 {
        eprintln!("polhode: nothing was compared with the baseline: no scene and scheme of it was measured");
        return false;
    }
    let measured = || records.orders.iter().filter(|row| row.constant.is_some());
    let compared = measured().filter(|row| {
        let is_of =
            |v: &&Verdict| (&v.scene, &v.scheme, &v.quantity) == (&row.scene, &row.scheme, &row.quantity);
        records.verdicts.iter().filter(is_of).any(|v| v.claim == ClaimName::Constant && v.measured.is_some())
    });
    eprintln!("baseline: {} of {} constants compared", compared.count(), measured().count());
    true
}
