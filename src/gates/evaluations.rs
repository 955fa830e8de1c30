//! The count of force evaluations, exactly.

use super::{Case, ruled};
use crate::record::{Ruling, Verdict};

pub(super) fn judge(case: &Case, claimed: u32) -> Vec<Verdict> {
    let whole: Vec<_> = case.evidence.rungs.iter().filter(|rung| rung.outcome.broken.is_none()).collect();
    let Some(last) = whole.last() else {
        return vec![ruled(
            case,
            "evaluations",
            "evaluations",
            Ruling::Broken,
            "every run of the ladder broke",
        )];
    };
    let holds = whole.iter().all(|rung| rung.outcome.evaluations == u64::from(claimed) * rung.steps);
    let verdict = if holds { Ruling::Pass } else { Ruling::Fail };
    let measured = last.outcome.evaluations as f64 / last.steps as f64;
    vec![Verdict {
        measured: Some(measured),
        low: Some(f64::from(claimed)),
        high: Some(f64::from(claimed)),
        ..ruled(
            case,
            "evaluations",
            "evaluations",
            verdict,
            format!(
                "{} evaluations in {} steps, {claimed} a step claimed",
                last.outcome.evaluations, last.steps
            ),
        )
    }]
}
