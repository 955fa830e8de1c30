//! The count of implicit equations that a step solves, exactly.

use super::{Case, broke, ruled};
use crate::record::{ClaimName, Ruling, Verdict};

pub(super) fn judge(case: &Case, claimed: u32) -> Verdict {
    let mut whole = case.evidence.rungs.iter().filter(|rung| rung.outcome.broken.is_none()).peekable();
    let Some(first) = whole.peek() else {
        return broke(case, ClaimName::Solves, "solves", "every run of the ladder broke");
    };
    let iterations = first.outcome.iterations as f64 / first.outcome.solves.max(1) as f64;
    let measured = first.outcome.solves as f64 / first.steps as f64;
    let holds = whole.all(|rung| rung.outcome.solves == u64::from(claimed) * rung.steps);
    Verdict {
        measured: Some(measured),
        low: Some(f64::from(claimed)),
        high: Some(f64::from(claimed)),
        ..ruled(
            case,
            ClaimName::Solves,
            "solves",
            if holds { Ruling::Pass } else { Ruling::Fail },
            format!(
                "{measured} implicit equations a step, {claimed} claimed; {iterations:.1} iterations each at the coarsest step"
            ),
        )
    }
}
