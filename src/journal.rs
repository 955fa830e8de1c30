//! Finished rows of a run on disk, a line each, so that a run that is killed goes on from there.
//!
//! The first line names the schema, the version and the build: another build may measure otherwise. A line that is cut is not read. A row is
//! found by all that determines it. The file appears with the first row, and is locked while a run writes it.

use std::collections::HashMap;
use std::convert::Infallible;
use std::fmt::Debug;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize};

use crate::interrupt;

/// The schema of the file.
const SCHEMA: &str = "polhode/rows/1";
/// Bytes of a file that are read at once.
const CHUNK: usize = 1 << 16;

/// The first line.
#[derive(PartialEq, Serialize, Deserialize)]
struct Heading {
    schema: String,
    polhode: String,
    build: String,
}

/// Any other line.
#[derive(Serialize, Deserialize)]
struct Line<R> {
    key: String,
    row: R,
}

/// What becomes of the rows of a run that did not end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Earlier {
    /// They are in the way.
    Refused,
    /// The run goes on from them.
    Kept,
    /// They are measured anew.
    Dropped,
}

/// A journal cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// The file cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// Rows of a run that did not end are there.
    #[error(
        "{}: {rows} finished rows of a run that did not end: --resume goes on from them, --force measures them anew",
        path.display()
    )]
    Unfinished {
        /// The file.
        path: PathBuf,
        /// Finished rows.
        rows: usize,
    },
    /// Another run writes the file.
    #[error("{}: another run is writing this file", path.display())]
    Busy {
        /// The file.
        path: PathBuf,
    },
}

/// The file behind a journal.
enum Sink {
    /// No row is written yet, and no file is there.
    Unopened,
    Open(File),
    /// A row could not be written.
    Lost,
}

/// A file of finished rows, of whatever types.
pub struct Journal {
    path: PathBuf,
    /// The lines of an earlier run, by their keys.
    known: HashMap<String, String>,
    sink: Mutex<Sink>,
}

impl Journal {
    /// Opens the file, which need not be there. Rows of another build are not kept.
    ///
    /// # Errors
    /// [`JournalError`]: the file cannot be read or written, another run writes it, or its rows are in the way.
    pub fn open(path: &Path, earlier: Earlier) -> Result<Journal, JournalError> {
        let fail = |source| JournalError::File { path: path.into(), source };
        let mut file = match OpenOptions::new().read(true).append(true).open(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Journal::without_rows(path)),
            other => other.map_err(fail)?,
        };
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(JournalError::Busy { path: path.into() });
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(fail)?;
        // What stands after the last end of a line is cut.
        bytes.truncate(bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1));
        let text = String::from_utf8_lossy(&bytes);
        let (heading, lines) = text.split_once('\n').unwrap_or_default();
        let heading: Option<Heading> = serde_json::from_str(heading).ok();
        let is_ours = heading.as_ref().is_some_and(|heading| heading.schema == SCHEMA);
        if !is_ours && !text.is_empty() && earlier != Earlier::Dropped {
            return Err(fail(io::Error::new(io::ErrorKind::InvalidData, "this is no file of rows")));
        }
        let rows = lines.lines().filter_map(|line| Some((key(line)?, line.to_owned())));
        let known: HashMap<String, String> = rows.collect();
        if earlier == Earlier::Refused && !known.is_empty() {
            return Err(JournalError::Unfinished { path: path.into(), rows: known.len() });
        }
        if earlier != Earlier::Kept || heading != Some(Heading::own()) {
            fs::remove_file(path).map_err(fail)?;
            return Ok(Journal::without_rows(path));
        }
        file.set_len(bytes.len() as u64).map_err(fail)?;
        Ok(Journal { path: path.into(), known, sink: Mutex::new(Sink::Open(file)) })
    }

    fn without_rows(path: &Path) -> Journal {
        Journal { path: path.into(), known: HashMap::new(), sink: Mutex::new(Sink::Unopened) }
    }

    /// How many rows of an earlier run there are.
    pub fn len(&self) -> usize {
        self.known.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.known.is_empty()
    }

    /// A row of an earlier run.
    fn find<R: DeserializeOwned>(&self, key: &str) -> Option<R> {
        let line: Line<R> = serde_json::from_str(self.known.get(key)?).ok()?;
        Some(line.row)
    }

    /// Takes in a finished row. A full disk costs the journal and not the run.
    fn add<R: Serialize>(&self, key: String, row: &R) {
        let line = line(&Line { key, row });
        let mut sink = self.sink.lock().unwrap_or_else(PoisonError::into_inner);
        if let Err(error) = line.and_then(|line| self.write(&mut sink, &line)) {
            eprintln!("polhode: {}: {error}: what follows cannot be resumed", self.path.display());
            *sink = Sink::Lost;
        }
    }

    /// One write a line: a process that is killed leaves whole lines, but for the last one.
    fn write(&self, sink: &mut Sink, line: &[u8]) -> io::Result<()> {
        if let Sink::Unopened = sink {
            let file = OpenOptions::new().create(true).append(true).open(&self.path)?;
            // A folder whose system knows no locks is written to all the same.
            let _ = file.try_lock();
            *sink = Sink::Open(file);
            self.write(sink, &self::line(&Heading::own())?)?;
        }
        if let Sink::Open(file) = sink { file.write_all(line) } else { Ok(()) }
    }

    /// Removes the file when all that it holds is in the records.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn finish(self) -> Result<(), JournalError> {
        match fs::remove_file(&self.path) {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                Err(JournalError::File { path: self.path, source })
            }
            _ => Ok(()),
        }
    }
}

