//! `<include file>`: replaced by what the file holds, found relative to the main file; a file that is absent is a remark.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::bounded::{self, MOST_OF_A_SCENE};
use crate::inspect::element::{self, DEEPEST, Element, Fault};

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
    includes.splice(root, 1)?;
    Ok(includes.notes)
}

impl Includes<'_> {
    /// `depth` counts elements from the root of the main file.
    fn splice(&mut self, element: &mut Element, depth: usize) -> Result<(), Fault> {
        if depth > DEEPEST {
            return Err(Fault::at(element, format!("included files nest deeper than {DEEPEST} levels")));
        }
        if element.children.iter().all(|child| child.name != "include") {
            return element.children.iter_mut().try_for_each(|child| self.splice(child, depth + 1));
        }
        for mut child in std::mem::take(&mut element.children) {
            if child.name == "include" {
                element.children.extend(self.open(&child, depth)?);
            } else {
                self.splice(&mut child, depth + 1)?;
                element.children.push(child);
            }
        }
        Ok(())
    }

    fn open(&mut self, include: &Element, depth: usize) -> Result<Vec<Element>, Fault> {
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
        let text = bounded::text(&path, MOST_OF_A_SCENE).map_err(|error| Fault::at(include, error))?;
        self.bytes += text.len() as u64;
        if self.bytes > MOST_OF_A_SCENE {
            return Err(Fault::at(
                include,
                format!("included files are larger than {} MiB together", MOST_OF_A_SCENE >> 20),
            ));
        }
        let mut root = element::parse(&text, name).map_err(|error| Fault::at(include, error))?;
        self.splice(&mut root, depth)?;
        root.children.iter_mut().for_each(|child| child.included(include, name));
        Ok(root.children)
    }
}
