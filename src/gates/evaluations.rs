//! The count of force evaluations, exactly. A run may begin with one more, on every rung or on none: a scheme that hands on the
//! forces at the end of a step needs those at its first beginning. It may need one more after each jump of a law; two jumps that
//! lie in one step are one.

use super::ruled;
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

/// Evaluations that a run may begin with.
const MOST_AT_BEGINNING: u64 = 1;

pub(super) fn judge(evidence: &Evidence, claimed: u32) -> Verdict {
    let whole: Vec<_> = evidence.ladder.rungs.iter().filter(|rung| rung.broken.is_none()).collect();
    let Some(last) = whole.last() else {
        let detail = "every run of the ladder broke";
        return ruled(evidence, ClaimName::Evaluations, "evaluations", Ruling::NotApplicable, detail);
    };
    let more = whole.iter().map(|rung| rung.evaluations.wrapping_sub(u64::from(claimed) * rung.steps));
    let (least, most) = more.fold((u64::MAX, 0), |(least, most), more| (least.min(more), most.max(more)));
    let jumps = evidence.setting.jumps;
    let holds = most <= MOST_AT_BEGINNING + jumps && most - least <= jumps;
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
