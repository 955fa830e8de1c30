//! The solutions that a reference rests on.

use crate::model::PerQuantity;

/// What a source is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The best estimate where nothing better is known.
    Best,
    /// Is held against the best estimate; measures its error where nothing better is known.
    Second,
    /// Replaces the best estimate at the times it has.
    Exact,
    /// Knows a part of the motion only, and is compared with that part.
    Check,
    /// Gave no solution.
    Failed,
}

impl Role {
    /// Name in records.
    pub fn name(self) -> &'static str {
        match self {
            Role::Best => "best estimate",
            Role::Second => "second source",
            Role::Exact => "exact at its times",
            Role::Check => "check",
            Role::Failed => "failed",
        }
    }
}

/// One of the solutions that a reference rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Method, "closed form", or "stored".
    pub name: String,
    /// Implementation, tolerance and work; or how it was made; or why it failed.
    pub detail: String,
    /// What it is there for.
    pub role: Role,
    /// Largest difference from the best estimate over the run; `None` for the best estimate itself. A check
    /// compares angular velocities only: its other entries are 0.
    pub disagreement: Option<PerQuantity<f64>>,
}

impl Source {
    pub(super) fn failed(name: &str, detail: String) -> Source {
        Source { name: name.to_owned(), detail, role: Role::Failed, disagreement: None }
    }
}
