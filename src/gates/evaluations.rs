//! The count of force evaluations, exactly. A run may begin with a few of its own, as many on every rung: a scheme that
//! hands on the forces at the end of a step needs those at its first beginning.

use super::{Case, broke, ruled};
use crate::record::{ClaimName, Ruling, Verdict};

/// Evaluations that a run may begin with.
const MOST_AT_BEGINNING: u64 = 1;

pub(super) fn judge(case: &Case, claimed: u32) -> Vec<Verdict> {
    let whole: Vec<_> = case.evidence.rungs.iter().filter(|rung| rung.outcome.broken.is_none()).collect();
    let Some(last) = whole.last() else {
        return vec![broke(case, ClaimName::Evaluations, "evaluations", "every run of the ladder broke")];
    };
    let beginning = last.outcome.evaluations.wrapping_sub(u64::from(claimed) * last.steps);
    let holds = beginning <= MOST_AT_BEGINNING
        && whole.iter().all(|rung| rung.outcome.evaluations == u64::from(claimed) * rung.steps + beginning);
    let verdict = if holds { Ruling::Pass } else { Ruling::Fail };
    let measured = last.outcome.evaluations as f64 / last.steps as f64;
    vec![Verdict {
        measured: Some(measured),
        low: Some(f64::from(claimed)),
        high: Some(f64::from(claimed)),
        ..ruled(
            case,
            ClaimName::Evaluations,
            "evaluations",
            verdict,
            format!(
                "{} evaluations in {} steps, {claimed} a step claimed",
                last.outcome.evaluations, last.steps
            ),
        )
    }]
}
