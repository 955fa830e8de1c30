//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that nobody noticed, and fails.
//!
//! The tables beside this file are sorted by what a verdict is about.

mod asymptotic_range;
mod energy;
mod first_order;
mod rounding;
mod solvers;

use crate::record::{Ruling, Verdict};
use crate::schemes::Card;

/// Verdicts that are known not to hold, for one reason.
struct Deviation {
    reason: &'static str,
    claim: &'static str,
    /// Every quantity that does not hold, where none is named; then one of them at least must not.
    quantities: &'static [&'static str],
    /// Scenes, and the schemes that deviate there.
    places: &'static [(&'static str, &'static [&'static str])],
}

/// What an order of the rotation is read from.
const ROTATION: &[&str] = &[
    "orientation-end",
    "orientation-max",
    "angular-velocity-end",
    "angular-velocity-max",
    "body-point-end",
    "body-point-max",
];

/// The same without the spin, where that has an order of its own.
const WITHOUT_SPIN: &[&str] = &["orientation-end", "orientation-max", "body-point-end", "body-point-max"];

const TABLES: [&[Deviation]; 5] =
    [first_order::KNOWN, asymptotic_range::KNOWN, energy::KNOWN, rounding::KNOWN, solvers::KNOWN];

/// Marks the verdicts on one scheme in one scene.
pub(super) fn apply(verdicts: &mut [Verdict]) {
    for known in TABLES.into_iter().flatten() {
        for (scene, schemes) in known.places {
            for scheme in *schemes {
                known.mark(verdicts, scene, scheme);
            }
        }
    }
}

impl Deviation {
    /// Marks what does not hold; fails what does, unless it is of a substepped variant, for which the reason may or may not
    /// hold: its steps are smaller.
    fn mark(&self, verdicts: &mut [Verdict], scene: &str, scheme: &str) {
        let named = |verdict: &Verdict| {
            let own = verdict.scheme == scheme;
            own || Card::parts(&verdict.scheme).is_some_and(|(_, base)| base == scheme)
        };
        let quantity = |verdict: &Verdict| {
            self.quantities.is_empty() || self.quantities.contains(&verdict.quantity.as_str())
        };
        let spoken = |v: &Verdict| v.scene == scene && named(v) && v.claim == self.claim && quantity(v);
        let mut spoken: Vec<&mut Verdict> = verdicts.iter_mut().filter(|v| spoken(v)).collect();
        let all_hold = spoken.iter().all(|verdict| verdict.verdict == Ruling::Pass);
        for verdict in &mut spoken {
            match verdict.verdict {
                Ruling::NotApplicable => {}
                Ruling::Pass if verdict.scheme != scheme => {}
                Ruling::Pass if all_hold || !self.quantities.is_empty() => {
                    verdict.verdict = Ruling::Fail;
                    verdict.detail = format!(
                        "listed as a known deviation ({}), yet it holds: {}",
                        self.reason, verdict.detail
                    );
                }
                Ruling::Pass => {}
                _ => verdict.known_deviation = Some(self.reason.to_owned()),
            }
        }
    }
}
