//! Flips of a tumbling body: as many as the truth has, at times that converge to the exact ones.
//!
//! Near the separatrix an error of the energy is amplified by the logarithmic period, so that the order of the
//! times may exceed that of the scheme: what is asked is that they converge at least as fast as claimed.

use super::{Case, open_angle, ruled};
use crate::metrics::{BAND, Flips};
use crate::record::{Ruling, Verdict};
use crate::regression;

/// Rungs, at the fine end, that must have the right number of flips.
const COUNTED: usize = 3;

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    let name = "flip-times";
    let Some(flips) = case.flips else {
        let detail = "the body does not tumble freely about its middle axis";
        return vec![ruled(case, name, name, Ruling::NotApplicable, detail)];
    };
    if let Some(open) = open_angle(case) {
        let detail = format!(
            "rounding and reference leave {open:.1e} rad open: whether and when the body flips is not known"
        );
        return vec![ruled(case, name, name, Ruling::Inconclusive, detail)];
    }
    let fine = &flips.rungs[flips.rungs.len() - COUNTED..];
    let counts: Vec<usize> = fine.iter().map(|rung| rung.times.len()).collect();
    if counts.iter().any(|count| *count != flips.truth.len()) {
        let detail = format!("{} flips in truth, {counts:?} at the three finest steps", flips.truth.len());
        return vec![ruled(case, name, name, Ruling::Fail, detail)];
    }
    if flips.truth.is_empty() {
        let detail = "no flip, as in truth, at the three finest steps";
        return vec![ruled(case, name, name, Ruling::Pass, detail)];
    }
    vec![judge_convergence(case, flips, fine.len())]
}

fn judge_convergence(case: &Case, flips: &Flips, counted: usize) -> Verdict {
    let ladder: Vec<(f64, f64)> = flips.rungs[flips.rungs.len() - counted..]
        .iter()
        .map(|rung| (rung.step, late(flips, &rung.times)))
        .collect();
    let (step, error) = ladder[ladder.len() - 1];
    let order = f64::from(case.card.order());
    let slope = regression::fit_power(&ladder).map(|fit| fit.slope);
    let (verdict, measured) = match slope {
        Some(slope) if slope >= order - BAND => (Ruling::Pass, Some(slope)),
        Some(slope) => (Ruling::Fail, Some(slope)),
        None => (Ruling::Inconclusive, None),
    };
    let slope_text = measured.map_or("not to be read".to_owned(), |slope| format!("{slope:.2}"));
    Verdict {
        measured,
        low: Some(order - BAND),
        ..ruled(
            case,
            "flip-times",
            "flip-times",
            verdict,
            format!(
                "{} flips; largest error of a time {error:.2e} s at h = {step:.2e} s, order {slope_text}, at least {:.2} claimed",
                flips.truth.len(),
                order - BAND
            ),
        )
    }
}

/// Largest error of a flip time [s].
fn late(flips: &Flips, times: &[f64]) -> f64 {
    times.iter().zip(&flips.truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
