//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that nobody noticed, and fails.
//!
//! The tables beside this file are sorted by what a verdict is about.

mod asymptotic_range;
mod energy;
mod first_order;
mod rounding;
mod solvers;

use crate::record::{ClaimName, Ruling, Verdict};
use crate::schemes::Card;

/// Verdicts that are known not to hold, for one reason.
struct Deviation {
    reason: &'static str,
    claim: ClaimName,
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

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: Deviation = Deviation {
        reason: "it is so",
        claim: ClaimName::Order,
        quantities: &[],
        places: &[("here", &["euler"])],
    };
    const PART: Deviation = Deviation { quantities: &["end"], ..WHOLE };

    /// Rulings on quantities, as they are after a deviation has been marked: whether each is known, and what it is.
    fn marked(known: &Deviation, scheme: &str, rulings: &[(&str, Ruling)]) -> Vec<(bool, Ruling)> {
        let verdict = |(quantity, ruling): &(&str, Ruling)| Verdict {
            scene: "here".to_owned(),
            scheme: scheme.to_owned(),
            claim: ClaimName::Order,
            quantity: (*quantity).to_owned(),
            verdict: *ruling,
            ..Verdict::default()
        };
        let mut verdicts: Vec<Verdict> = rulings.iter().map(verdict).collect();
        known.mark(&mut verdicts, "here", "euler");
        verdicts.iter().map(|v| (v.known_deviation.is_some(), v.verdict)).collect()
    }

    use Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};

    #[test]
    fn what_does_not_hold_is_known_and_what_does_not_apply_is_left() {
        let found = marked(&WHOLE, "euler", &[("end", Fail), ("max", Inconclusive), ("all", Broken)]);
        assert_eq!(found, [(true, Fail), (true, Inconclusive), (true, Broken)]);
        let found = marked(&WHOLE, "euler", &[("end", NotApplicable), ("max", Fail)]);
        assert_eq!(found, [(false, NotApplicable), (true, Fail)]);
    }

    #[test]
    fn a_deviation_that_is_gone_fails_as_a_whole_or_in_each_quantity_that_it_names() {
        assert_eq!(marked(&WHOLE, "euler", &[("end", Pass), ("max", Pass)]), [(false, Fail); 2]);
        assert_eq!(marked(&WHOLE, "euler", &[("end", Pass), ("max", Fail)]), [(false, Pass), (true, Fail)]);
        assert_eq!(marked(&PART, "euler", &[("end", Pass), ("max", Fail)]), [(false, Fail); 2]);
        assert_eq!(marked(&PART, "euler", &[("end", Fail), ("max", Pass)]), [(true, Fail), (false, Pass)]);
    }

    #[test]
    fn every_row_of_the_tables_is_applied() {
        for known in TABLES.into_iter().flatten() {
            for (scene, schemes) in known.places {
                let mut verdicts = [Verdict {
                    scene: (*scene).to_owned(),
                    scheme: schemes[0].to_owned(),
                    claim: known.claim,
                    quantity: known.quantities.first().unwrap_or(&"all").to_string(),
                    verdict: Fail,
                    ..Verdict::default()
                }];
                apply(&mut verdicts);
                assert!(verdicts[0].known_deviation.is_some(), "{scene}, {}: {}", schemes[0], known.reason);
            }
        }
    }

    #[test]
    fn a_substepped_variant_may_deviate_and_need_not() {
        let variant = "substepped-2-euler";
        assert_eq!(marked(&WHOLE, variant, &[("end", Pass), ("max", Pass)]), [(false, Pass); 2]);
        assert_eq!(marked(&PART, variant, &[("end", Pass)]), [(false, Pass)]);
        assert_eq!(marked(&WHOLE, variant, &[("end", Fail)]), [(true, Fail)]);
        assert_eq!(marked(&WHOLE, "substepped-2-rkmk4", &[("end", Fail)]), [(false, Fail)]);
    }

    #[test]
    fn a_deviation_is_of_one_scene_one_scheme_and_one_claim() {
        let own = Verdict {
            scene: "here".to_owned(),
            scheme: "euler".to_owned(),
            claim: ClaimName::Order,
            verdict: Fail,
            ..Verdict::default()
        };
        let others = [
            Verdict { scene: "there".to_owned(), ..own.clone() },
            Verdict { scheme: "rkmk4".to_owned(), ..own.clone() },
            Verdict { claim: ClaimName::Exact, ..own.clone() },
            own,
        ];
        let mut verdicts = others.to_vec();
        WHOLE.mark(&mut verdicts, "here", "euler");
        let known: Vec<bool> = verdicts.iter().map(|v| v.known_deviation.is_some()).collect();
        assert_eq!(known, [false, false, false, true]);
    }
}
