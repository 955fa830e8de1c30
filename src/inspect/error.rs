//! A file whose bodies cannot be inspected.

use crate::bounded::FileError;
use crate::scenes::SceneError;

/// Why the bodies of a file cannot be inspected.
#[derive(Debug, thiserror::Error)]
pub enum InspectError {
    /// The file cannot be read, or says something that no robot description can mean.
    #[error(transparent)]
    File(#[from] FileError),
    /// A scene file.
    #[error(transparent)]
    Scene(#[from] SceneError),
}
