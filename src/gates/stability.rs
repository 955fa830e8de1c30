//! The limit of stability on the spring-held body at rest: that on record must be met to 2 %, both ways. A scheme that has become
//! more stable than its record is as much of a change as one that has become less.

use super::{Case, ruled};
use crate::record::{Ruling, Verdict};

/// How far a limit may be from the one on record, relative.
const MET: f64 = 0.02;

pub(super) fn judge(case: &Case) -> Option<Verdict> {
    let (stored, measured) = case.step_limit?;
    let how = |failure: &str| {
        if failure.starts_with("stable") { String::new() } else { format!(" ({failure} above it)") }
    };
    let (verdict, bounds, detail) = match (stored.h_omega, measured.h_omega) {
        (Some(on_record), Some(now)) => {
            let holds = (now / on_record - 1.0).abs() <= MET;
            (
                if holds { Ruling::Pass } else { Ruling::Fail },
                Some((on_record * (1.0 - MET), on_record * (1.0 + MET))),
                format!("stable up to h·ω = {now:.4}{}, {on_record:.4} on record", how(&measured.failure)),
            )
        }
        (None, None) => (
            if stored.failure == measured.failure { Ruling::Pass } else { Ruling::Fail },
            None,
            format!("no limit within the steps tried: {}; on record: {}", measured.failure, stored.failure),
        ),
        (on_record, now) => {
            let words = |limit: Option<f64>, failure: &str| {
                limit.map_or_else(|| format!("none ({failure})"), |limit| format!("h·ω = {limit:.4}"))
            };
            let detail = format!(
                "limit of stability {}, {} on record",
                words(now, &measured.failure),
                words(on_record, &stored.failure)
            );
            (Ruling::Fail, None, detail)
        }
    };
    Some(Verdict {
        measured: measured.h_omega,
        low: bounds.map(|bounds| bounds.0),
        high: bounds.map(|bounds| bounds.1),
        ..ruled(case, "stability", "step-limit", verdict, detail)
    })
}
