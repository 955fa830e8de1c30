//! The files that a gate writes for build servers.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use crate::campaign::Journal;
use crate::cli::Failure;
use crate::cli::output::Force;
use crate::cli::resume::with_journal;
use crate::record::{self, Records};
use crate::report;

/// Files for build servers.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct Written {
    /// Write the records
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a JUnit report
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Write a summary in Markdown, what got worse first
    #[arg(long, hide_short_help = true, value_name = "FILE")]
    markdown: Option<PathBuf>,
    /// Write SARIF 2.1.0
    #[arg(long, hide_short_help = true, value_name = "FILE")]
    sarif: Option<PathBuf>,
    /// Write constants, drift and work for github-action-benchmark (customSmallerIsBetter)
    #[arg(long, hide_short_help = true, value_name = "FILE")]
    benchmark: Option<PathBuf>,
    /// Write the same for Bencher
    #[arg(long, hide_short_help = true, value_name = "FILE")]
    bencher: Option<PathBuf>,
    /// Annotate for GitHub Actions, and add the summary to $GITHUB_STEP_SUMMARY
    #[arg(long)]
    pub(super) github: bool,
    #[command(flatten)]
    force: Force,
}

impl Written {
    /// Tries every place before anything is measured.
    pub(super) fn try_places(&self) -> Result<(), Failure> {
        let force = self.force;
        let is_dashboard = |head: &str| {
            let compact: String = head.chars().filter(|letter| !letter.is_whitespace()).take(64).collect();
            let mark = report::DASHBOARD_MARK;
            compact.starts_with(&format!("[{{\"extra\":\"{mark}"))
                || compact.starts_with(&format!("{{\"{mark}/"))
        };
        force.try_json(self.json.as_ref())?;
        force.try_place(self.junit.as_ref(), |head| head.contains("<testsuites name=\"polhode\""))?;
        force.try_place(self.markdown.as_ref(), |head| head.starts_with(report::SUMMARY_MARK))?;
        force.try_place(self.sarif.as_ref(), |head| head.contains(report::SARIF_MARK))?;
        force.try_place(self.benchmark.as_ref(), is_dashboard)?;
        force.try_place(self.bencher.as_ref(), is_dashboard)
    }

    /// Does work that keeps its finished rows beside the records, until those are written.
    pub(super) fn with_journal(
        &self,
        resume: bool,
        quiet: bool,
        work: impl FnOnce(Option<&Journal>) -> Result<u8, Failure>,
    ) -> Result<u8, Failure> {
        with_journal(self.json.as_deref(), (resume, self.force, quiet), work)
    }

    /// Writes what was asked for.
    pub(super) fn write(&self, records: &Records) -> Result<(), Failure> {
        if let Some(path) = &self.json {
            record::write_json(path, records)?;
        }
        let write = |path: &Option<PathBuf>, text: fn(&Records) -> String| {
            path.as_ref().map_or(Ok(()), |path| record::write_whole(path, text(records).as_bytes()))
        };
        write(&self.junit, report::junit)?;
        write(&self.markdown, report::step_summary)?;
        write(&self.sarif, report::sarif)?;
        write(&self.benchmark, report::smaller_is_better)?;
        write(&self.bencher, report::bencher)?;
        if self.github { add_step_summary(records) } else { Ok(()) }
    }
}

/// Adds to the summary of the running step, where GitHub Actions runs one: other commands of the step write to the same file.
fn add_step_summary(records: &Records) -> Result<(), Failure> {
    let Some(path) = std::env::var_os("GITHUB_STEP_SUMMARY").filter(|path| !path.is_empty()) else {
        return Ok(());
    };
    let fail = |source| Failure::Write { name: path.to_string_lossy().into_owned(), source };
    let mut file = OpenOptions::new().create(true).append(true).open(&path).map_err(fail)?;
    file.write_all(report::step_summary(records).as_bytes()).map_err(fail)
}
