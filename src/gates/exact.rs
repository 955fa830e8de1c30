//! The exactness gate: every error of the ladder at the floor of rounding and reference, at the end and over the
//! run; L of the point form too.

use super::{Case, applies, at_most, open_angle, ruled};
use crate::claim::{Quantity, When};
use crate::measure::regression::Ladder;
use crate::measure::{Place, PointRun, QuantityLadder, Rung};
use crate::record::{ClaimName, Ruling, Verdict};

/// Relative change of L that n steps of the point form may leave: the rounding of L + h τ in each, and that of
/// Σ X̃_k × F_k.
fn momentum_rounding(points: &PointRun) -> f64 {
    f64::EPSILON * (8.0 + 4.0 * (points.steps as f64).sqrt()) + points.torque_rounding
}

pub(super) fn judge(case: &Case, quantity: Quantity, when: When) -> Vec<Verdict> {
    if !applies(case.system, when) {
        let detail = "the scene is not one that the promise is made for";
        return vec![ruled(case, ClaimName::Exact, quantity.name(), Ruling::NotApplicable, detail)];
    }
    if matches!(quantity, Quantity::Orientation | Quantity::AngularVelocity)
        && let Some(open) = open_angle(case)
    {
        let detail =
            format!("rounding and reference leave {open:.1e} rad open: too much to call anything exact");
        return vec![ruled(case, ClaimName::Exact, quantity.name(), Ruling::Inconclusive, detail)];
    }
    let mut verdicts = Vec::new();
    for place in Place::ALL {
        let name = format!("{}-{}", quantity.name(), place.suffix());
        let ladder = case.evidence.ladders.iter().find(|l| l.quantity == quantity && l.place == place);
        if let Some(ladder) = ladder {
            verdicts.push(judge_ladder(case, &name, ladder));
        }
    }
    verdicts.extend(judge_giant_steps(case, quantity));
    if quantity == Quantity::AngularMomentum
        && let Some(points) = case.points
        && let Some(change) = points.momentum_change
    {
        let bound = momentum_rounding(points);
        let detail = format!(
            "relative change of L in {} steps of the point form: {change:.2e} ≤ {bound:.2e}",
            points.steps
        );
        verdicts.push(at_most(case, ClaimName::Exact, "angular-momentum-points", change, bound, detail));
    }
    verdicts
}

/// A body in steady spin, in one step and in a few: exact is exact at every step that can be made.
fn judge_giant_steps(case: &Case, quantity: Quantity) -> Option<Verdict> {
    let name = format!("{}-giant-steps", quantity.name());
    let ratio = |rung: &&Rung| {
        let (error, floor) = (rung.errors[quantity].end, rung.floors[quantity].end);
        if error == 0.0 { 0.0 } else { error / floor }
    };
    let whole = case.evidence.giant_steps.iter().filter(|rung| rung.outcome.broken.is_none());
    let worst = whole.max_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let (error, bound) = (worst.errors[quantity].end, 10.0 * worst.floors[quantity].end);
    let unit = quantity.unit();
    let detail = format!(
        "the whole run in 1 to 7 steps, worst in {}: {error:.2e} {unit}, ten times its floor {bound:.2e} {unit}",
        worst.steps
    );
    Some(at_most(case, ClaimName::Exact, &name, error, bound, detail))
}

fn judge_ladder(case: &Case, name: &str, ladder: &QuantityLadder) -> Verdict {
    let unit = ladder.quantity.unit();
    // Where a step is so large that the scheme itself amplifies a rounding to an angle that can be seen, nothing is exact.
    let turns = matches!(ladder.quantity, Quantity::Orientation | Quantity::AngularVelocity);
    let open = |run: &Rung| turns && run.is_open(case.system);
    let whole = ladder.rungs.iter().zip(&case.evidence.rungs);
    let whole = whole.filter(|(_, run)| run.outcome.broken.is_none() && !open(run));
    let worst = whole.map(|(rung, _)| rung).max_by(|a, b| (a.1 - 10.0 * a.2).total_cmp(&(b.1 - 10.0 * b.2)));
    let (error, bound) = worst.map_or((f64::NAN, f64::NAN), |rung| (rung.1, 10.0 * rung.2));
    match ladder.ladder {
        _ if worst.is_none() => {
            let detail = "rounding leaves too much open in every run to call anything exact";
            ruled(case, ClaimName::Exact, name, Ruling::Inconclusive, detail)
        }
        Ladder::Broken => ruled(case, ClaimName::Exact, name, Ruling::Broken, "a run of the ladder broke"),
        _ => at_most(
            case,
            ClaimName::Exact,
            name,
            error,
            bound,
            format!("largest error of the ladder {error:.2e} {unit}, ten times its floor {bound:.2e} {unit}"),
        ),
    }
}
