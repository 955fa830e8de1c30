//! Files without a name: a process that is killed leaves nothing of them. Linux has them, on most file systems.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::os::fd::AsRawFd;
use std::os::unix::fs::OpenOptionsExt;
use std::path::Path;

use rustix::fs::{AtFlags, CWD, OFlags, linkat};

/// Mode before the user's umask: a report is for everybody whom that allows.
const MODE: u32 = 0o666;

/// A file in a folder; `None` where the file system knows no such files.
pub(super) fn begin(folder: &Path) -> Option<File> {
    let flags = i32::try_from(OFlags::TMPFILE.bits()).ok()?;
    OpenOptions::new().write(true).mode(MODE).custom_flags(flags).open(folder).ok()
}

/// Gives a file the name of a file in its folder. One that has the name already is replaced by way of a second name, which a process that is
/// killed at that moment leaves; where the rows of the run are kept, the earlier file is removed just before in place of that.
///
/// # Errors
/// The name cannot be taken.
pub(super) fn take_name(file: &File, target: &Path, rows_are_kept: bool) -> io::Result<()> {
    let own = format!("/proc/self/fd/{}", file.as_raw_fd());
    let link = |name: &Path| linkat(CWD, &own, CWD, name, AtFlags::SYMLINK_FOLLOW).map_err(io::Error::from);
    match link(target) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists && rows_are_kept => {
            fs::remove_file(target)?;
            link(target)
        }
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            let mut builder = tempfile::Builder::new();
            let second = builder.prefix(".polhode-").make_in(super::place::folder(target), link)?;
            second.persist(target).map(drop).map_err(|error| error.error)
        }
        other => other,
    }
}
