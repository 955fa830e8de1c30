//! Files whose final name never stands for half of them: a temporary neighbour, then a rename.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::RecordError;

/// A file that is written piece by piece and takes its name when it is whole. Dropped before that, it leaves nothing.
pub struct WholeFile {
    path: PathBuf,
    file: BufWriter<NamedTempFile>,
}

impl WholeFile {
    /// Begins a file that is to have this name; folders that are missing are made.
    ///
    /// # Errors
    /// The folder cannot be made or written to.
    pub fn begin(path: &Path) -> Result<WholeFile, RecordError> {
        let fail = |source| RecordError::File { path: path.into(), source };
        let folder = match path.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        fs::create_dir_all(folder).map_err(fail)?;
        let file = tempfile::Builder::new().prefix(".polhode-").tempfile_in(folder).map_err(fail)?;
        Ok(WholeFile { path: path.into(), file: BufWriter::new(file) })
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// The disk is full, or the name cannot be taken. The temporary file is removed.
    pub fn finish(self) -> Result<(), RecordError> {
        let WholeFile { path, file } = self;
        let fail = |source| RecordError::File { path: path.clone(), source };
        let file = file.into_inner().map_err(|error| fail(error.into_error()))?;
        file.as_file().sync_all().and_then(|()| open_to_readers(&file)).map_err(fail)?;
        file.persist(&path).map_err(|error| fail(error.error))?;
        Ok(())
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a file at once.
///
/// # Errors
/// Those of [`WholeFile`].
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    let mut file = WholeFile::begin(path)?;
    file.write_all(bytes).map_err(|source| RecordError::File { path: path.into(), source })?;
    file.finish()
}

/// Temporary files are private to their owner; a report is for everybody that the user's umask allows.
#[cfg(unix)]
fn open_to_readers(file: &NamedTempFile) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.as_file().set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn open_to_readers(_file: &NamedTempFile) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_no_name_before_it_is_whole_and_leaves_nothing_when_it_is_dropped() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("inner").join("run.csv");
        let names = || fs::read_dir(folder.path().join("inner")).expect("a folder").count();
        let mut file = WholeFile::begin(&path).expect("begun");
        file.write_all(b"half").expect("written");
        assert!(!path.exists());
        drop(file);
        assert_eq!(names(), 0);
        let mut file = WholeFile::begin(&path).expect("begun");
        file.write_all(b"whole").expect("written");
        file.finish().expect("finished");
        assert_eq!(fs::read(&path).expect("text"), b"whole");
        assert_eq!(names(), 1);
    }
}
