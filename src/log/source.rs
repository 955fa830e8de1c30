//! The bytes of a log, some whole lines at a time: a file of any size is read in constant memory.
//!
//! What cannot be read twice, as a pipe, is copied first: to memory where it is short, else to a temporary file, up to a bound.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

use crate::bounded::{self, FIRST, FileError, MOST_OF_A_LOG};

/// Bytes that are read at a time.
pub(super) const CHUNK: usize = 8 << 20;
/// Most bytes of a line: a row of four thousand columns has a hundredth of them.
pub(super) const MOST_OF_A_LINE: usize = 16 << 20;

/// What a log is read from.
#[derive(Debug)]
pub(super) enum Source<'a> {
    Bytes(Cow<'a, [u8]>),
    File { file: File, length: u64 },
}

impl Source<'_> {
    /// Opens a file.
    ///
    /// # Errors
    /// [`FileError`]: it cannot be read, begins with zero bytes, or is a pipe of more than [`MOST_OF_A_LOG`] bytes.
    pub fn open(path: &Path) -> Result<Source<'static>, FileError> {
        let name = path.display().to_string();
        let unreadable = |source| FileError::Unreadable { file: name.clone(), source };
        let refuse = |why: String| FileError::Content { file: name.clone(), line: 1, why };
        let mut file = bounded::open(path).map_err(unreadable)?;
        let about = file.metadata().map_err(unreadable)?;
        let mut first = Vec::new();
        Read::take(&file, FIRST).read_to_end(&mut first).map_err(unreadable)?;
        if let Some(why) = bounded::no_text(&first) {
            return Err(refuse(why));
        }
        if about.is_file() {
            file.rewind().map_err(unreadable)?;
            return Ok(Source::File { file, length: about.len() });
        }
        let copy = copied(first, file).map_err(unreadable)?;
        copy.ok_or_else(|| {
            let most = bounded::most(MOST_OF_A_LOG) >> 20;
            refuse(format!(
                "more than {most} MiB come by a pipe: write a file, which may have any size, or admit more by --input-limit"
            ))
        })
    }

    /// Bytes in all.
    pub fn length(&self) -> u64 {
        match self {
            Source::Bytes(bytes) => bytes.len() as u64,
            Source::File { length, .. } => *length,
        }
    }

    /// So many bytes from a place on, or fewer at the end.
    pub fn some(&self, from: u64, most: usize) -> io::Result<Vec<u8>> {
        let mut some = Vec::new();
        self.append(from, most, &mut some)?;
        Ok(some)
    }

    /// Appends them to a buffer, which grows by no more than the file has.
    fn append(&self, from: u64, most: usize, buffer: &mut Vec<u8>) -> io::Result<()> {
        match self {
            Source::Bytes(bytes) => {
                let from = usize::try_from(from).unwrap_or(usize::MAX).min(bytes.len());
                buffer.extend_from_slice(&bytes[from..bytes.len().min(from.saturating_add(most))]);
            }
            Source::File { file, length } => {
                let mut file = file;
                file.seek(SeekFrom::Start(from))?;
                let left = length.saturating_sub(from);
                buffer.reserve(usize::try_from(left).map_or(most, |left| left.min(most)));
                file.take(most as u64).read_to_end(buffer)?;
            }
        }
        Ok(())
    }

    /// Hands over the lines from a place on, whole ones but for the last of the file and one that is longer than [`MOST_OF_A_LINE`], until
    /// `take` says that it has enough.
    pub fn lines(&self, from: u64, take: &mut dyn FnMut(&[u8]) -> bool) -> io::Result<()> {
        let (mut at, mut buffer) = (from, Vec::new());
        loop {
            let had = buffer.len();
            self.append(at, CHUNK, &mut buffer)?;
            let more = &buffer[had..];
            at += more.len() as u64;
            let ended = more.is_empty();
            let end = match more.iter().rposition(|byte| *byte == b'\n') {
                _ if ended || buffer.len() > MOST_OF_A_LINE => buffer.len(),
                Some(place) => had + place + 1,
                None => continue,
            };
            if end > 0 && !take(&buffer[..end]) || ended {
                return Ok(());
            }
            buffer.drain(..end);
        }
    }
}

/// What was read and what follows; `None` where that is too much.
fn copied(mut first: Vec<u8>, rest: File) -> io::Result<Option<Source<'static>>> {
    let most = bounded::most(MOST_OF_A_LOG);
    let left = most.saturating_sub(first.len() as u64);
    Read::take(&rest, CHUNK as u64).read_to_end(&mut first)?;
    if first.len() < CHUNK {
        let fits = first.len() as u64 <= most;
        return Ok(fits.then(|| Source::Bytes(first.into())));
    }
    let mut file = tempfile::tempfile()?;
    file.write_all(&first)?;
    let length = first.len() as u64 + io::copy(&mut Read::take(&rest, left), &mut file)?;
    Ok((length <= most).then_some(Source::File { file, length }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_a_file_and_of_a_text_are_the_same_and_whole() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("log");
        let line = "0123456789,".repeat(100) + "\n";
        let text = line.repeat(3 * CHUNK / line.len()) + "end";
        std::fs::write(&path, &text).expect("written");
        for source in [Source::open(&path).expect("a file"), Source::Bytes(text.as_bytes().into())] {
            let (mut read, mut pieces) = (Vec::new(), 0);
            let whole = &mut |lines: &[u8]| {
                assert!(lines.ends_with(b"\n") || lines.ends_with(b"end"));
                read.extend_from_slice(lines);
                pieces += 1;
                true
            };
            source.lines(0, whole).expect("read");
            assert!(pieces > 2 && read == text.as_bytes());
            assert_eq!(source.some(text.len() as u64 - 3, 10).expect("read"), b"end");
        }
    }
}
