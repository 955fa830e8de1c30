//! Known deviations: verdicts that do not hold, with the reason why. They are published and do not fail the gate; one
//! that holds after all is a repair that the table does not know, and fails.

use crate::record::{ClaimName, Ruling, Verdict};
use crate::schemes::Card;

/// Verdicts that are known not to hold, for one reason.
struct Deviation {
    reason: &'static str,
    claim: ClaimName,
    /// Scenes, and the schemes that deviate there, in one quantity at least.
    places: &'static [(&'static str, &'static [&'static str])],
}

const KNOWN: &[Deviation] = &[
    Deviation {
        reason: "the energy grows so fast that its rate changes within a run at every step that the long runs can afford",
        claim: ClaimName::Energy,
        places: &[
            ("free-asymmetric", &["euler"]),
            ("dzhanibekov", &["euler"]),
            ("mujoco-fast-spin", &["euler"]),
            ("mujoco-middle-axis", &["euler"]),
            ("osrf-boxes-complex", &["euler"]),
            ("thin-body", &["euler"]),
        ],
    },
    Deviation {
        reason: "the way back ends at rest, where an iteration that ends by a relative change of L no longer ends: the last step is \
                 not made",
        claim: ClaimName::Reversible,
        places: &[("released-top", &["implicit-midpoint"])],
    },
    Deviation {
        reason: "the body turns by so little that the solver's first steps are most of the run at every tolerance",
        claim: ClaimName::FollowsTolerance,
        places: &[("slow-sphere", &["bdf", "esdirk34", "tr-bdf2"])],
    },
    Deviation {
        reason: "a rounding of a position 7000 km from the origin is a nanometre, which the errors of order 8 reach within a few tolerances",
        claim: ClaimName::FollowsTolerance,
        places: &[("satellite-low-orbit", &["dop853", "dormand-prince-8"])],
    },
    Deviation {
        reason: "over 600 radians the error is as large as the motion at most tolerances",
        claim: ClaimName::FollowsTolerance,
        places: &[("mujoco-fast-spin", &["tr-bdf2"])],
    },
];

/// Marks the verdicts on one scheme in one scene.
pub(super) fn apply(verdicts: &mut [Verdict]) {
    for known in KNOWN {
        for (scene, schemes) in known.places {
            for scheme in *schemes {
                known.mark(verdicts, scene, scheme);
            }
        }
    }
}

impl Deviation {
    /// Marks what does not hold; fails what does as a whole, unless it is of a substepped variant, for which the reason may or may not
    /// hold: its steps are smaller.
    fn mark(&self, verdicts: &mut [Verdict], scene: &str, scheme: &str) {
        let named = |verdict: &Verdict| {
            let own = verdict.scheme == scheme;
            own || Card::parts(&verdict.scheme).is_some_and(|(_, base)| base == scheme)
        };
        let spoken = |v: &Verdict| v.scene == scene && named(v) && v.claim == self.claim;
        let mut spoken: Vec<&mut Verdict> = verdicts.iter_mut().filter(|v| spoken(v)).collect();
        let all_hold = spoken.iter().all(|verdict| verdict.verdict == Ruling::Pass);
        for verdict in &mut spoken {
            match verdict.verdict {
                Ruling::NotApplicable => {}
                Ruling::Pass if verdict.scheme != scheme || !all_hold => {}
                Ruling::Pass => {
                    verdict.verdict = Ruling::Fail;
                    verdict.detail = format!(
                        "listed as a known deviation ({}), yet it holds: {}",
                        self.reason, verdict.detail
                    );
                }
                _ => verdict.known_deviation = Some(self.reason.to_owned()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: Deviation =
        Deviation { reason: "it is so", claim: ClaimName::Order, places: &[("here", &["euler"])] };

    /// Rulings on quantities, as they are after a deviation has been marked: whether each is known, and what it is.
    fn marked(scheme: &str, rulings: &[(&str, Ruling)]) -> Vec<(bool, Ruling)> {
        let verdict = |(quantity, ruling): &(&str, Ruling)| Verdict {
            scene: "here".to_owned(),
            scheme: scheme.to_owned(),
            claim: ClaimName::Order,
            quantity: (*quantity).to_owned(),
            verdict: *ruling,
            ..Verdict::default()
        };
        let mut verdicts: Vec<Verdict> = rulings.iter().map(verdict).collect();
        WHOLE.mark(&mut verdicts, "here", "euler");
        verdicts.iter().map(|v| (v.known_deviation.is_some(), v.verdict)).collect()
    }

    use Ruling::{Broken, Fail, Inconclusive, NotApplicable, Pass};

    #[test]
    fn what_does_not_hold_is_known_and_what_does_not_apply_is_left() {
        let found = marked("euler", &[("spin", Fail), ("angle", Inconclusive), ("all", Broken)]);
        assert_eq!(found, [(true, Fail), (true, Inconclusive), (true, Broken)]);
        let found = marked("euler", &[("spin", NotApplicable), ("angle", Fail)]);
        assert_eq!(found, [(false, NotApplicable), (true, Fail)]);
    }

    #[test]
    fn a_deviation_that_is_gone_fails_as_a_whole() {
        assert_eq!(marked("euler", &[("spin", Pass), ("angle", Pass)]), [(false, Fail); 2]);
        assert_eq!(marked("euler", &[("spin", Pass), ("angle", Fail)]), [(false, Pass), (true, Fail)]);
    }

    #[test]
    fn every_row_of_the_table_is_applied() {
        for known in KNOWN {
            for (scene, schemes) in known.places {
                let mut verdicts = [Verdict {
                    scene: (*scene).to_owned(),
                    scheme: schemes[0].to_owned(),
                    claim: known.claim,
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
        assert_eq!(marked(variant, &[("spin", Pass), ("angle", Pass)]), [(false, Pass); 2]);
        assert_eq!(marked(variant, &[("spin", Fail)]), [(true, Fail)]);
        assert_eq!(marked("substepped-2-rkmk4", &[("spin", Fail)]), [(false, Fail)]);
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
