//! A file whose bodies cannot be inspected.

use crate::bounded::FileError;
use crate::fault::lines;
use crate::scenes::{Fault, SceneError};

/// Why the bodies of a file cannot be inspected.
#[derive(Debug, thiserror::Error)]
pub enum InspectError {
    /// The file cannot be read, or says something that no robot description can mean.
    #[error(transparent)]
    File(#[from] FileError),
    /// A robot description with faults.
    #[error("{}", lines(file, faults))]
    Content {
        /// File as the user named it.
        file: String,
        /// What it says.
        text: String,
        /// All that is wrong, in the order of the file.
        faults: Vec<Fault>,
    },
    /// A scene file.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
