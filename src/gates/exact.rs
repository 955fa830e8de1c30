//! The exactness gate: every error of the ladder at its rounding, by the rule of orders, in steps of any size where the spin is steady; L of the
//! point form too.

use super::{applies, at_most, ruled};
use crate::claim::{Quantity, When};
use crate::measure::{Asked, Decision, Run, decide};
use crate::record::{ClaimName, Evidence, PointRun, Ruling, Verdict, length};

/// Relative change of L that n steps of the point form may leave: the rounding of L + h τ in each, and that of
/// Σ X̃_k × F_k.
fn momentum_rounding(points: &PointRun) -> f64 {
    points.unit * (8.0 + 4.0 * (points.steps as f64).sqrt()) + points.torque_rounding
}

pub(super) fn judge(evidence: &Evidence, quantity: Quantity, when: When) -> Vec<Verdict> {
    if !applies(&evidence.setting, when) {
        let detail = "the scene is not one that the promise is made for";
        return vec![ruled(evidence, ClaimName::Exact, quantity.name(), Ruling::NotApplicable, detail)];
    }
    let mut verdicts = vec![judge_ladder(evidence, quantity)];
    if quantity == Quantity::AngularMomentum
        && let Some(points) = &evidence.points
        && let Some(change) = points.momentum_change
    {
        let bound = momentum_rounding(points);
        let detail = format!(
            "relative change of L in {} steps of the point form: {change:.2e} ≤ {bound:.2e}",
            points.steps
        );
        verdicts.push(at_most(evidence, ClaimName::Exact, "angular-momentum-points", change, bound, detail));
    }
    verdicts
}

fn judge_ladder(evidence: &Evidence, quantity: Quantity) -> Verdict {
    let asked = Asked::of(&evidence.ladder, quantity);
    let unit = quantity.unit();
    let rule = |ruling, detail| ruled(evidence, ClaimName::Exact, quantity.name(), ruling, detail);
    let size = |run: &Run| (length(&run.errors), asked.floor(run, asked.times.len()));
    let whole = asked.runs.iter().filter(|run| !run.errors.is_empty()).map(size);
    let Some((error, floor)) = whole.max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1))) else {
        return rule(Ruling::Broken, "every run of the ladder broke".to_owned());
    };
    let (ruling, remark) = match decide(&asked) {
        Decision::Exact => (Ruling::Pass, String::new()),
        Decision::Order(found) => (Ruling::Fail, format!(", and falls with order {}", found.order)),
        Decision::Elsewhere { .. } => (Ruling::Fail, ", however small the step".to_owned()),
        Decision::Undecided(_) if error <= floor => {
            (Ruling::Inconclusive, ": too much to call anything exact".to_owned())
        }
        Decision::Undecided(_) => (Ruling::Fail, String::new()),
    };
    let detail = format!(
        "largest error of the ladder {error:.2e} {unit}, its rounding allows {floor:.2e} {unit}{remark}"
    );
    Verdict { measured: Some(error), low: Some(0.0), high: Some(floor), ..rule(ruling, detail) }
}
