//! Flips of a tumbling body: as many as the truth has, at times that converge to the exact ones.
//!
//! Near the separatrix an error of the energy is amplified by the logarithmic period, so that the order of the
//! times may exceed that of the scheme: what is asked is that they converge at least as fast as claimed.

use super::{Case, open_angle, ruled};
use crate::measure::regression::{self, FEWEST_SLOPES, Fit, Ladder};
use crate::measure::{BAND, Flips};
use crate::model::Quantity;
use crate::record::{ClaimName, Ruling, Verdict};

/// Rungs, at the fine end, that must have the right number of flips.
const COUNTED: usize = 3;
/// Error of a time over its floor from which on it stands clear.
const CLEAR: f64 = 10.0;

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    let name = "flip-times";
    let Some(flips) = case.flips else {
        let detail = "the body does not tumble freely about its middle axis";
        return vec![ruled(case, ClaimName::FlipTimes, name, Ruling::NotApplicable, detail)];
    };
    if let Some(open) = open_angle(case) {
        let detail = format!(
            "rounding and reference leave {open:.1e} rad open: whether and when the body flips is not known"
        );
        return vec![ruled(case, ClaimName::FlipTimes, name, Ruling::Inconclusive, detail)];
    }
    let fine = &flips.rungs[flips.rungs.len() - COUNTED..];
    let counts: Vec<usize> = fine.iter().map(|rung| rung.times.len()).collect();
    let truth = flips.truth.times.len();
    if counts.iter().any(|count| *count != truth) {
        let detail = format!("{truth} flips in truth, {counts:?} at the three finest steps");
        return vec![ruled(case, ClaimName::FlipTimes, name, Ruling::Fail, detail)];
    }
    if truth == 0 {
        let detail = "no flip, as in truth, at the three finest steps";
        return vec![ruled(case, ClaimName::FlipTimes, name, Ruling::Pass, detail)];
    }
    vec![judge_convergence(case, flips)]
}

fn judge_convergence(case: &Case, flips: &Flips) -> Verdict {
    let finest = case.evidence.rungs.last();
    let rounding = finest.map_or(0.0, |rung| rung.floors[Quantity::Orientation].max);
    let ladder = flips.ladder(rounding);
    let (step, error, floor) = ladder[ladder.len() - 1];
    let least = f64::from(case.card.order()) - BAND;
    let known = error <= CLEAR * floor;
    let fit = match regression::find_window(&ladder) {
        Ladder::Window { fit, .. } => Some(fit),
        _ => None,
    };
    let (verdict, words) = match fit {
        Some(fit) if fit.low >= least => (Ruling::Pass, slope(&fit)),
        Some(fit) if fit.high < least => (Ruling::Fail, slope(&fit)),
        // Whatever the slopes are, the times have come to the exact ones.
        _ if known => (Ruling::Pass, "at its floor".to_owned()),
        Some(fit) => (Ruling::Inconclusive, slope(&fit)),
        // Faster than claimed is claimed too, whether or not the slopes agree.
        None => {
            let last = last_slopes(&ladder);
            let fast = last.len() == FEWEST_SLOPES && last.iter().all(|slope| *slope >= least);
            let words = format!("slopes {last:.2?}, which do not agree to 0.15");
            (if fast { Ruling::Pass } else { Ruling::Inconclusive }, words)
        }
    };
    Verdict {
        measured: fit.map(|fit| fit.slope),
        low: fit.map(|fit| fit.low),
        high: fit.map(|fit| fit.high),
        ..ruled(
            case,
            ClaimName::FlipTimes,
            "flip-times",
            verdict,
            format!(
                "{} flips; largest error of a time {error:.2e} s at h = {step:.2e} s, floor {floor:.1e} s: {words}; an order of at least {least:.2} is claimed",
                flips.truth.times.len()
            ),
        )
    }
}

/// Slopes of the last rungs in a row that stand clear, three at most.
fn last_slopes(ladder: &[(f64, f64, f64)]) -> Vec<f64> {
    let is_clear = |rung: &(f64, f64, f64)| rung.1.is_finite() && rung.1 > CLEAR * rung.2;
    let end = ladder.iter().rposition(is_clear).map_or(0, |last| last + 1);
    let start = ladder[..end].iter().rposition(|rung| !is_clear(rung)).map_or(0, |last| last + 1);
    let start = start.max(end.saturating_sub(FEWEST_SLOPES + 1));
    ladder[start..end].windows(2).map(|w| (w[0].1 / w[1].1).ln() / (w[0].0 / w[1].0).ln()).collect()
}

fn slope(fit: &Fit) -> String {
    format!("order {:.3} [{:.3}, {:.3}]", fit.slope, fit.low, fit.high)
}
