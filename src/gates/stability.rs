//! The limit of stability on the spring-held body at rest: that on record must be met to 2 %, both ways. A scheme that has become
//! more stable than its record is as much of a change as one that has become less.

use super::ruled;
use crate::record::stability::{LinearLimit, Stability};
use crate::record::{ClaimName, Evidence, Ruling, Verdict};

/// How far a limit may be from the one on record, relative.
const MET: f64 = 0.02;

pub(super) fn judge(evidence: &Evidence) -> Option<Verdict> {
    let measured = evidence.step_limit.as_ref()?;
    let stored = Stability::built_in().linear(&evidence.scene, &evidence.scheme)?;
    let (verdict, bounds, detail) = rule(stored, measured);
    Some(Verdict {
        measured: measured.h_omega,
        low: bounds.map(|bounds| bounds.0),
        high: bounds.map(|bounds| bounds.1),
        ..ruled(evidence, ClaimName::Stability, "step-limit", verdict, detail)
    })
}

/// The ruling, the bounds that the limit must lie in where there is one on record, and the words.
fn rule(stored: &LinearLimit, measured: &LinearLimit) -> (Ruling, Option<(f64, f64)>, String) {
    let ruling = |holds: bool| if holds { Ruling::Pass } else { Ruling::Fail };
    match (stored.h_omega, measured.h_omega) {
        (Some(on_record), Some(now)) => (
            // A NaN is within nothing.
            ruling((now / on_record - 1.0).abs() <= MET),
            Some((on_record * (1.0 - MET), on_record * (1.0 + MET))),
            format!("stable up to h·ω = {now:.4} ({} above it), {on_record:.4} on record", measured.failure),
        ),
        (None, None) => (
            ruling(stored.failure == measured.failure),
            None,
            format!("no limit within the steps tried: {}; on record: {}", measured.failure, stored.failure),
        ),
        _ => (
            Ruling::Fail,
            None,
            format!("limit of stability {}, {} on record", words(measured), words(stored)),
        ),
    }
}

fn words(limit: &LinearLimit) -> String {
    limit.h_omega.map_or_else(|| format!("none ({})", limit.failure), |limit| format!("h·ω = {limit:.4}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limit(h_omega: Option<f64>, failure: &str) -> LinearLimit {
        LinearLimit { h_omega, failure: failure.to_owned(), ..LinearLimit::default() }
    }

    #[test]
    fn a_limit_is_met_to_two_percent_both_ways() {
        let stored = limit(Some(1.25), "energy grows");
        let at = |now: f64| rule(&stored, &limit(Some(now), "energy grows")).0;
        assert_eq!([at(1.25), at(1.25 * 1.019), at(1.25 * 0.981)], [Ruling::Pass; 3]);
        assert_eq!([at(1.25 * 1.021), at(1.25 * 0.979), at(f64::NAN)], [Ruling::Fail; 3]);
    }

    #[test]
    fn a_limit_that_has_come_or_gone_fails() {
        let (some, grows) = (limit(Some(1.25), "energy grows"), limit(None, "energy grows"));
        let stable = limit(None, "stable at every step tried");
        assert_eq!(rule(&some, &grows).0, Ruling::Fail);
        assert_eq!(rule(&stable, &some).0, Ruling::Fail);
        assert_eq!(rule(&stable, &grows).0, Ruling::Fail);
        assert_eq!(rule(&stable, &stable).0, Ruling::Pass);
    }
}
