//! The files of a command line, which decide what an engine computes.
//!
//! The program is looked for in the folders of `PATH`, as the system does. Any other word counts where it is the path of a file, by itself or
//! after a `=`, as in `--model=body.xml`. Files that the program opens by other ways, as a module that a script imports, do not count: they
//! are behind the version that the engine answers with.

use std::env;
use std::path::{Path, PathBuf};

use crate::journal;

/// A fingerprint of the content of every file that the words of a command line name.
pub(super) fn fingerprint(words: &[String]) -> String {
    let others = words.iter().skip(1).filter_map(|word| argument(word));
    let files = words.first().and_then(|word| program(word)).into_iter().chain(others);
    let of_file = |path: PathBuf| journal::fingerprint(&path).unwrap_or_default();
    files.map(of_file).collect::<Vec<_>>().join(" ")
}

/// The file of a program.
fn program(word: &str) -> Option<PathBuf> {
    if word.contains('/') {
        return Some(word.into());
    }
    let folders = env::var_os("PATH")?;
    env::split_paths(&folders).map(|folder| folder.join(word)).find(|path| path.is_file())
}

/// The file of another word: no device and no pipe, which have no end.
fn argument(word: &str) -> Option<PathBuf> {
    let value = word.split_once('=').map(|(_, value)| value);
    [Some(word), value].into_iter().flatten().find(|word| Path::new(word).is_file()).map(PathBuf::from)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_fingerprint_follows_the_content_of_each_file_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name).display().to_string();
        let (script, model) = (path("engine.py"), path("body.xml"));
        let words = ["sh", &script, &format!("--model={model}"), "--every", "3"].map(str::to_owned);
        let with = |file: &str, text: &str| {
            fs::write(file, text).expect("written");
            fingerprint(&words)
        };
        with(&script, "one");
        let first = with(&model, "two");
        assert_eq!(first.split(' ').count(), 3);
        assert_eq!(with(&model, "two"), first);
        assert_ne!(with(&model, "three"), first);
        assert_eq!(with(&model, "two"), first);
        assert_ne!(with(&script, "four"), first);
        assert_eq!(fingerprint(&["/no/such/program".to_owned(), "/dev/zero".to_owned()]), "");
    }
}
