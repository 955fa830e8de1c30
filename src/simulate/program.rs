//! Who a foreign program is.

/// A foreign program, as it tells of itself and as it was seen.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Program {
    /// Name.
    pub name: String,
    /// Version, or empty.
    pub version: String,
    /// Its integrator, or empty.
    pub integrator: String,
    /// Whether it computes in single precision: it says so, or all that it has answered so far is single.
    pub single_precision: bool,
    /// Most significant digits of a number that it has printed so far; 0 before the first.
    pub digits: usize,
    /// Fingerprint of the files that its command line names, or empty.
    pub files: String,
    /// What is odd about its answers so far, a sentence each.
    pub remarks: Vec<String>,
}
