//! Where a file is to be written: tried before work begins, never over what is no file of this program.

use std::fs::{self, File, OpenOptions};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::RecordError;

/// Bytes of a file that show what it is.
const HEAD: u64 = 1 << 16;

/// How a name is written.
pub(super) enum Way {
    /// A regular file, or none yet: its neighbour takes this name when it is whole.
    Whole(PathBuf),
    /// A device, a pipe or a descriptor: written as it is.
    Through(PathBuf),
}

/// How this name is written. A link is followed: the file that it names is written, the link stays.
pub(super) fn way(path: &Path) -> Way {
    // The name of a descriptor, as /dev/stdout is, may lead to a regular file that another program holds open.
    let is_descriptor = ["/dev", "/proc"].iter().any(|folder| path.starts_with(folder));
    match fs::metadata(path) {
        Ok(kind) if is_descriptor || !(kind.is_file() || kind.is_dir()) => Way::Through(path.into()),
        Ok(_) => Way::Whole(fs::canonicalize(path).unwrap_or_else(|_| path.into())),
        Err(_) => match fs::read_link(path) {
            // A link to a file that is not there yet.
            Ok(target) => Way::Whole(folder(path).join(target)),
            Err(_) => Way::Whole(path.into()),
        },
    }
}

/// The folder that a file stands in.
pub(super) fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Finds out before any work whether a file can be written there. An existing file is kept unless its beginning is that of a file
/// that this command writes, or `force` is given. Nothing is left behind.
///
/// # Errors
/// The folder does not exist or takes no file, the name is that of a folder, or a file of another origin is there.
pub(crate) fn try_place(path: &Path, force: bool, own: impl Fn(&str) -> bool) -> Result<(), RecordError> {
    let fail = |source| RecordError::File { path: path.into(), source };
    match way(path) {
        // Opening a pipe to try it would end it for its reader.
        Way::Through(path) if is_pipe(&path) => Ok(()),
        Way::Through(path) => OpenOptions::new().append(true).open(path).map(drop).map_err(fail),
        Way::Whole(file) => {
            if file.is_dir() {
                return Err(fail(std::io::ErrorKind::IsADirectory.into()));
            }
            if file.exists() && !force && !own(&head(&file).map_err(fail)?) {
                return Err(RecordError::Foreign { path: path.into() });
            }
            tempfile::tempfile_in(folder(&file)).map(drop).map_err(fail)
        }
    }
}

/// Whether a file begins like a JSON file of this program: the schema is its first key.
pub(crate) fn is_own_json(head: &str) -> bool {
    let compact: String = head.chars().filter(|letter| !letter.is_whitespace()).take(64).collect();
    compact.starts_with("{\"schema\":\"polhode/")
}

/// Whether a file begins like a baseline of this program: records with a provenance.
pub(crate) fn is_own_baseline(head: &str) -> bool {
    let compact: String = head.chars().filter(|letter| !letter.is_whitespace()).collect();
    is_own_json(head) && compact.contains(",\"provenance\":[{")
}

/// The beginning of a file, as text.
fn head(path: &Path) -> std::io::Result<String> {
    let mut bytes = Vec::new();
    File::open(path)?.take(HEAD).read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    fs::metadata(path).is_ok_and(|kind| kind.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_path: &Path) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_of_another_origin_is_kept_and_one_of_this_program_is_not_in_the_way() {
        let folder = tempfile::tempdir().expect("a folder");
        let place = |name: &str, text: &str, force: bool| {
            let path = folder.path().join(name);
            std::fs::write(&path, text).expect("written");
            try_place(&path, force, is_own_json)
        };
        assert!(matches!(place("a.json", "my notes", false), Err(RecordError::Foreign { .. })));
        assert!(place("a.json", "my notes", true).is_ok());
        assert!(place("b.json", "{\n  \"schema\": \"polhode/run/1\",", false).is_ok());
        let missing = folder.path().join("no/such/folder.json");
        assert!(matches!(try_place(&missing, true, is_own_json), Err(RecordError::File { .. })));
        assert!(!folder.path().join("no").exists());
        assert!(try_place(folder.path(), true, is_own_json).is_err());
        assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 2);
    }
}
