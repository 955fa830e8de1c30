//! The report: records drawn and written out for people, for build servers and for the terminal.
//!
//! This module reads [`Records`] only. It never runs a scheme: a picture cannot redo a calculation, and a report
//! can be made again from a `records.json` alone.

mod brief;
mod dashboard;
mod engines;
mod folder;
mod github;
mod html;
mod junit;
mod markdown;
mod number;
mod page;
mod paper;
mod plot;
mod published;
mod ranking;
mod sarif;
mod stability;
mod step_summary;
mod survey;
mod template;
mod text;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::interrupt;
use crate::record::{CSV_FILES, RecordError, Records, WholeFile, write_csv, write_json, write_whole};

pub use brief::{verdicts_in_json, write_brief};
pub use dashboard::{MARK as DASHBOARD_MARK, bencher, smaller_is_better};
pub use folder::try_folder;
pub use github::annotations;
pub use junit::junit;
pub use paper::{Language, paper_tables};
pub use plot::motion::motion_picture;
pub use plot::{heat_map, is_own_picture, line_chart};
pub use published::write_published;
pub use sarif::{MARK as SARIF_MARK, sarif};
pub use stability::{table as stability_table, write as write_stability};
pub use step_summary::{MARK as SUMMARY_MARK, step_summary};
pub use text::verdict_table;

use folder::Folder;
use page::Figure;
use plot::Subject;

/// A report could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file could not be written.
    #[error(transparent)]
    File(#[from] RecordError),
    /// A picture could not be drawn.
    #[error("{}: the picture could not be drawn: {why}", path.display())]
    Picture {
        /// The file that the picture was for.
        path: PathBuf,
        /// What the drawing backend said.
        why: String,
    },
    /// The user asks for the end before all pictures are drawn.
    #[error("interrupted")]
    Interrupted,
    /// A page could not be composed.
    #[error("{}: the page could not be composed: {why}", path.display())]
    Page {
        /// The file that the page was for.
        path: PathBuf,
        /// What the template engine said.
        why: String,
    },
}

/// A picture could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("the picture could not be drawn: {0}")]
pub struct DrawingError(String);

impl From<plot::Fault> for DrawingError {
    fn from(plot::Fault(why): plot::Fault) -> DrawingError {
        DrawingError(why)
    }
}

/// Writes a report of the records into a folder: `index.html`, `report.md`, `plots/*.png`, `records.json` and `records.csv`.
///
/// # Errors
/// A file cannot be written, or a picture or a page cannot be made.
pub fn write_report(records: &Records, folder: impl AsRef<Path>) -> Result<(), ReportError> {
    write(records, folder.as_ref(), &|_, _| ())
}

/// Writes `records.json`, `records.csv`, `report.md`, `index.html` and `plots/*.png` into a folder.
///
/// `progress` is called with the pictures done and the pictures in all, from several threads. Each file takes its
/// final name only when it is whole. Of an earlier report, what its manifest lists and this one has no match for is removed; files that others
/// made are never touched: one whose name is needed is kept as NAME.kept.
///
/// # Errors
/// A file cannot be written, or a picture or a page cannot be made.
pub fn write(
    records: &Records,
    out: &Path,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(), ReportError> {
    write_with(records, out, Pictures::Png, progress)
}

/// The files of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pictures {
    /// A PNG.
    Png,
    /// A PNG, and an SVG of the same look.
    PngAndSvg,
}

