//! `polhode bless`: a new baseline, with who made it and why.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::Failure;
use super::exit::UNDECIDED;
use super::measured;
use super::output::{Force, Format, print};
use super::select::Selection;
use crate::campaign;
use crate::gates::{self, Baseline};
use crate::interrupt;
use crate::record::{self, Provenance, Records, Ruling, Verdict};

/// Options of `polhode bless`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    #[command(flatten)]
    selection: Selection,
    /// Why what was measured is right
    #[arg(long, value_name = "TEXT", value_parser = reason)]
    reason: String,
    /// The baseline to write [default: that of polhode.toml, else polhode-baseline.json]
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Take these records; nothing is run
    #[arg(long, value_name = "RECORDS", conflicts_with_all = ["schemes", "places", "named"])]
    from: Option<PathBuf>,
    /// Who says so [default: the user of the system]
    #[arg(long, value_name = "NAME")]
    by: Option<String>,
    /// Form of what changes
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    force: Force,
}

const EXAMPLES: &str = "\
Examples:
  polhode bless --reason 'first baseline' --scheme 'engine:python3 my_engine.py'
  polhode bless --reason 'substeps halved' --from now.json

Written: orders, constants, the error of every run, drift and work, which polhode gate --baseline compares. Only a
baseline that this command wrote is replaced. Exit code: 0 written, 2 no order was measured: nothing is written.";

/// The file where no other is named.
const FILE: &str = "polhode-baseline.json";

fn reason(text: &str) -> Result<String, String> {
    match text.trim() {
        "" => Err("expected the reason in words".to_owned()),
        text => Ok(text.to_owned()),
    }
}

pub(super) fn bless(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let path = measured::baseline_file(options.baseline.as_ref()).unwrap_or(Path::new(FILE));
    record::try_place(path, options.force.given, record::is_own_baseline)?;
    // A pipe has no old baseline, and reading one waits for a writer.
    let old = match path.is_file().then(|| Records::read(path)) {
        Some(Err(error)) if !options.force.given => return Err(error.into()),
        old => old.and_then(Result::ok).filter(|old| !old.provenance.is_empty()),
    };
    let mut records = match &options.from {
        Some(path) => Records::read(path)?,
        None => measured::measured(&options.selection, (None, None), Baseline::default(), None, quiet)?,
    };
    if interrupt::requested() {
        return Ok(0);
    }
    if !records.orders.iter().any(|order| order.order.is_some()) {
        eprintln!(
            "polhode: no order was measured, so a baseline of it would compare nothing: nothing is written"
        );
        return Ok(UNDECIDED);
    }
    let changes = old.as_ref().map(|old| changes(&records, old));
    print(&match options.format {
        Format::Text => in_words(&records, changes.as_deref()),
        Format::Json => in_json(&records, path, changes.as_deref()),
    })?;
    // A baseline is compared by its evidence: single runs and curves are left out.
    (records.measurements, records.series) = (Vec::new(), Vec::new());
    let replaced = old.map(|old| old.provenance).unwrap_or_default();
    records.provenance = std::iter::once(provenance(options)).chain(replaced).collect();
    record::write_json(path, &records)?;
    eprintln!("polhode: the baseline is {}", path.display());
    Ok(0)
}

fn provenance(options: &Options) -> Provenance {
    let names = ["USER", "LOGNAME", "USERNAME"].iter().filter_map(|name| std::env::var(name).ok());
    let user = names.into_iter().find(|name| !name.is_empty());
    Provenance {
        who: options.by.clone().or(user).unwrap_or_else(|| "unknown".to_owned()),
        when: campaign::now(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        reason: options.reason.clone(),
    }
}

/// What the new baseline has otherwise than the old one, as verdicts against that.
fn changes(records: &Records, old: &Records) -> Vec<Verdict> {
    let changed = |verdict: &Verdict| verdict.claim.is_on_record() && verdict.verdict == Ruling::Fail;
    gates::judge_all(records, &Baseline::from_records(old)).into_iter().filter(changed).collect()
}

/// The changes, a line each; there are none to a first baseline.
fn in_words(records: &Records, changes: Option<&[Verdict]>) -> String {
    let Some(changes) = changes else {
        return format!("{} orders in a first baseline\n", records.orders.len());
    };
    let line = |v: &Verdict| format!("{} in {}, {}: {}\n", v.scheme, v.scene, v.quantity, v.detail);
    let lines: String = changes.iter().map(line).collect();
    format!("{lines}{} changes against the old baseline\n", changes.len())
}

/// As JSON, schema polhode/bless/1; `changes` is null where the baseline is the first.
fn in_json(records: &Records, path: &Path, changes: Option<&[Verdict]>) -> String {
    let (baseline, orders) = (path.display().to_string(), records.orders.len());
    let answer =
        json!({ "schema": "polhode/bless/1", "baseline": baseline, "orders": orders, "changes": changes });
    format!("{answer:#}\n")
}