/// The row of an earlier run that `key` determines.
pub(crate) fn known<R: DeserializeOwned>(journal: Option<&Journal>, key: &impl Debug) -> Option<R> {
    journal.filter(|journal| !journal.is_empty())?.find(&format!("{key:?}"))
}

/// The row that `key` determines: that of an earlier run, or one that is measured now and kept. `None` where the user asks for the end: what
/// runs at that moment is not whole.
pub(crate) fn row<R: Serialize + DeserializeOwned>(
    journal: Option<&Journal>,
    key: &impl Debug,
    measure: impl FnOnce() -> R,
) -> Option<R> {
    let infallible = || Ok::<R, Infallible>(measure());
    try_row(journal, key, infallible).map(|Ok(row)| row)
}

/// The same where a measurement may fail: an error is no row.
pub(crate) fn try_row<R: Serialize + DeserializeOwned, E>(
    journal: Option<&Journal>,
    key: &impl Debug,
    measure: impl FnOnce() -> Result<R, E>,
) -> Option<Result<R, E>> {
    let kept = journal.map(|journal| (journal, format!("{key:?}")));
    if let Some(known) = kept.as_ref().and_then(|(journal, key)| journal.find(key)) {
        return Some(Ok(known));
    }
    let row = (!interrupt::requested()).then(measure).filter(|_| !interrupt::requested())?;
    if let (Some((journal, key)), Ok(row)) = (kept, &row) {
        journal.add(key, row);
    }
    Some(row)
}

impl Heading {
    fn own() -> Heading {
        Heading { schema: SCHEMA.to_owned(), polhode: env!("CARGO_PKG_VERSION").to_owned(), build: build() }
    }
}

/// A fingerprint of the running program, which holds the schemes.
fn build() -> String {
    std::env::current_exe().and_then(|program| fingerprint(&program)).unwrap_or_default()
}

/// A fingerprint of the content of a file.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn fingerprint(path: &Path) -> io::Result<String> {
    let mut file = BufReader::with_capacity(CHUNK, File::open(path)?);
    let mut hasher = DefaultHasher::new();
    loop {
        let chunk = file.fill_buf()?;
        if chunk.is_empty() {
            return Ok(format!("{:016x}", hasher.finish()));
        }
        let length = chunk.len();
        hasher.write(chunk);
        file.consume(length);
    }
}

/// The key of a whole line.
fn key(line: &str) -> Option<String> {
    let line: Line<IgnoredAny> = serde_json::from_str(line).ok()?;
    Some(line.key)
}

/// A value as a line.
fn line(value: &impl Serialize) -> io::Result<Vec<u8>> {
    let mut line = serde_json::to_vec(value)?;
    line.push(b'\n');
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(path: &Path, earlier: Earlier, keys: std::ops::Range<u64>) -> (Journal, Vec<u64>) {
        let journal = Journal::open(path, earlier).expect("opened");
        let measured = Mutex::new(Vec::new());
        for key in keys {
            let found: Option<Vec<f64>> = row(Some(&journal), &("row", key), || {
                measured.lock().expect("a lock").push(key);
                vec![0.1 * key as f64]
            });
            assert_eq!(found, Some(vec![0.1 * key as f64]));
        }
        (journal, measured.into_inner().expect("a lock"))
    }

    #[test]
    fn rows_of_a_run_that_did_not_end_are_kept_but_for_the_one_that_is_cut() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("now.json.rows");
        assert!(Journal::open(&path, Earlier::Refused).is_ok() && !path.exists());
        drop(measured(&path, Earlier::Refused, 0..3));
        let refused = Journal::open(&path, Earlier::Refused);
        assert!(matches!(refused, Err(JournalError::Unfinished { rows: 3, .. })));
        let text = fs::read(&path).expect("rows");
        fs::write(&path, &text[..text.len() - 3]).expect("written");
        let (journal, anew) = measured(&path, Earlier::Kept, 0..5);
        assert_eq!((journal.len(), anew), (2, vec![2, 3, 4]));
        assert!(matches!(Journal::open(&path, Earlier::Kept), Err(JournalError::Busy { .. })));
        drop(journal);
        let (journal, anew) = measured(&path, Earlier::Kept, 0..5);
        assert_eq!((journal.len(), anew), (5, Vec::new()));
        journal.finish().expect("removed");
        assert!(!path.exists());
    }

    #[test]
    fn rows_of_another_build_and_rows_that_are_dropped_are_measured_anew() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("now.json.rows");
        drop(measured(&path, Earlier::Refused, 0..3));
        let (journal, anew) = measured(&path, Earlier::Dropped, 0..3);
        assert_eq!((journal.len(), anew.len()), (0, 3));
        drop(journal);
        let other = fs::read_to_string(&path).expect("rows").replacen(&build(), "0123456789abcdef", 1);
        fs::write(&path, other).expect("written");
        let (journal, anew) = measured(&path, Earlier::Kept, 0..3);
        assert_eq!((journal.len(), anew.len()), (0, 3));
    }
}
