//! Finished cells of a campaign on disk, a line each, so that a run that was killed goes on from there.
//!
//! The first line names the schema and the version. A line that was cut is not read. A cell is found again by all that determines it but the
//! baseline: verdicts are judged anew.

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};

use super::cell::Cell;

/// The schema of the file.
const SCHEMA: &str = "polhode/rows/1";

/// The first line.
#[derive(Serialize, Deserialize)]
struct Heading {
    schema: String,
    polhode: String,
}

/// Any other line.
#[derive(Serialize, Deserialize)]
struct Line<C> {
    key: String,
    cell: C,
}

/// A file of finished cells.
pub struct Journal {
    path: PathBuf,
    known: HashMap<String, Cell>,
    file: Mutex<File>,
}

impl Journal {
    /// Opens the file; with `resume` the cells that it holds are kept, where this version wrote them.
    ///
    /// # Errors
    /// The file cannot be read or written.
    pub fn open(path: &Path, resume: bool) -> io::Result<Journal> {
        let known = if resume { known(path)? } else { HashMap::new() };
        let mut file = File::create(path)?;
        let heading = Heading { schema: SCHEMA.to_owned(), polhode: env!("CARGO_PKG_VERSION").to_owned() };
        write_line(&mut file, &heading)?;
        for (key, cell) in &known {
            write_line(&mut file, &Line { key: key.clone(), cell })?;
        }
        let file = OpenOptions::new().append(true).open(path)?;
        Ok(Journal { path: path.into(), known, file: Mutex::new(file) })
    }

    /// How many cells were found.
    pub fn len(&self) -> usize {
        self.known.len()
    }

    /// Whether no cell was found.
    pub fn is_empty(&self) -> bool {
        self.known.is_empty()
    }

    /// A cell that was finished before.
    pub(super) fn find(&self, key: &str) -> Option<&Cell> {
        self.known.get(key)
    }

    /// Takes in a finished cell. A full disk costs the journal and not the run.
    pub(super) fn add(&self, key: String, cell: &Cell) {
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        if let Err(error) = write_line(&mut file, &Line { key, cell }) {
            eprintln!("polhode: {}: {error}: this cell cannot be resumed", self.path.display());
        }
    }

    /// Removes the file when all that it holds is in the records.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn finish(self) -> io::Result<()> {
        std::fs::remove_file(&self.path)
    }
}

/// The whole lines of a file; none where there is no file, or where another version wrote it.
fn known(path: &Path) -> io::Result<HashMap<String, Cell>> {
    let file = match File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(HashMap::new()),
        other => other?,
    };
    let mut lines = BufReader::new(file).lines();
    let heading = lines.next().transpose()?.and_then(|line| serde_json::from_str::<Heading>(&line).ok());
    let own = heading
        .is_some_and(|heading| heading.schema == SCHEMA && heading.polhode == env!("CARGO_PKG_VERSION"));
    if !own {
        return Ok(HashMap::new());
    }
    let cells = lines.map_while(Result::ok).filter_map(|line| serde_json::from_str::<Line<Cell>>(&line).ok());
    Ok(cells.map(|line| (line.key, line.cell)).collect())
}

/// One write a line: a process that is killed leaves whole lines, but for the last one.
fn write_line(file: &mut File, value: &impl Serialize) -> io::Result<()> {
    let mut line = serde_json::to_string(value)?;
    line.push('\n');
    file.write_all(line.as_bytes())
}
