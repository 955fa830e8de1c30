//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that nobody noticed, and fails.

use crate::record::{Ruling, Verdict};

/// A verdict that is known not to hold.
struct Deviation {
    scene: &'static str,
    scheme: &'static str,
    claim: &'static str,
    quantity: &'static str,
    reason: &'static str,
}

const KNOWN: &[Deviation] = &[];

pub(super) fn apply(verdicts: &mut [Verdict]) {
    for verdict in verdicts {
        let known = KNOWN.iter().find(|known| {
            known.scene == verdict.scene
                && known.scheme == verdict.scheme
                && known.claim == verdict.claim
                && known.quantity == verdict.quantity
        });
        let Some(known) = known else { continue };
        match verdict.verdict {
            Ruling::Fail | Ruling::Inconclusive => verdict.known_deviation = Some(known.reason.to_owned()),
            Ruling::Pass => {
                verdict.verdict = Ruling::Fail;
                verdict.detail =
                    format!("listed as a known deviation ({}), yet it holds: {}", known.reason, verdict.detail);
            }
            Ruling::NotApplicable | Ruling::Broken => {}
        }
    }
}
