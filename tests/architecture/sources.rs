//! The source files of the crate, read as text.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of Rust.
pub struct File {
    /// From the root of the package.
    pub path: PathBuf,
    /// The module that it is, from the root of the crate; empty for the root.
    pub module: Vec<String>,
    pub text: String,
}

/// A module that a file declares without its content.
pub struct Declared {
    pub name: String,
    /// The file that a `#[path]` names.
    pub path: Option<String>,
}

/// The folder of the package.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every file under a folder of the package.
pub fn of(folder: &str) -> Vec<File> {
    let mut paths = Vec::new();
    collect(&root().join(folder), &mut paths);
    paths.iter().map(|path| File::read(path)).collect()
}

fn collect(path: &Path, found: &mut Vec<PathBuf>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).expect("a folder") {
            collect(&entry.expect("an entry").path(), found);
        }
    } else if path.extension().is_some_and(|ending| ending == "rs") {
        found.push(path.to_owned());
    }
}

fn is_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The names of a path at the start of a text: a, b and c of `a::b::c(d)`.
fn names(text: &str) -> Vec<String> {
    let path: String = text.chars().take_while(|c| is_name(*c) || *c == ':').collect();
    path.split("::").take_while(|name| !name.is_empty()).map(str::to_owned).collect()
}

impl File {
    pub fn read(path: &Path) -> File {
        let text = fs::read_to_string(path).expect("text");
        let path = path.strip_prefix(root()).expect("a file of the package").to_owned();
        let mut module: Vec<String> = path
            .with_extension("")
            .components()
            .skip(1)
            .map(|part| part.as_os_str().to_string_lossy().into_owned())
            .collect();
        if module.last().is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str())) {
            module.pop();
        }
        File { path, module, text }
    }

    /// Whether the file belongs to a room of the crate.
    pub fn is_in(&self, room: &str) -> bool {
        self.module.first().is_some_and(|first| first == room)
    }

    /// The paths of the crate that the file names: `crate::a::b` as it stands, `super::b` from where the file
    /// stands.
    pub fn paths(&self) -> Vec<Vec<String>> {
        let mut paths = Vec::new();
        for (at, word) in self.text.match_indices("crate::") {
            paths.push(names(&self.text[at + word.len()..]));
        }
        // In the tests of a file, `super` is the file itself.
        let own = self.text.split("\nmod tests {").next().expect("a first part");
        for (at, _) in own.match_indices("super::").filter(|(at, _)| !own[..*at].ends_with("super::")) {
            let path = names(&own[at..]);
            let up = path.iter().take_while(|name| *name == "super").count();
            let kept = self.module.len().checked_sub(up).expect("no module above the root");
            paths.push(self.module[..kept].iter().chain(&path[up..]).cloned().collect());
        }
        let unclear = |path: &Vec<String>| path.is_empty();
        assert!(!paths.iter().any(unclear), "{}: several rooms in one path", self.path.display());
        paths
    }

    /// The modules whose content stands in other files, by their lines `mod name;`.
    pub fn declared(&self) -> Vec<Declared> {
        let mut declared = Vec::new();
        let mut path = None;
        for line in self.text.lines().map(str::trim) {
            if let Some(given) = line.strip_prefix("#[path = \"") {
                path = given.strip_suffix("\"]").map(str::to_owned);
            } else if let Some(name) = module_of(line) {
                declared.push(Declared { name: name.to_owned(), path: path.take() });
            }
        }
        declared
    }
}

/// The name in a line `mod name;`, of any visibility.
fn module_of(line: &str) -> Option<&str> {
    let line = line.strip_prefix("pub(crate) ").or(line.strip_prefix("pub(super) ")).unwrap_or(line);
    let name = line.strip_prefix("pub ").unwrap_or(line).strip_prefix("mod ")?.strip_suffix(';')?;
    name.chars().all(is_name).then_some(name)
}
