//! A file whose bodies cannot be inspected.

use crate::scenes::SceneError;

/// Why the bodies of a file cannot be inspected.
#[derive(Debug, thiserror::Error)]
pub enum InspectError {
    /// The file cannot be read.
    #[error("{file}: {source}")]
    Unreadable {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file says something that no robot description can mean.
    #[error("{file}:{line}: {why}")]
    Content {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is wrong, and what to write instead.
        why: String,
    },
    /// A scene file.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
