//! Whether the sources of a reference agree well enough to judge by.

use crate::record::{ClaimName, ReferenceEvidence, Rule, Ruling, Verdict};

/// Uncertainty over the size of a quantity from which a reference no longer decides anything.
const TOO_UNCERTAIN: f64 = 1e-6;

/// Judges the reference of a scene.
pub fn judge_reference(evidence: &ReferenceEvidence) -> Verdict {
    let verdict = Verdict {
        scene: evidence.scene.clone(),
        scheme: "reference".to_owned(),
        claim: ClaimName::ReferencesAgree,
        quantity: "all".to_owned(),
        rule: ClaimName::ReferencesAgree.word().into(),
        ..Verdict::default()
    };
    if let Some(error) = &evidence.missing {
        let detail = format!("no reference solution, so nothing was judged in this scene: {error}");
        return Verdict { verdict: Ruling::Inconclusive, detail, ..verdict }.by(Rule::NoReference);
    }
    let (quantity, worst) = match evidence.worst {
        Some((quantity, worst)) => (quantity.name(), worst),
        None => ("all", f64::NAN),
    };
    let ruling = if worst <= TOO_UNCERTAIN { Ruling::Pass } else { Ruling::Inconclusive };
    Verdict {
        quantity: quantity.to_owned(),
        verdict: ruling,
        measured: worst.is_finite().then_some(worst),
        low: Some(0.0),
        high: Some(TOO_UNCERTAIN),
        detail: format!(
            "sources {}: largest uncertainty over the run {worst:.1e} of the size of {quantity}",
            evidence.sources.join(", ")
        ),
        ..verdict
    }
}
