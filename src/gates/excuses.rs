//! What a slope outside the band may mean but a wrong claim: undecided then, and never a pass.
//!
//! A slope above the band says that the claimed order is too low, or that its term is too small to be seen in one quantity of one scene.
//! One below it says that the claimed order is too high, or that the runs have not come to their asymptotic range. The scene alone cannot
//! tell: a generic scene does. Where the claimed order holds there, what is seen here is no other order of the scheme.

use super::Case;
use crate::measure::regression::Ladder;
use crate::measure::{BAND, QuantityLadder};
use crate::record::{ClaimName, Ruling, Verdict};

/// Fall of the slopes of a window in all below which they are at rest.
const AT_REST: f64 = 0.04;

/// Excuses what fails, once a control has been asked for; `slopes` are the verdicts on `ladders`.
pub(super) fn apply(case: &Case, order: u32, ladders: &[&QuantityLadder], slopes: &mut [Verdict]) {
    let Some(control) = case.control else { return };
    let (bottom, top) = (f64::from(order) - BAND, f64::from(order) + BAND);
    let shows = |ladder: &&QuantityLadder| {
        ladder.fit().is_some_and(|fit| (bottom..=top).contains(&fit.slope)) || ladder.is_on_its_way(order)
    };
    let shown_here = ladders.iter().any(shows) && !control.denies(ClaimName::Order);
    let generic = control.shows(ClaimName::Order, "");
    let unsettled = ladders.iter().filter(|ladder| ladder.ladder == Ladder::Unsettled).count();
    let open = 2 * unsettled >= ladders.len();
    let lost = case.evidence.rungs.last().is_some_and(|rung| rung.is_lost(case.system));
    for (verdict, ladder) in slopes.iter_mut().zip(ladders).filter(|(v, _)| v.verdict == Ruling::Fail) {
        let why = match (ladder.fit(), generic) {
            (Some(fit), Some(scene)) if fit.low > top => format!("{scene} shows the claimed order"),
            (Some(fit), None) if fit.low > top && shown_here => {
                "other quantities of the same runs show the claimed order".to_owned()
            }
            (Some(fit), Some(scene)) => {
                let below = bottom - 1.0 + 2.0 * BAND;
                let here = if lost {
                    "rounding and reference leave more than a tenth of the body open"
                } else if open {
                    "half of the quantities of the same runs have not settled"
                } else if fit.slope > below && !falls(ladder) {
                    "at no whole order and not on the way to a lower one"
                } else {
                    continue;
                };
                format!("{here}, and {scene} shows the claimed order")
            }
            _ => continue,
        };
        verdict.verdict = Ruling::Inconclusive;
        verdict.detail += &format!("; {why}");
    }
}

/// Whether the slopes of the window fall, each below the last: a term of a lower order takes over.
fn falls(ladder: &QuantityLadder) -> bool {
    let Ladder::Window { rungs, .. } = &ladder.ladder else { return false };
    let window = &ladder.rungs[rungs.clone()];
    let slopes: Vec<f64> =
        window.windows(2).map(|w| (w[0].1 / w[1].1).ln() / (w[0].0 / w[1].0).ln()).collect();
    slopes.windows(2).all(|pair| pair[1] < pair[0]) && slopes[0] - slopes[slopes.len() - 1] > AT_REST
}
