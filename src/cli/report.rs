//! `polhode report`: measure, judge and draw.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use super::output::{Force, painted, print};
use super::progress::{with_bar, with_tasks};
use super::resume::with_journal;
use super::select::Selection;
use crate::campaign::{Journal, Sizes, Survey};
use crate::gates;
use crate::interrupt;
use crate::record::{Capsule, Records, write_json};
use crate::report::{self, Language, Pictures};

/// Options of `polhode report`.
#[derive(Args, Clone, Debug, Default)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// Folder to write into [default: reports/latest, or reports/<subject>]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    force: Force,
    #[command(flatten)]
    selection: Selection,
    /// Every scheme in every scene
    #[arg(long)]
    full: bool,
    /// Only what a repository can hold: report.md, key pictures, the tables as CSV, and the verdicts
    #[arg(long)]
    brief: bool,
    /// Write every picture as SVG, too
    #[arg(long, conflicts_with = "brief")]
    svg: bool,
    /// One page with everything in it, in the place of a folder of pages
    #[arg(long, conflicts_with_all = ["brief", "svg"])]
    single_file: bool,
    /// Draw this records file; nothing is run
    #[arg(long, value_name = "RECORDS", conflicts_with_all = ["schemes", "places", "named", "full"])]
    from: Option<PathBuf>,
    /// Print the tables of a paper as markdown or latex, or the verdicts as json; no folder is written
    #[arg(long, value_name = "FORM", hide_possible_values = true, value_parser = ["markdown", "latex", "json"], conflicts_with_all = ["out", "brief", "single_file"])]
    format: Option<String>,
    /// Go on where a killed run into the same folder stopped
    #[arg(long, conflicts_with_all = ["from", "format"])]
    resume: bool,
    /// Write scenes, records, version and hashes, for `polhode replay`
    #[arg(long, value_name = "FILE", conflicts_with = "from")]
    capsule: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  polhode report                                   into reports/latest: index.html, report.md, plots
  polhode report kovalevskaya                      into reports/kovalevskaya
  polhode report --scene my-body.toml --scheme peskin-rk2
  polhode report --from reports/latest/records.json --out again
  polhode report --single-file --out reports/one   one page to send
  polhode report --from reports/latest/records.json --format latex   tables of a paper, to stdout
  polhode report kovalevskaya --capsule kovalevskaya.capsule.json    polhode replay runs it again";

/// The selection; where nothing was named every scheme in three scenes, too, and costs against size.
fn survey(options: &Options) -> Result<Survey<'static>, Failure> {
    let (selection, full) = (&options.selection, options.full);
    let whole = selection.is_default();
    Ok(Survey {
        every_scheme: full || whole,
        published: whole,
        precision: whole,
        growth: whole,
        sizes: whole.then_some(if full { Sizes::Full } else { Sizes::Usual }),
        ..Survey::of(selection.scenes()?, selection.contestants(full)?)
    })
}

pub(super) fn report(options: &Options, quiet: bool) -> Result<u8, Failure> {
    options.force.try_json(options.capsule.as_ref())?;
    if let Some(name) = &options.format {
        let records = records(options, None, quiet)?;
        print(&match name.as_str() {
            "json" => report::verdicts_in_json(&records),
            "latex" => report::paper_tables(&records, Language::Latex),
            _ => report::paper_tables(&records, Language::Markdown),
        })?;
        return Ok(gates::exit_code(&records.verdicts));
    }
    let out = folder(options);
    let (file, pages) = if options.brief {
        ("verdicts.json", &["report.md"][..])
    } else {
        ("records.json", &["report.md", "index.html", "records.csv"][..])
    };
    report::try_folder(&out, file, pages, options.force.given)?;
    let whole = |journal: Option<&Journal>| -> Result<u8, Failure> {
        let records = records(options, journal, quiet)?;
        draw(options, &records, &out, quiet)?;
        Ok(gates::exit_code(&records.verdicts))
    };
    match options.from {
        Some(_) => whole(None),
        None => with_journal(Some(&out.join(file)), (options.resume, options.force, quiet), whole),
    }
}

/// Read, or measured.
fn records(options: &Options, journal: Option<&Journal>, quiet: bool) -> Result<Records, Failure> {
    match &options.from {
        Some(path) => Ok(Records::read(path)?),
        None => measured(options, journal, quiet),
    }
}

fn folder(options: &Options) -> PathBuf {
    let whole = match (options.full, options.brief) {
        (false, false) => "latest",
        (true, _) => "full",
        (false, true) => "brief",
    };
    options.out.clone().unwrap_or_else(|| options.selection.folder(whole))
}

/// Runs the survey, and writes the capsule where one is asked for.
fn measured(options: &Options, journal: Option<&Journal>, quiet: bool) -> Result<Records, Failure> {
    let survey = survey(options)?;
    let request = survey.request();
    let records = with_tasks(quiet, |progress| Survey { progress, journal, ..survey }.run());
    // Half a run is not worth running again.
    if let Some(path) = options.capsule.as_ref().filter(|_| !interrupt::requested()) {
        let texts = options.selection.texts()?;
        write_json(path, &Capsule::new(texts, request, &records))?;
    }
    Ok(records)
}

fn draw(options: &Options, records: &Records, out: &Path, quiet: bool) -> Result<(), Failure> {
    let pictures = if options.svg { Pictures::PngAndSvg } else { Pictures::Png };
    let single = options.single_file;
    with_bar(quiet, "drawing", |progress| match (interrupt::requested(), options.brief, single) {
        (true, ..) => report::write_rows(records, out),
        (_, true, _) => report::write_brief(records, out, progress),
        (.., true) => report::write_single_file(records, out, progress),
        _ => report::write_with(records, out, pictures, progress),
    })?;
    print(&painted(&report::verdict_table(records, false)))?;
    if !quiet {
        let page = match (interrupt::requested(), options.brief) {
            (true, _) => "records.json",
            (false, true) => "report.md",
            (false, false) => "index.html",
        };
        eprintln!("polhode: the report is {}", out.join(page).display());
    }
    Ok(())
}
