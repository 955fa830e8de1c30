//! What can be wrong with a scene: where, what, and what to write instead.

use std::io;

use super::wording;

/// A scene that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file says something that no scene can mean.
    #[error("{file}:{line}: {}{message}", prefix(key))]
    Content {
        /// File as the user named it.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Full key, as in `forces[1].stiffness`; empty where the text is not TOML at all.
        key: String,
        /// What was wrong, and what to write instead.
        message: String,
    },
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Unreadable {
        /// File as the user named it.
        file: String,
        /// Why.
        source: io::Error,
    },
    /// No built-in scene has this name.
    #[error(
        "no scene is called '{name}'{}. `polhode list scenes` shows all, and the path of a scene file has a '/' or ends in .toml",
        meant(near)
    )]
    Unknown {
        /// The name asked for.
        name: String,
        /// The three names nearest to it, the nearest first.
        near: Vec<&'static str>,
    },
}

fn prefix(key: &str) -> String {
    if key.is_empty() { String::new() } else { format!("{key}: ") }
}

fn meant(near: &[&str]) -> String {
    if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", wording::one_of(near)) }
}
