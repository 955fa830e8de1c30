//! The reversibility gate: there and back ends at the start, to rounding. Where implicit equations were solved to their
//! tolerance and no further, what is left of them is named and the verdict stays open.

use super::{Case, OPEN, SOLVED_TO, left_by_solves, ruled};
use crate::record::{ClaimName, Ruling, Verdict};

/// Distance over its floor that rounding may leave.
const CLEAR: f64 = 10.0;
pub(super) fn judge(case: &Case) -> Verdict {
    let rule = |verdict, detail: &str| ruled(case, ClaimName::Reversible, "there-and-back", verdict, detail);
    let Some(reversal) = case.reversal else {
        return rule(
            Ruling::NotApplicable,
            "a force depends on time, or friction makes the way back amplify every rounding",
        );
    };
    if reversal.of_floor.is_nan() {
        return rule(Ruling::Broken, "the run there or back broke");
    }
    if reversal.open > OPEN {
        let detail = format!(
            "{} steps of {:.3e} s there and back: such steps make {:.1e} rad of a rounding, too much to tell where they return to",
            reversal.steps, reversal.step, reversal.open
        );
        return rule(Ruling::Inconclusive, &detail);
    }
    let left = left_by_solves(reversal.solves, reversal.steps);
    let (verdict, named) = if reversal.of_floor <= CLEAR {
        (Ruling::Pass, String::new())
    } else if reversal.of_floor <= CLEAR * left {
        (Ruling::Inconclusive, format!("; within what {} solves to {SOLVED_TO:.0e} leave", reversal.solves))
    } else {
        (Ruling::Fail, String::new())
    };
    Verdict {
        measured: Some(reversal.of_floor),
        low: Some(0.0),
        high: Some(CLEAR),
        ..rule(
            verdict,
            &format!(
                "{} steps of {:.3e} s there and back: {} off by {:.2e} {}, {:.2} of its floor; at most {CLEAR}{named}",
                reversal.steps,
                reversal.step,
                reversal.quantity.name(),
                reversal.distance,
                reversal.quantity.unit(),
                reversal.of_floor
            ),
        )
    }
}