/// The same, with pictures as SVG where they are asked for.
///
/// # Errors
/// Those of [`write`].
pub fn write_with(
    records: &Records,
    out: &Path,
    pictures: Pictures,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(), ReportError> {
    let subjects = plot::subjects(records);
    let mut pages = ["records.json", "report.md"].map(str::to_owned).to_vec();
    pages.extend(CSV_FILES.map(str::to_owned));
    pages.extend(html::names(records));
    let folder = Folder::open(out, "records.json")?;
    folder.begin(&names(&pages, subjects.iter()))?;
    write_json(&out.join("records.json"), records)?;
    write_csv(out, records)?;
    let main = records.without_apart();
    let figures = write_pictures(records, &main, &subjects, out, progress)?;
    let page = page::compose(records, &main, &figures);
    let data = ["records.json"].into_iter().chain(CSV_FILES);
    let text = markdown::Text::new(records, &main, &page, &figures).with_data(data).whole();
    write_page(&out.join("report.md"), |file| text.render(file))?;
    html::write(records, &main, &page, out)?;
    let mut files = names(&pages, figures.iter().map(|figure| &figure.subject));
    if pictures == Pictures::PngAndSvg {
        files.extend(write_vectors(records, &main, &subjects, out)?);
    }
    Ok(folder.finish(&files)?)
}

/// Writes the records and their tables alone: a run that the user ended is not worth drawing, and the user waits.
///
/// # Errors
/// A file cannot be written.
pub fn write_rows(records: &Records, out: &Path) -> Result<(), ReportError> {
    let folder = Folder::open(out, "records.json")?;
    let mut files = names(&CSV_FILES, std::iter::empty());
    files.insert("records.json".to_owned());
    folder.begin(&files)?;
    write_json(&out.join("records.json"), records)?;
    write_csv(out, records)?;
    Ok(folder.finish(&files)?)
}

/// Writes `index.html`, one page with everything in it, and `records.json` beside it.
///
/// # Errors
/// A file cannot be written, or the picture or the page cannot be made.
pub fn write_single_file(
    records: &Records,
    out: &Path,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(), ReportError> {
    let pages = ["records.json", "index.html"].map(str::to_owned);
    let folder = Folder::open(out, "records.json")?;
    folder.begin(&names(&pages, std::iter::empty()))?;
    write_json(&out.join("records.json"), records)?;
    let main = records.without_apart();
    let path = out.join("index.html");
    let mut subjects = plot::subjects(records);
    subjects.retain(Subject::stands_for_a_page);
    let keep = |_: &Subject, png: Vec<u8>| Ok(Some(plot::base64(&png)));
    let figures = draw(records, &main, &subjects, &path, progress, &keep)?;
    html::write_single(records, &main, &page::compose(records, &main, &figures), &path)?;
    Ok(folder.finish(&names(&pages, std::iter::empty()))?)
}

/// The files of a report, by their paths in its folder.
fn names<'a>(pages: &[impl AsRef<str>], pictures: impl Iterator<Item = &'a Subject>) -> BTreeSet<String> {
    let pictures = pictures.map(|subject| format!("plots/{}", subject.file_name()));
    pages.iter().map(|page| page.as_ref().to_owned()).chain(pictures).collect()
}

/// Writes the section on foreign programs as a page of its own: `engines.md`, its pictures beside it as SVG, a
/// tenth of a PNG, and an `engines.json` of what the section is made from, without the runs behind its pictures.
///
/// # Errors
/// A file cannot be written, or a picture or the page cannot be made.
pub fn write_engines(records: &Records, out: &Path) -> Result<(), ReportError> {
    let kept = engines::kept(records);
    let subjects = plot::engine_subjects(records);
    let pictures = subjects.iter().map(|subject| subject.file_stem() + ".svg");
    let files = pictures.chain(["engines.json", "engines.md"].map(str::to_owned)).collect();
    let folder = Folder::open(out, "engines.json")?;
    folder.begin(&files)?;
    write_json(&out.join("engines.json"), &kept)?;
    let mut figures = Vec::new();
    for subject in subjects {
        let path = out.join(subject.file_stem() + ".svg");
        let fault = |plot::Fault(why)| ReportError::Picture { path: path.clone(), why };
        if let Some(picture) = plot::lay_out(records, records, &subject).map_err(fault)? {
            let svg = picture.svg().map_err(fault)?;
            write_whole(&path, plot::alone(&svg).as_bytes())?;
            figures.push(Figure { subject, data: None });
        }
    }
    write_page(&out.join("engines.md"), |file| engines::page(records, &figures, file))?;
    Ok(folder.finish(&files)?)
}

/// Writes a page as it is rendered.
fn write_page(
    path: &Path,
    render: impl FnOnce(&mut WholeFile) -> Result<(), minijinja::Error>,
) -> Result<(), ReportError> {
    let mut file = WholeFile::begin(path)?;
    render(&mut file).map_err(|error| ReportError::Page { path: path.into(), why: error.to_string() })?;
    Ok(file.finish()?)
}

/// Draws pictures and writes the PNGs. `main` is the records without the schemes that stand apart.
fn write_pictures(
    records: &Records,
    main: &Records,
    subjects: &[Subject],
    out: &Path,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Vec<Figure>, ReportError> {
    let write = |subject: &Subject, png: Vec<u8>| -> Result<Option<String>, ReportError> {
        write_whole(&out.join("plots").join(subject.file_name()), &png)?;
        Ok(None)
    };
    draw(records, main, subjects, out, progress, &write)
}

/// What becomes of a PNG: its data, where the page holds them.
type Keep<'a> = &'a (dyn Fn(&Subject, Vec<u8>) -> Result<Option<String>, ReportError> + Sync);

/// Draws pictures as PNGs.
fn draw(
    records: &Records,
    main: &Records,
    subjects: &[Subject],
    out: &Path,
    progress: &(dyn Fn(usize, usize) + Sync),
    keep: Keep,
) -> Result<Vec<Figure>, ReportError> {
    let done = AtomicUsize::new(0);
    let one = |subject: &Subject| {
        if interrupt::requested() {
            return Err(ReportError::Interrupted);
        }
        let fault = |plot::Fault(why)| ReportError::Picture { path: out.join(subject.file_name()), why };
        let figure = match plot::lay_out(records, main, subject).map_err(fault)? {
            Some(picture) => {
                let data = keep(subject, picture.png().map_err(fault)?)?;
                Some(Figure { subject: subject.clone(), data })
            }
            None => None,
        };
        progress(done.fetch_add(1, Ordering::Relaxed) + 1, subjects.len());
        Ok(figure)
    };
    let drawn: Result<Vec<Option<Figure>>, ReportError> = subjects.par_iter().map(one).collect();
    Ok(drawn?.into_iter().flatten().collect())
}

/// Writes the pictures as SVG, and gives back the names of the files.
fn write_vectors(
    records: &Records,
    main: &Records,
    subjects: &[Subject],
    out: &Path,
) -> Result<Vec<String>, ReportError> {
    let one = |subject: &Subject| {
        if interrupt::requested() {
            return Err(ReportError::Interrupted);
        }
        let name = format!("plots/{}.svg", subject.file_stem());
        let path = out.join(&name);
        let fault = |plot::Fault(why)| ReportError::Picture { path: path.clone(), why };
        let Some(picture) = plot::lay_out(records, main, subject).map_err(fault)? else { return Ok(None) };
        write_whole(&path, plot::alone(&picture.svg().map_err(fault)?).as_bytes())?;
        Ok(Some(name))
    };
    let written: Result<Vec<Option<String>>, ReportError> = subjects.par_iter().map(one).collect();
    Ok(written?.into_iter().flatten().collect())
}
