//! Standard output, and the files that a command is asked to write.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use crate::record;

/// Whether a file of another origin may be overwritten.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(super) struct Force {
    /// Overwrite files that this program did not write
    #[arg(long = "force")]
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

    /// The same for a picture, which is of this command where its table is.
    pub(super) fn try_picture(self, path: Option<&Path>) -> Result<(), Failure> {
        let tried = path.map(|path| record::try_place(path, self.given, |_| false)).transpose();
        Ok(tried.map(drop)?)
    }
}

/// Writes text to stdout. A reader that has gone away, as `head` does, is no failure.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(|source| Failure::Write { name: "stdout".to_owned(), source }),
    }
}
