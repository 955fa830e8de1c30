//! Input files, read up to a bound: a device without an end is refused at once.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Most bytes of a scene file, a mesh of 3e5 mass points, and of a robot description.
pub const MOST_OF_A_SCENE: u64 = 64 << 20;
/// Most bytes of a trajectory that comes by a pipe, 4e6 rows of fourteen columns; a file may have any size.
#[cfg(feature = "cli")]
pub const MOST_OF_A_LOG: u64 = 1 << 30;
/// Most bytes of a records file: a hundred times those of every scheme in every scene.
pub const MOST_OF_RECORDS: u64 = 4 << 30;

/// Most bytes of an input of any kind but a log in a file, where the user states them; 0 where not.
static STATED: AtomicU64 = AtomicU64::new(0);

/// States the most MiB of an input.
#[cfg(feature = "cli")]
pub fn set_most(mebibytes: u64) {
    STATED.store(mebibytes << 20, Ordering::Relaxed);
}

/// Most bytes of an input: what the user states, or else the bound of its kind.
pub fn most(of_kind: u64) -> u64 {
    match STATED.load(Ordering::Relaxed) {
        0 => of_kind,
        stated => stated,
    }
}

/// Bytes that are looked at before the rest is read.
pub const FIRST: u64 = 1 << 16;
/// Why bytes are refused.
pub const NO_TEXT: &str = "this is not text in UTF-8";
/// How long a pipe may be without a writer.
const PATIENCE: Duration = Duration::from_secs(10);

/// Why a file was not read.
#[derive(Debug)]
enum Unread {
    /// What the system said.
    System(io::Error),
    /// It cannot be such a file: why.
    Content(String),
}

/// An input file that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Unreadable {
        /// The file.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// The file says something that such a file cannot mean.
    #[error("{file}:{line}: {why}")]
    Content {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is wrong, and what to write instead.
        why: String,
    },
}

/// Opens a file to read it.
///
/// # Errors
/// What the system says; [`io::ErrorKind::TimedOut`] where no program writes to a pipe within [`PATIENCE`].
pub fn open(path: &Path) -> io::Result<File> {
    if fs::metadata(path)?.is_file() {
        return File::open(path);
    }
    let (sender, receiver) = mpsc::channel();
    let path = path.to_owned();
    // The system lets a reader of a pipe wait for its writer, and nothing else can end that.
    thread::spawn(move || sender.send(File::open(path)));
    receiver.recv_timeout(PATIENCE).unwrap_or_else(|_| {
        let why = format!("no program writes to this pipe within {} s: start one", PATIENCE.as_secs());
        Err(io::Error::new(io::ErrorKind::TimedOut, why))
    })
}

/// Why the first bytes of a file are no text, where they are none.
pub fn no_text(first: &[u8]) -> Option<String> {
    let marked = first.starts_with(&[0xff, 0xfe]) || first.starts_with(&[0xfe, 0xff]);
    if let Some(name) = marked.then_some("UTF-16").or_else(|| unmarked(first)) {
        return Some(format!(
            "this is text in {name}: save the file as UTF-8, or convert it by iconv -f {name} -t UTF-8"
        ));
    }
    first.contains(&0).then(|| format!("{NO_TEXT}: it holds zero bytes"))
}

/// The name of UTF-16 without a byte-order mark: one byte of each pair is zero wherever the letter is one of Latin-1, as most
/// letters of numbers and names are; the other byte never is.
fn unmarked(first: &[u8]) -> Option<&'static str> {
    let pairs = first.chunks_exact(2);
    let (all, zeros) = (pairs.len(), |of: usize| pairs.clone().filter(|pair| pair[of] == 0).count());
    match (zeros(0), zeros(1)) {
        (0, high) if 2 * high > all => Some("UTF-16LE"),
        (high, 0) if 2 * high > all => Some("UTF-16BE"),
        _ => None,
    }
}

/// The text of a file.
///
/// # Errors
/// [`FileError`]: as [`read`] has them, or bytes that are not UTF-8.
pub fn text(path: &Path, of_kind: u64) -> Result<String, FileError> {
    let file = path.display().to_string();
    let bytes = read(path, most(of_kind)).map_err(|unread| match unread {
        Unread::System(source) => FileError::Unreadable { file: file.clone(), source },
        Unread::Content(why) => FileError::Content { file: file.clone(), line: 1, why },
    })?;
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + valid.iter().filter(|byte| **byte == b'\n').count();
        let why = format!("{NO_TEXT}: save the file as UTF-8");
        FileError::Content { file, line, why }
    })
}

/// The bytes of a text file.
///
/// # Errors
/// [`Unread`]: it cannot be read, holds more than `most` bytes, or holds a zero byte in its first 64 KiB, which no text does.
fn read(path: &Path, most: u64) -> Result<Vec<u8>, Unread> {
    let mut file = open(path).map_err(Unread::System)?;
    let mut bytes = Vec::new();
    file.by_ref().take(FIRST.min(most)).read_to_end(&mut bytes).map_err(Unread::System)?;
    if let Some(why) = no_text(&bytes) {
        return Err(Unread::Content(why));
    }
    let rest = most + 1 - bytes.len() as u64;
    file.take(rest).read_to_end(&mut bytes).map_err(Unread::System)?;
    if bytes.len() as u64 > most {
        return Err(Unread::Content(format!(
            "the file is larger than {} MiB: --input-limit admits more",
            most >> 20
        )));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_to_its_bound_and_no_further() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("text");
        std::fs::write(&path, "12345678").expect("written");
        assert_eq!(read(&path, 8).expect("read"), b"12345678");
        assert!(matches!(read(&path, 7), Err(Unread::Content(why)) if why.contains("larger")));
        std::fs::write(&path, "12\u{0}45678").expect("written");
        assert!(matches!(read(&path, 8), Err(Unread::Content(why)) if why.contains("zero")));
        for (bytes, name) in
            [(b"\xff\xfet\0,\0", " UTF-16 "), (b"t\0,\0x\0", " UTF-16LE "), (b"\0t\0,\0x", " UTF-16BE ")]
        {
            std::fs::write(&path, bytes).expect("written");
            assert!(matches!(read(&path, 8), Err(Unread::Content(why)) if why.contains(name)), "{name}");
        }
        assert!(matches!(read(&folder.path().join("none"), 8), Err(Unread::System(_))));
        std::fs::write(&path, b"1\n2\n\xff").expect("written");
        assert!(matches!(text(&path, 8), Err(FileError::Content { line: 3, .. })));
    }
}
