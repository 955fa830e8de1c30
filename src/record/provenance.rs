//! Where a baseline comes from.

use serde::{Deserialize, Serialize};

/// Who made a baseline, when, with which version, and why.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// Name of the user.
    pub who: String,
    /// Time, RFC 3339, UTC.
    pub when: String,
    /// Version of Polhode.
    pub version: String,
    /// The reason in words.
    pub reason: String,
}
