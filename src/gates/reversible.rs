//! The reversibility gate: there and back ends at the start, to rounding. Where implicit equations were solved to their
//! tolerance and no further, what is left of them is named and the verdict stays open.

use super::{SOLVED_TO, left_by_solves, ruled, times};
use crate::measure::{BELOW, CLEAR};
use crate::record::{ClaimName, Evidence, Rule, Ruling, Verdict};

pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let rule =
        |verdict, detail: &str| ruled(evidence, ClaimName::Reversible, "there-and-back", verdict, detail);
    let Some(reversal) = &evidence.reversal else {
        return rule(
            Ruling::NotApplicable,
            "a force depends on time, or friction makes the way back amplify every rounding",
        );
    };
    let (Some(of_rounding), Some((quantity, distance))) = (reversal.of_rounding, reversal.worst) else {
        if reversal.unsolved {
            let detail = "an implicit equation is not solved there or back: a smaller step would decide it";
            return rule(Ruling::Inconclusive, detail).by(Rule::NotSolved);
        }
        return rule(Ruling::Broken, "the run there or back broke");
    };
    if CLEAR * reversal.open > BELOW {
        let detail = format!(
            "{} steps of {:.3e} s there and back: such steps make {:.1e} rad of a rounding, too much to see where they return to",
            reversal.steps, reversal.step, reversal.open
        );
        return rule(Ruling::Inconclusive, &detail).by(Rule::Open);
    }
    let left = left_by_solves(reversal.solves, reversal.steps);
    let (verdict, named) = if of_rounding <= CLEAR {
        (Ruling::Pass, String::new())
    } else if of_rounding <= CLEAR * left {
        (Ruling::Inconclusive, format!("; within what {} solves to {SOLVED_TO:.0e} leave", reversal.solves))
    } else {
        (Ruling::Fail, String::new())
    };
    let arithmetic = if reversal.double_double { " in double-double" } else { "" };
    let detail = format!(
        "{} steps of {:.3e} s there and back{arithmetic}: {} off by {distance:.2e} {}, {} of its rounding; at most {CLEAR}{named}",
        reversal.steps,
        reversal.step,
        quantity.name(),
        quantity.unit(),
        times(of_rounding)
    );
    let ruled = rule(verdict, &detail).undecided_by(Rule::Solves);
    Verdict { measured: Some(of_rounding), low: Some(0.0), high: Some(CLEAR), ..ruled }
}
