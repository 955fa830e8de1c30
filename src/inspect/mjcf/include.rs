//! `<include file>`: replaced by what the file holds, found relative to the main file; a file that is absent is a remark.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::inspect::element::{self, Element, Fault, LARGEST_FILE};

struct Includes<'p> {
    folder: &'p Path,
    /// Files that were read: MuJoCo takes each once, which ends every circle.
    met: BTreeSet<PathBuf>,
    bytes: u64,
    notes: Vec<String>,
}

/// Replaces every `<include>` below `root`; returns remarks on those that are absent.
pub(super) fn resolve(root: &mut Element, path: &Path) -> Result<Vec<String>, Fault> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut includes =
        Includes { folder, met: BTreeSet::from([path.to_owned()]), bytes: 0, notes: Vec::new() };
    includes.splice(root)?;
    Ok(includes.notes)
}

impl Includes<'_> {
    fn splice(&mut self, element: &mut Element) -> Result<(), Fault> {
        if element.children.iter().all(|child| child.name != "include") {
            return element.children.iter_mut().try_for_each(|child| self.splice(child));
        }
        for mut child in std::mem::take(&mut element.children) {
            if child.name == "include" {
                element.children.extend(self.open(&child)?);
            } else {
                self.splice(&mut child)?;
                element.children.push(child);
            }
        }
        Ok(())
    }

    fn open(&mut self, include: &Element) -> Result<Vec<Element>, Fault> {
        let Some(name) = include.attribute("file") else {
            return Err(Fault::at(include, "has no file"));
        };
        let path = self.folder.join(name);
        if !path.is_file() {
            self.notes.push(format!(
                "line {}: the included file {name} is not there; the rest is read without it",
                include.line
            ));
            return Ok(Vec::new());
        }
        if !self.met.insert(path.clone()) {
            return Err(Fault::at(
                include,
                format!("{name} is included twice, which MuJoCo refuses: remove one"),
            ));
        }
        let text = element::read(&path).map_err(|error| Fault::at(include, error))?;
        self.bytes += text.len() as u64;
        if self.bytes > LARGEST_FILE {
            return Err(Fault::at(
                include,
                format!("included files are larger than {} MiB together", LARGEST_FILE >> 20),
            ));
        }
        let mut root = element::parse(&text, name).map_err(|error| Fault::at(include, error))?;
        self.splice(&mut root)?;
        Ok(root.children)
    }
}
