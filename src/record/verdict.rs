//! What was judged.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::Rule;
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
    /// Name of the rule that made it: a [`Rule`], or the claim where that has one rule.
    #[serde(default)]
    pub rule: Cow<'static, str>,
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

impl Verdict {
    /// Names the rule that made it.
    pub(crate) fn by(self, rule: Rule) -> Verdict {
        Verdict { rule: Cow::Borrowed(rule.word()), ..self }
    }

    /// Names the rule that leaves it undecided, where it is.
    pub(crate) fn undecided_by(self, rule: Rule) -> Verdict {
        if self.verdict == Ruling::Inconclusive { self.by(rule) } else { self }
    }
}
