//! The folder of a report: which of its files this program made. Files of others are never overwritten and never removed.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::record::{RecordError, is_own_json, try_place, write_whole};

/// The list of the files that an earlier report made, a path a line.
const MANIFEST: &str = ".polhode-manifest";

/// The folder of a report.
pub(super) struct Folder {
    path: PathBuf,
    /// Files that an earlier report made.
    earlier: BTreeSet<String>,
    /// Whether the records in it are of this program: a report of a version without a manifest.
    is_own: bool,
}

impl Folder {
    /// Opens a folder, which is made where it is missing. `records` is the name of its file of records.
    pub(super) fn open(path: &Path, records: &str) -> Result<Folder, RecordError> {
        fs::create_dir_all(path).map_err(|source| RecordError::File { path: path.into(), source })?;
        let text = fs::read_to_string(path.join(MANIFEST)).unwrap_or_default();
        let inside =
            |name: &&str| Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
        let earlier =
            text.lines().filter(|name| !name.is_empty()).filter(inside).map(str::to_owned).collect();
        let records = path.join(records);
        let is_own = records.is_file() && try_place(&records, false, is_own_json).is_ok();
        Ok(Folder { path: path.into(), earlier, is_own })
    }

    fn is_foreign(&self, name: &str) -> bool {
        !self.is_own && !self.earlier.contains(name) && self.path.join(name).symlink_metadata().is_ok()
    }

    /// Makes place for files of these names: what others made is kept under another name.
    pub(super) fn begin(&self, names: &BTreeSet<String>) -> Result<(), RecordError> {
        for name in names {
            let path = self.path.join(name);
            let fail = |source| RecordError::File { path: path.clone(), source };
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder).map_err(fail)?;
            }
            if self.is_foreign(name) {
                fs::rename(&path, free_name(&path)).map_err(fail)?;
            }
        }
        self.note(&self.earlier.union(names).cloned().collect())
    }

    /// Removes what an earlier report made and this one did not.
    pub(super) fn finish(&self, names: &BTreeSet<String>) -> Result<(), RecordError> {
        for stale in self.earlier.difference(names) {
            let path = self.path.join(stale);
            if path.is_file() {
                fs::remove_file(&path).map_err(|source| RecordError::File { path: path.clone(), source })?;
            }
        }
        self.note(names)
    }

    fn note(&self, names: &BTreeSet<String>) -> Result<(), RecordError> {
        let text: String = names.iter().map(|name| format!("{name}\n")).collect();
        write_whole(&self.path.join(MANIFEST), text.as_bytes())
    }
}

/// A neighbour of this name that is not taken.
fn free_name(path: &Path) -> PathBuf {
    let name = |count: u32| {
        let mut name = path.as_os_str().to_owned();
        name.push(if count == 1 { ".kept".to_owned() } else { format!(".kept-{count}") });
        PathBuf::from(name)
    };
    (1..).map(name).find(|name| name.symlink_metadata().is_err()).unwrap_or_else(|| name(u32::MAX))
}

/// Finds out before any work whether a report can be written into a folder, which is made. A page that this program did not write is in
/// the way unless `force` is given.
///
/// # Errors
/// The folder cannot be made or written to, or holds a page of another origin.
pub fn try_folder(path: &Path, records: &str, pages: &[&str], force: bool) -> Result<(), RecordError> {
    let folder = Folder::open(path, records)?;
    for name in pages.iter().chain([&records]) {
        let foreign = !force && folder.is_foreign(name);
        try_place(&path.join(name), !foreign, |_| false)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_an_earlier_report_made_is_removed_and_what_others_made_is_kept() {
        let scratch = tempfile::tempdir().expect("a folder");
        let at = |name: &str| scratch.path().join(name);
        let names = |list: &[&str]| list.iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
        fs::create_dir(at("plots")).expect("made");
        for name in ["plots/a.png", "plots/mine.png"] {
            fs::write(at(name), "mine").expect("written");
        }
        let write = |list: &[&str]| {
            let folder = Folder::open(scratch.path(), "records.json").expect("opened");
            folder.begin(&names(list)).expect("begun");
            list.iter().for_each(|name| fs::write(at(name), "ours").expect("written"));
            folder.finish(&names(list)).expect("finished");
        };
        write(&["plots/a.png", "plots/b.png"]);
        assert_eq!(fs::read_to_string(at("plots/a.png.kept")).expect("kept"), "mine");
        write(&["plots/b.png"]);
        assert!(!at("plots/a.png").exists() && at("plots/b.png").exists());
        assert_eq!(fs::read_to_string(at("plots/mine.png")).expect("kept"), "mine");
        fs::write(at(MANIFEST), "../outside\n/etc/passwd\n").expect("written");
        assert!(Folder::open(scratch.path(), "records.json").expect("opened").earlier.is_empty());
    }
}
