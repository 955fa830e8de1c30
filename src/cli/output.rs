//! Standard output.

use std::io::{self, Write};

use super::Failure;

/// Writes text to stdout. A reader that has gone away, as `head` does, is no failure.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        other => other.map_err(|source| Failure::Write { name: "stdout".to_owned(), source }),
    }
}
