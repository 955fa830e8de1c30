//! `polhode gate`: judge every claim.

mod written;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use clap::Args;

use self::written::Written;
use super::Failure;
use super::exit::UNDECIDED;
use super::measured;
use super::output::{Format, painted, print};
use super::select::Selection;
use crate::campaign::Journal;
use crate::gates::{self, Baseline};
use crate::model::Quantity;
use crate::record::{ClaimName, Evidence, Ladder, Records, Ruling, Verdict};
use crate::report;

/// Options of `polhode gate`.
#[derive(Args, Clone, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    selection: Selection,
    /// Baseline that orders, constants, errors, drift and work are compared with [default: that of polhode.toml, else the
    /// constants on record]
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Hold every scheme to this order, in the place of what it claims
    #[arg(long, value_name = "P", value_parser = clap::value_parser!(u32).range(1..=12))]
    order: Option<u32>,
    /// Judge the evidence of this records file; nothing is run
    #[arg(long, value_name = "RECORDS", conflicts_with_all = ["schemes", "places", "named", "order"])]
    from: Option<PathBuf>,
    #[command(flatten)]
    written: Written,
    /// Go on where a killed run with the same --json stopped
    #[arg(long, requires = "json", conflicts_with = "from")]
    resume: bool,
    /// Time for all runs: the slowest are left out and named
    #[arg(long, value_name = "SECONDS", value_parser = super::seconds, allow_negative_numbers = true, conflicts_with = "from")]
    budget: Option<f64>,
    /// Print what was judged of each scheme in each scene, ten lines at most
    #[arg(long)]
    verbose: bool,
    /// Form of the verdicts on stdout
    #[arg(
        long,
        value_enum,
        default_value_t,
        hide_possible_values = true,
        value_name = "text|json",
        conflicts_with = "github"
    )]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  polhode gate                                    the main schemes in every built-in scene
  polhode gate --scheme all                       every scheme
  polhode gate --scheme euler --scene kovalevskaya --verbose
  polhode gate --scene my-body.toml --json now.json
  polhode gate --scene my-body.toml --baseline before.json   constants and every error
  polhode gate --scheme 'engine:python3 my_engine.py' --order 2 --budget 600
  polhode gate --from reports/latest/records.json            the same verdicts, without a run

Exit code: 0 every claim holds or is a known deviation, 1 one fails, 2 one is undecided, nothing was
judged, or nothing moves in a scene.";

pub(super) fn gate(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.written.try_places()?;
    let file = measured::baseline_file(options.baseline.as_ref());
    let baseline = measured::baseline(file)?;
    let partners = file.is_some().then(|| baseline.clone());
    let records = match &options.from {
        Some(path) => stored(path, &baseline)?,
        None => {
            let measure = |journal: Option<&Journal>| {
                let (order, budget) = (options.order, options.budget.map(Duration::from_secs_f64));
                measured::measured(&options.selection, (order, budget), baseline.clone(), journal, quiet)
            };
            return options.written.with_journal(options.resume, quiet, |journal| {
                let records = measure(journal)?;
                judged(options, partners.as_ref(), &records)
            });
        }
    };
    judged(options, partners.as_ref(), &records)
}

/// Writes and prints what was judged.
fn judged(options: &Options, partners: Option<&Baseline>, records: &Records) -> Result<u8, Failure> {
    options.written.write(records)?;
    print(&match options.format {
        Format::Text => painted(&report::verdict_table(records, options.verbose)),
        Format::Json => report::verdicts_in_json(records),
    })?;
    if options.written.github {
        print(&report::annotations(records))?;
    }
    for engine in &records.engines {
        engine.remarks.iter().for_each(|remark| eprintln!("polhode: {}: {remark}", engine.label()));
    }
    let code = gates::exit_code(&records.verdicts);
    let compared = partners.is_none_or(|baseline| has_partners(baseline, records));
    let motionless = motionless(records);
    motionless.iter().for_each(|scene| say_motionless(scene));
    Ok(if code == 0 && (!compared || !motionless.is_empty()) { UNDECIDED } else { code })
}

/// The scenes in whose motion both velocities are zero throughout.
fn motionless(records: &Records) -> BTreeSet<&str> {
    let stands = |row: &&Arc<Evidence>| {
        let Ladder { sizes, rungs, .. } = &row.ladder;
        !rungs.is_empty() && sizes[Quantity::Velocity] == 0.0 && sizes[Quantity::AngularVelocity] == 0.0
    };
    records.evidence.iter().filter(stands).map(|row| row.scene.as_str()).collect()
}

fn say_motionless(scene: &str) {
    eprintln!(
        "polhode: nothing moves in scene '{scene}', so that every scheme passes: give the body a velocity or a force"
    );
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
    said_of(records).iter().for_each(|line| eprintln!("baseline: {line}"));
    true
}

/// How many of each kind were compared, a line each.
fn said_of(records: &Records) -> Vec<String> {
    let of = |claim: ClaimName| records.verdicts.iter().filter(move |verdict| verdict.claim == claim);
    let is_compared =
        |verdict: &&Verdict| !matches!(verdict.verdict, Ruling::NotApplicable | Ruling::Inconclusive);
    let line = |claim: ClaimName, what: &str| {
        let (all, compared) = (of(claim).count(), of(claim).filter(is_compared).count());
        (all > 0).then(|| format!("{compared} of {all} {what} compared"))
    };
    let kinds = [
        (ClaimName::OrderOnRecord, "orders"),
        (ClaimName::Constant, "constants"),
        (ClaimName::ErrorOnRecord, "quantities over all runs"),
        (ClaimName::DriftOnRecord, "drifts"),
        (ClaimName::WorkOnRecord, "counts of work"),
        (ClaimName::ClaimsOnRecord, "lists of claims"),
    ];
    kinds.into_iter().filter_map(|(claim, what)| line(claim, what)).collect()
}
