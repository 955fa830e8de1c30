//! What was judged.

use serde::{Deserialize, Serialize};

/// Whether a claim holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ruling {
    /// The claim holds.
    Pass,
    /// The claim does not hold.
    Fail,
    /// The measurement cannot decide.
    #[default]
    Inconclusive,
    /// The claim says nothing about this scene.
    NotApplicable,
    /// The run or its reference failed.
    Broken,
}

impl Ruling {
    /// The word that stands in records and tables.
    pub fn word(self) -> &'static str {
        match self {
            Ruling::Pass => "pass",
            Ruling::Fail => "fail",
            Ruling::Inconclusive => "inconclusive",
            Ruling::NotApplicable => "not-applicable",
            Ruling::Broken => "broken",
        }
    }
}

/// One claim, judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Claim, for example `order`.
    pub claim: String,
    /// Quantity that the claim is about.
    pub quantity: String,
    /// The ruling.
    pub verdict: Ruling,
    /// What was measured.
    pub measured: Option<f64>,
    /// Lower end of its uncertainty.
    pub low: Option<f64>,
    /// Upper end of its uncertainty.
    pub high: Option<f64>,
    /// The reason in words, with bound and unit.
    pub detail: String,
    /// Reason why this failure is known and does not fail the gate, if it is.
    #[serde(default)]
    pub known_deviation: Option<String>,
}
