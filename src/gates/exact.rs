//! The exactness gate: every error of the ladder at its rounding, by the rule of orders, in steps of any size where the spin is steady; L of the
//! point form too.

use super::{applies, at_most, ruled, walk};
use crate::claim::{Quantity, When};
use crate::measure::{Asked, Decision, Doubt, Run, decide};
use crate::record::{ClaimName, Evidence, PointRun, Rule, Ruling, Verdict, length};

/// Relative change of L that n steps of the point form may leave: the rounding of L + h τ in each, and that of
/// Σ X̃_k × F_k.
fn momentum_rounding(points: &PointRun) -> f64 {
    points.unit * walk(points.steps) + points.torque_rounding
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

/// Error and rounding of the run whose error is the most roundings; `None` where all broke.
fn worst(asked: &Asked) -> Option<(f64, f64)> {
    let size = |run: &Run| (length(&run.errors), asked.floor(run, asked.times.len()));
    let whole = asked.runs.iter().filter(|run| !run.errors.is_empty()).map(size);
    whole.max_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)))
}

/// The runs in double-double where there are any, unless an error in f64 is above its rounding: a defect of that code alone is one.
fn judge_ladder(evidence: &Evidence, quantity: Quantity) -> Verdict {
    let unit = quantity.unit();
    let rule = |ruling, detail| ruled(evidence, ClaimName::Exact, quantity.name(), ruling, detail);
    let own = Asked::of(&evidence.ladder, quantity);
    let Some((own_error, own_floor)) = worst(&own) else {
        return rule(Ruling::Broken, "every run of the ladder broke".to_owned());
    };
    let precise = evidence.exactness.as_ref().map(|ladder| Asked::of(ladder, quantity));
    let precise = precise.and_then(|asked| Some((worst(&asked)?, decide(&asked))));
    // Of a single run nothing is decided: the others broke, where their steps are too large for an iteration.
    let precise =
        precise.filter(|(_, found)| !matches!(found, Decision::Undecided(Doubt::FewRuns { whole: 0 | 1 })));
    let ((error, floor), decision, beside) = match precise.filter(|_| own_error <= own_floor) {
        Some((sizes, found)) => {
            (sizes, found, format!(" in double-double; rounding in f64 {own_error:.1e} {unit}"))
        }
        None => ((own_error, own_floor), decide(&own), String::new()),
    };
    let (ruling, remark) = match decision {
        Decision::Exact => (Ruling::Pass, String::new()),
        Decision::Order(found) => (Ruling::Fail, format!(", and falls with order {}", found.order)),
        Decision::Elsewhere { .. } => (Ruling::Fail, ", however small the step".to_owned()),
        Decision::Undecided(_) if error <= floor => {
            (Ruling::Inconclusive, ": too much to call anything exact".to_owned())
        }
        Decision::Undecided(_) => (Ruling::Fail, String::new()),
    };
    let detail = format!(
        "largest error of the ladder {error:.2e} {unit}, its rounding allows {floor:.2e} {unit}{remark}{beside}"
    );
    let ruled = rule(ruling, detail).undecided_by(Rule::Open);
    Verdict { measured: Some(error), low: Some(0.0), high: Some(floor), ..ruled }
}
