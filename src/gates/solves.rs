//! The count of implicit equations that a step solves, exactly.

use super::ruled;
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

pub(super) fn judge(evidence: &Evidence, claimed: u32) -> Verdict {
    let mut whole = evidence.ladder.rungs.iter().filter(|rung| rung.broken.is_none()).peekable();
    let Some(first) = whole.peek() else {
        let detail = "every run of the ladder broke";
        return ruled(evidence, ClaimName::Solves, "solves", Ruling::NotApplicable, detail);
    };
    let iterations = first.iterations as f64 / first.solves.max(1) as f64;
    let measured = first.solves as f64 / first.steps as f64;
    let holds = whole.all(|rung| rung.solves == u64::from(claimed) * rung.steps);
    Verdict {
        measured: Some(measured),
        low: Some(f64::from(claimed)),
        high: Some(f64::from(claimed)),
        ..ruled(
            evidence,
            ClaimName::Solves,
            "solves",
            if holds { Ruling::Pass } else { Ruling::Fail },
            format!(
                "{measured} implicit equations a step, {claimed} claimed; {iterations:.1} iterations each at the coarsest step"
            ),
        )
    }
}
