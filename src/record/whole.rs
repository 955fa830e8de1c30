//! Files whose final name never stands for half of them: a file without a name, or else a temporary neighbour, takes it when it is whole.
//! Devices, pipes and links are written through.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use tempfile::NamedTempFile;

use super::RecordError;
use super::place::{self, Way};

/// Whether the rows of this process are on disk until all its files are written, so that none is lost where a file is missing for a moment.
static ROWS_ARE_KEPT: AtomicBool = AtomicBool::new(false);

/// Says that the rows of this process are on disk until all its files are written.
#[cfg(feature = "cli")]
pub(crate) fn rows_are_kept() {
    ROWS_ARE_KEPT.store(true, Ordering::Relaxed);
}

/// A file that is written piece by piece and takes its name when it is whole. Dropped before that, it leaves nothing.
pub struct WholeFile {
    path: PathBuf,
    sink: Sink,
}

enum Sink {
    /// A file without a name, and the name that it takes.
    #[cfg(target_os = "linux")]
    Unnamed(BufWriter<File>, PathBuf),
    /// A neighbour, and the name that it takes.
    Neighbour(BufWriter<NamedTempFile>, PathBuf),
    /// A device or a pipe.
    Through(BufWriter<File>),
}

impl Sink {
    /// Of a file that takes its name at the end.
    fn whole(target: PathBuf) -> io::Result<Sink> {
        let folder = place::folder(&target);
        #[cfg(target_os = "linux")]
        if let Some(file) = super::unnamed::begin(folder) {
            return Ok(Sink::Unnamed(BufWriter::new(file), target));
        }
        let file = tempfile::Builder::new().prefix(".polhode-").tempfile_in(folder)?;
        Ok(Sink::Neighbour(BufWriter::new(file), target))
    }
}

impl WholeFile {
    /// Begins a file that is to have this name. Its folder must exist.
    ///
    /// # Errors
    /// The folder does not exist or cannot be written to, or a device or pipe cannot be opened.
    pub fn begin(path: &Path) -> Result<WholeFile, RecordError> {
        let fail = |source| RecordError::File { path: path.into(), source };
        let sink = match place::way(path) {
            Way::Through(device) => {
                let file = OpenOptions::new().append(true).open(device).map_err(fail)?;
                Sink::Through(BufWriter::new(file))
            }
            Way::Whole(target) => Sink::whole(target).map_err(fail)?,
        };
        Ok(WholeFile { path: path.into(), sink })
    }

    /// Gives it its name.
    ///
    /// # Errors
    /// The disk is full, or the name cannot be taken. The temporary file is removed.
    pub fn finish(self) -> Result<(), RecordError> {
        let WholeFile { path, sink } = self;
        let fail = |source| RecordError::File { path: path.clone(), source };
        match sink {
            Sink::Through(mut file) => file.flush().map_err(fail),
            #[cfg(target_os = "linux")]
            Sink::Unnamed(file, target) => {
                let file = file.into_inner().map_err(|error| fail(error.into_error()))?;
                let kept = ROWS_ARE_KEPT.load(Ordering::Relaxed);
                file.sync_all().and_then(|()| super::unnamed::take_name(&file, &target, kept)).map_err(fail)
            }
            Sink::Neighbour(file, target) => {
                let file = file.into_inner().map_err(|error| fail(error.into_error()))?;
                file.as_file().sync_all().and_then(|()| open_to_readers(&file)).map_err(fail)?;
                file.persist(&target).map_err(|error| fail(error.error))?;
                Ok(())
            }
        }
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.sink {
            Sink::Neighbour(file, _) => file.write(bytes),
            #[cfg(target_os = "linux")]
            Sink::Unnamed(file, _) => file.write(bytes),
            Sink::Through(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.sink {
            Sink::Neighbour(file, _) => file.flush(),
            #[cfg(target_os = "linux")]
            Sink::Unnamed(file, _) => file.flush(),
            Sink::Through(file) => file.flush(),
        }
    }
}

/// Writes a file at once. One that holds the same is not replaced.
///
/// # Errors
/// Those of [`WholeFile`].
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    let fail = |source| RecordError::File { path: path.into(), source };
    if let Way::Whole(file) = place::way(path)
        && fs::read(&file).is_ok_and(|earlier| earlier == bytes)
    {
        let touched = File::open(&file).and_then(|file| file.set_modified(SystemTime::now()));
        return touched.map_err(fail);
    }
    let mut file = WholeFile::begin(path)?;
    file.write_all(bytes).map_err(fail)?;
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
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_file_has_no_name_before_it_is_whole_and_leaves_nothing_when_it_is_dropped() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("run.csv");
        let names = || fs::read_dir(folder.path()).expect("a folder").count();
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

    #[test]
    fn a_file_is_replaced_by_another_and_not_by_the_same() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("page.html");
        let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1);
        for text in ["one", "one", "two"] {
            write_whole(&path, text.as_bytes()).expect("written");
            let file = File::open(&path).expect("a file");
            let touched = file.metadata().and_then(|of| of.modified()).expect("a time");
            assert!(touched > long_ago && fs::read_to_string(&path).is_ok_and(|now| now == text));
            file.set_modified(long_ago).expect("set");
        }
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_devices_written_to() {
        let folder = tempfile::tempdir().expect("a folder");
        let (real, link) = (folder.path().join("real"), folder.path().join("link"));
        std::os::unix::fs::symlink("real", &link).expect("a link");
        for text in ["first", "second"] {
            write_whole(&link, text.as_bytes()).expect("written");
            assert_eq!(fs::read_to_string(&real).expect("text"), text);
            assert!(link.is_symlink());
        }
        write_whole(Path::new("/dev/null"), b"text").expect("written");
        assert!(!Path::new("/dev/null").is_file());
        assert!(write_whole(&folder.path().join("no/such/folder"), b"text").is_err());
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2);
    }
}
