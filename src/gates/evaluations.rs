//! The count of force evaluations, exactly. A run may begin with a few of its own, as many on every rung: a scheme that
//! hands on the forces at the end of a step needs those at its first beginning, and after each jump of a law.

use super::ruled;
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

/// Evaluations that a run may begin with, and go on with after a jump.
const MOST_AT_BEGINNING: u64 = 1;

pub(super) fn judge(evidence: &Evidence, claimed: u32) -> Verdict {
    let whole: Vec<_> = evidence.ladder.rungs.iter().filter(|rung| rung.broken.is_none()).collect();
    let Some(last) = whole.last() else {
        let detail = "every run of the ladder broke";
        return ruled(evidence, ClaimName::Evaluations, "evaluations", Ruling::NotApplicable, detail);
    };
    let beginning = last.evaluations.wrapping_sub(u64::from(claimed) * last.steps);
    let most = MOST_AT_BEGINNING * (1 + evidence.setting.jumps);
    let holds = beginning <= most
        && whole.iter().all(|rung| rung.evaluations == u64::from(claimed) * rung.steps + beginning);
    let verdict = if holds { Ruling::Pass } else { Ruling::Fail };
    let measured = last.evaluations as f64 / last.steps as f64;
    Verdict {
        measured: Some(measured),
        low: Some(f64::from(claimed)),
        high: Some(f64::from(claimed)),
        ..ruled(
            evidence,
            ClaimName::Evaluations,
            "evaluations",
            verdict,
            format!("{} evaluations in {} steps, {claimed} a step claimed", last.evaluations, last.steps),
        )
    }
}
