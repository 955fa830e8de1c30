//! What was judged.

use serde::{Deserialize, Serialize};

use crate::claim::ClaimName;
use crate::words::words;

words! {
    /// Whether a claim holds.
    Ruling {
        /// The claim holds.
        Pass = "pass",
        /// The claim does not hold.
        Fail = "fail",
        /// The measurement cannot decide.
        #[default]
        Inconclusive = "inconclusive",
        /// The claim is not about this scene.
        NotApplicable = "not-applicable",
        /// The run or its reference failed.
        Broken = "broken",
    }
}

/// One claim, judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// What it is about.
    pub claim: ClaimName,
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
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub known_deviation: Option<String>,
}
