//! Standard output, and the files that a command is asked to write.

use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Args, ValueEnum};
use comfy_table::Table;
use serde_json::Value;

use super::Failure;
use crate::record;
use crate::report;

/// Whether a file of another origin may be overwritten.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(super) struct Force {
    /// Overwrite files that this program did not write
    #[arg(long = "force", hide_short_help = true)]
    pub(super) given: bool,
}

impl Force {
    /// Tries the place of a file before work begins; `own` tells from its beginning whether it is one of this command.
    pub(super) fn try_place(self, path: Option<&PathBuf>, own: impl Fn(&str) -> bool) -> Result<(), Failure> {
        let tried = path.map(|path| record::try_place(path, self.given, own)).transpose();
        Ok(tried.map(drop)?)
    }

    /// The same for a JSON file.
    pub(super) fn try_json(self, path: Option<&PathBuf>) -> Result<(), Failure> {
        self.try_place(path, record::is_own_json)
    }

    /// The same for a picture.
    pub(super) fn try_picture(self, path: Option<&PathBuf>) -> Result<(), Failure> {
        self.try_place(path, report::is_own_picture)
    }
}

/// Refuses a folder that would have to be made in another one that is not there: its name is mistyped.
pub(super) fn try_parent(folder: Option<&PathBuf>) -> Result<(), Failure> {
    let missing = |folder: &&PathBuf| {
        folder.parent().is_some_and(|parent| !parent.as_os_str().is_empty() && !parent.is_dir())
    };
    match folder.filter(missing) {
        Some(folder) => Err(Failure::Write {
            name: folder.display().to_string(),
            source: io::Error::new(io::ErrorKind::NotFound, "the folder that it is to be in does not exist"),
        }),
        None => Ok(()),
    }
}

/// Width of a list where no terminal is narrower.
const WIDTH: usize = 100;

/// Columns of a list: those of the terminal that stdout is, and 100 at the most.
fn width() -> usize {
    Table::new().width().map_or(WIDTH, |columns| WIDTH.min(columns.into()))
}

/// Rows for people and for programs.
pub(super) struct Listing {
    header: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

/// Form of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// For people
    #[default]
    Text,
    /// An object a row
    Json,
}

impl Listing {
    /// A table of these columns.
    pub(super) fn of<const N: usize>(
        header: [&'static str; N],
        rows: impl Iterator<Item = [String; N]>,
    ) -> Listing {
        Listing { header: header.to_vec(), rows: rows.map(|row| row.to_vec()).collect() }
    }

    /// In a form.
    pub(super) fn write(&self, format: Format) -> String {
        match format {
            Format::Text => self.text(),
            Format::Json => format!("{:#}\n", self.json()),
        }
    }

    fn json(&self) -> Value {
        let keys = || self.header.iter().map(|name| name.replace(' ', "_"));
        let object = |row: &Vec<String>| keys().zip(row.iter().cloned().map(Value::String)).collect();
        self.rows.iter().map(object).collect::<Vec<serde_json::Map<String, Value>>>().into()
    }

    /// Columns two blanks apart, a row a line of [`width`]: the last column is cut where it is too long.
    pub(super) fn text(&self) -> String {
        let header: Vec<String> = self.header.iter().map(|name| (*name).to_owned()).collect();
        let length = |text: &String| text.chars().count();
        let rows = || std::iter::once(&header).chain(&self.rows);
        let last = header.len() - 1;
        let widths: Vec<usize> =
            (0..last).map(|column| rows().map(|row| length(&row[column])).max().unwrap_or(0)).collect();
        let left = width().saturating_sub(widths.iter().map(|width| width + 2).sum());
        let mut text = String::new();
        for row in rows() {
            for (cell, width) in row.iter().zip(&widths) {
                text += &format!("{cell:width$}  ");
            }
            if length(&row[last]) > left {
                text.extend(row[last].chars().take(left.saturating_sub(1)));
                text += "…\n";
            } else {
                text += &format!("{}\n", row[last]);
            }
        }
        text
    }
}

static COLOURED: AtomicBool = AtomicBool::new(false);

/// Whether pass and fail are coloured on stdout.
pub(super) fn set_colour(coloured: bool) {
    COLOURED.store(coloured, Ordering::Relaxed);
}

/// The words of outcomes, and their colours as terminals number them: green, red and yellow.
const OUTCOMES: [(&str, u8); 5] =
    [("known deviation", 33), ("inconclusive", 33), ("broken", 31), ("fail", 31), ("pass", 32)];

/// The verdicts in colour where that is wanted: the first outcome of each line.
pub(super) fn painted(text: &str) -> String {
    if !COLOURED.load(Ordering::Relaxed) {
        return text.to_owned();
    }
    text.split_inclusive('\n').map(painted_line).collect()
}

fn painted_line(line: &str) -> String {
    let is_word = |place: usize, word: &str| {
        let before =
            line[..place].chars().next_back().is_none_or(|letter| !letter.is_alphanumeric() && letter != '-');
        let after = line[place + word.len()..].chars().next();
        before && after.is_none_or(|letter| !letter.is_alphanumeric() && letter != '-')
    };
    let found = |(word, colour): &(&str, u8)| {
        let place = line.find(*word).filter(|place| is_word(*place, word))?;
        Some((place, word.len(), *colour))
    };
    match OUTCOMES.iter().filter_map(found).min() {
        Some((place, length, colour)) => {
            let (before, rest) = line.split_at(place);
            let (word, after) = rest.split_at(length);
            format!("{before}\u{1b}[{colour}m{word}\u{1b}[0m{after}")
        }
        None => line.to_owned(),
    }
}

/// Writes text to stdout. A reader that has gone away, as `head` does, is no failure.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(|source| Failure::Write { name: "stdout".to_owned(), source }),
    }
}
