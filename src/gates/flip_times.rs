//! Flips of a tumbling body: as many as the truth has, at times that converge to the exact ones.
//!
//! Near the separatrix an error of the energy is amplified by the logarithmic period, so that the order of the
//! times may exceed that of the scheme: what is asked is that they converge at least as fast as claimed.

use super::ruled;
use crate::measure::flips::{COUNTED, flip_order, is_complete, is_open, is_unknown};
use crate::measure::{Decision, Doubt};
use crate::record::{ClaimName, Evidence, FlipRung, Flips, Rule, Ruling, Verdict};

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let rule = |ruling, detail: String| ruled(evidence, ClaimName::FlipTimes, "flip-times", ruling, detail);
    let Some(flips) = &evidence.flips else {
        return rule(
            Ruling::NotApplicable,
            "the body does not tumble freely about its middle axis".to_owned(),
        );
    };
    let truth = flips.truth.times.len();
    let fine = &flips.rungs[flips.rungs.len().saturating_sub(COUNTED)..];
    let decision = flip_order(flips);
    let complete = fine.iter().all(|rung| is_complete(flips, rung));
    let open = fine.iter().any(|rung| is_open(flips, rung));
    if (open && !complete) || matches!(decision, Decision::Undecided(Doubt::Open { .. })) {
        let detail = format!(
            "{truth} flips in truth: roundings grow until they decide when the body flips; a shorter run would decide it"
        );
        return rule(Ruling::Inconclusive, detail).by(Rule::Open);
    }
    if !complete && is_unknown(flips) {
        let known = flips.truth.uncertainty;
        let detail =
            format!("{truth} flips in truth, known to {known:.1e} s: a better reference would decide it");
        return rule(Ruling::Inconclusive, detail).by(Rule::NoReference);
    }
    if !complete {
        let (ruling, detail) = miscounted(flips, fine);
        return rule(ruling, detail).by(Rule::FlipCount);
    }
    if truth == 0 {
        return rule(Ruling::Pass, "no flip, as in truth, at the three finest steps".to_owned());
    }
    let claimed = evidence.order();
    match decision {
        Decision::Exact => rule(Ruling::Pass, format!("{truth} flips at their exact times, to rounding")),
        Decision::Order(found) => {
            let ruling = if found.order >= claimed { Ruling::Pass } else { Ruling::Fail };
            let (low, high) = found.bounds();
            let detail = format!(
                "{truth} flips: times of order {}, {claimed} claimed: slope {:.3}, r = {:.3}, up to t = {} s",
                found.order, found.slope, found.r, found.until
            );
            Verdict { measured: Some(found.slope), low: Some(low), high: Some(high), ..rule(ruling, detail) }
        }
        Decision::Elsewhere { error, .. } => {
            let detail = format!("{truth} flips: times off by {error:.2e} s however small the step");
            rule(Ruling::Fail, detail).by(Rule::Elsewhere)
        }
        Decision::Undecided(doubt) => {
            let detail = format!("{truth} flips: {}", super::order::doubted(&doubt));
            rule(Ruling::Inconclusive, detail).by(super::order::rule_of(&doubt))
        }
    }
}

/// What runs say that do not all have the flips of the truth.
fn miscounted(flips: &Flips, fine: &[FlipRung]) -> (Ruling, String) {
    let counts: Vec<usize> = fine.iter().map(|rung| rung.times.len()).collect();
    let detail = format!("{} flips in truth, {counts:?} at the three finest steps", flips.truth.times.len());
    // Runs that differ from one another say nothing of the limit.
    let settled = counts.windows(2).last().is_some_and(|pair| pair[0] == pair[1]);
    let wrong = fine.last().is_none_or(|rung| !is_complete(flips, rung));
    match settled && wrong {
        true => (Ruling::Fail, detail),
        false => (Ruling::Inconclusive, format!("{detail}: smaller steps would decide it")),
    }
}
