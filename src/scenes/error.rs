//! Why a scene cannot be used.

use std::io;

use super::wording;
use crate::fault::{Fault, lines};

/// A scene that cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The file says something that no scene can mean.
    #[error("{}", lines(file, faults))]
    Content {
        /// File as the user named it.
        file: String,
        /// What it says.
        text: String,
        /// All that is wrong, in the order of the file.
        faults: Vec<Fault>,
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

fn meant(near: &[&str]) -> String {
    if near.is_empty() { String::new() } else { format!(" (did you mean {}?)", wording::one_of(near)) }
}
