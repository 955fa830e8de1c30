//! Finished rows beside the file of a command, so that a run that was killed goes on from there.

use std::path::{Path, PathBuf};

use super::Failure;
use super::output::Force;
use crate::campaign::{Earlier, Journal};
use crate::interrupt;
use crate::record::{self, is_own_json};

/// Does work that keeps its finished rows in FILE.rows until all is written. Nothing is kept beside a device or a pipe.
pub(super) fn with_journal(
    file: Option<&Path>,
    (resume, force, quiet): (bool, Force, bool),
    work: impl FnOnce(Option<&Journal>) -> Result<u8, Failure>,
) -> Result<u8, Failure> {
    let Some(path) = file.filter(|path| !path.exists() || path.is_file()).map(rows_of) else {
        return work(None);
    };
    // A run that is killed as it makes the file leaves an empty one.
    force.try_place(Some(&path), |head| head.is_empty() || is_own_json(head))?;
    let earlier = match (resume, force.given) {
        (true, _) => Earlier::Kept,
        (false, true) => Earlier::Dropped,
        (false, false) => Earlier::Refused,
    };
    let journal = Journal::open(&path, earlier)?;
    record::rows_are_kept();
    if resume && !quiet {
        eprintln!("polhode: {} rows of {} are kept", journal.len(), path.display());
    }
    let code = work(Some(&journal))?;
    if !interrupt::requested() {
        journal.finish()?;
    } else if path.exists() && !quiet {
        eprintln!("polhode: --resume goes on from {}", path.display());
    }
    Ok(code)
}

/// Where the finished rows of a file stand.
fn rows_of(file: &Path) -> PathBuf {
    let mut rows = file.as_os_str().to_owned();
    rows.push(".rows");
    PathBuf::from(rows)
}
