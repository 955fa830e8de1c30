//! What was measured beside what is on record: the order first, then the error constant, the error of every run of the same step, the claims, the
//! drift of the energy and the work.

use super::{Baseline, ruled};
use crate::claim::Claim;
use crate::measure::{Asked, BELOW, Decision, Run, SAME_TIME};
use crate::model::Quantity;
use crate::record::{ClaimName, DriftClass, EnergyDrift, EnergyRung, Evidence, Ruling, Verdict};

/// Largest relative change of an error constant, and growth of the evaluations of a run: an iteration may take another turn on another
/// processor.
const SAME: f64 = 0.01;
/// Least relative change of the error of a run that shows another scheme: what r tends to for a wrong order.
const CHANGED: f64 = 0.5;

fn same_step(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < SAME_TIME
}

/// Order, constant and errors of a quantity. `order_fails` says that the order is below the claimed one.
pub(super) fn judge_quantity(
    evidence: &Evidence,
    quantity: Quantity,
    (decision, order_fails): (&Decision, bool),
    baseline: &Baseline,
) -> Vec<Verdict> {
    let order = judge_order(evidence, quantity, decision, baseline);
    let order_fails = order_fails || order.as_ref().is_some_and(|verdict| verdict.verdict == Ruling::Fail);
    let constant = judge_constant(evidence, quantity, (decision, order_fails), baseline);
    let errors = judge_errors(evidence, quantity, baseline);
    [order, constant, errors].into_iter().flatten().collect()
}

/// The order against the one on record, whatever the scheme claims today.
fn judge_order(
    evidence: &Evidence,
    quantity: Quantity,
    decision: &Decision,
    baseline: &Baseline,
) -> Option<Verdict> {
    let name = quantity.name();
    let known = baseline.find(&evidence.setting.content, &evidence.known_as, name)?.order?;
    let rule = |ruling, detail| ruled(evidence, ClaimName::OrderOnRecord, name, ruling, detail);
    let verdict = match decision {
        Decision::Order(found) => {
            let ruling = if found.order < known { Ruling::Fail } else { Ruling::Pass };
            let verdict = rule(ruling, format!("order was {known}, now {}", found.order));
            Verdict { measured: Some(f64::from(found.order)), ..verdict }
        }
        Decision::Exact => {
            rule(Ruling::Pass, format!("order was {known}, now every error is at its rounding"))
        }
        Decision::Elsewhere { .. } => {
            rule(Ruling::Fail, format!("order was {known}, now the runs converge to another motion"))
        }
        Decision::Undecided(_) => {
            rule(Ruling::Inconclusive, format!("order was {known}, now none is decided"))
        }
    };
    Some(Verdict { low: Some(f64::from(known)), ..verdict })
}

/// The error constant against the one on record. Constants of two orders have no common unit: where the order fails nothing is judged.
fn judge_constant(
    evidence: &Evidence,
    quantity: Quantity,
    (decision, order_fails): (&Decision, bool),
    baseline: &Baseline,
) -> Option<Verdict> {
    let name = quantity.name();
    let recorded = baseline.find(&evidence.setting.content, &evidence.known_as, name)?;
    let known = recorded.constant?;
    let rule = |ruling, detail| ruled(evidence, ClaimName::Constant, name, ruling, detail);
    let Decision::Order(found) = decision else {
        // Exact or another motion: the error is not that of the record.
        let other = !matches!(decision, Decision::Undecided(_));
        let ruling = if other { Ruling::Fail } else { Ruling::Inconclusive };
        return Some(rule(ruling, format!("constant {known:.4e} on record, none measured")));
    };
    if order_fails || recorded.order.is_some_and(|order| order != found.order) {
        let detail =
            format!("not judged: the order is {}, another one than on record or claimed", found.order);
        return Some(rule(Ruling::NotApplicable, detail));
    }
    let allowed = baseline.tolerance((&evidence.scene, name), |one| one.constant).unwrap_or(SAME);
    let constant = found.constant;
    let ruling = if (constant / known - 1.0).abs() <= allowed { Ruling::Pass } else { Ruling::Fail };
    let (percent, ratio) = (100.0 * allowed, constant / known);
    Some(Verdict {
        measured: Some(constant),
        low: Some(known * (1.0 - allowed)),
        high: Some(known * (1.0 + allowed)),
        ..rule(ruling, format!("C = {constant:.4e}, on record {known:.4e} ± {percent} %: ratio {ratio:.4}"))
    })
}

/// The error of every run against that of the same step on record. `None` where no step is on record.
fn judge_errors(evidence: &Evidence, quantity: Quantity, baseline: &Baseline) -> Option<Verdict> {
    let name = quantity.name();
    let recorded = baseline.find(&evidence.setting.content, &evidence.known_as, name)?;
    let allowed = baseline.tolerance((&evidence.scene, name), |one| one.error).unwrap_or(CHANGED);
    let asked = Asked::of(&evidence.ladder, quantity);
    let compared = |run: &Run| {
        let (_, known, floor) = recorded.errors.iter().find(|(step, ..)| same_step(*step, run.step))?;
        let error = if run.errors.is_empty() { f64::INFINITY } else { asked.error(run) };
        let holds = (error - known).abs() <= allowed * known + asked.floor_of(run) + floor;
        Some((holds, run.step, error, *known))
    };
    let pairs: Vec<(bool, f64, f64, f64)> = asked.runs.iter().filter_map(compared).collect();
    let rule = |ruling, detail| ruled(evidence, ClaimName::ErrorOnRecord, name, ruling, detail);
    let (all, unit) = (recorded.errors.len(), quantity.unit());
    let changed = pairs.iter().filter(|(holds, ..)| !holds).count();
    let worst = pairs.iter().filter(|(holds, ..)| !holds).max_by(|a, b| (a.2 / a.3).total_cmp(&(b.2 / b.3)));
    let Some((_, step, error, known)) = worst else {
        let compared = pairs.len();
        let missing = if compared < all { Ruling::NotApplicable } else { Ruling::Pass };
        let ruling = if compared > 0 { Ruling::Pass } else { missing };
        return (all > 0).then(|| rule(ruling, format!("{compared} of {all} runs compared")));
    };
    let ratio = error / known;
    let detail = format!(
        "{changed} of {} runs changed: error over the run {error:.2e} {unit} at h = {step:.2e} s, {known:.2e} {unit} on record: {ratio:.2} \
         times as large",
        pairs.len()
    );
    Some(Verdict {
        measured: error.is_finite().then_some(*error),
        high: Some(*known),
        ..rule(Ruling::Fail, detail)
    })
}

/// Claims, drift and work of a scheme in a scene.
pub(super) fn judge_cell(evidence: &Evidence, baseline: &Baseline) -> Vec<Verdict> {
    let Some(recorded) = baseline.cell(&evidence.setting.content, &evidence.known_as) else {
        return Vec::new();
    };
    let drift = recorded.drift.as_ref().and_then(|known| judge_drift(evidence, known));
    let claims = judge_claims(evidence, &recorded.claims);
    [claims, judge_work(evidence, &recorded.work), drift].into_iter().flatten().collect()
}

/// The claims against those on record: what is not claimed is not judged, and a gate that no longer judges is not green. `None` where none is
/// on record.
fn judge_claims(evidence: &Evidence, recorded: &[Claim]) -> Option<Verdict> {
    let made = |known: &&Claim| evidence.claims.iter().any(|claim| claim.contains(**known));
    let (made, gone): (Vec<&Claim>, Vec<&Claim>) = recorded.iter().partition(made);
    let rule = |ruling, detail| ruled(evidence, ClaimName::ClaimsOnRecord, "claims", ruling, detail);
    let verdict = if gone.is_empty() {
        rule(Ruling::Pass, format!("{} of {} claims are made", made.len(), recorded.len()))
    } else {
        let gone: Vec<String> = gone.iter().map(ToString::to_string).collect();
        rule(Ruling::Fail, format!("no longer claimed: {}", gone.join("; ")))
    };
    let (now, known) = (made.len() as f64, recorded.len() as f64);
    (!recorded.is_empty()).then_some(Verdict { measured: Some(now), low: Some(known), ..verdict })
}

/// The evaluations of every run against those of the same step on record.
fn judge_work(evidence: &Evidence, recorded: &[(f64, u64)]) -> Option<Verdict> {
    let pair = |step: f64, evaluations: u64| {
        let (_, known) = recorded.iter().find(|(known, _)| same_step(*known, step))?;
        Some((step, evaluations, *known))
    };
    let runs = evidence.ladder.rungs.iter().filter(|rung| rung.broken.is_none());
    let pairs: Vec<(f64, u64, u64)> = runs.filter_map(|rung| pair(rung.step, rung.evaluations)).collect();
    let grows = |(_, now, known): &&(f64, u64, u64)| *now as f64 > (1.0 + SAME) * *known as f64;
    let worst = pairs.iter().filter(grows).max_by_key(|(_, now, known)| now.saturating_sub(*known));
    let rule = |ruling, detail| ruled(evidence, ClaimName::WorkOnRecord, "evaluations", ruling, detail);
    match worst {
        _ if pairs.is_empty() => None,
        None => Some(rule(Ruling::Pass, format!("{} of {} runs compared", pairs.len(), recorded.len()))),
        Some((step, now, known)) => {
            let detail = format!("{now} force evaluations at h = {step:.2e} s, {known} on record");
            let verdict = rule(Ruling::Fail, detail);
            Some(Verdict { measured: Some(*now as f64), high: Some(*known as f64), ..verdict })
        }
    }
}

/// The drift of the energy: its kind, and its rate in every run of the same step. `None` where neither was measured.
fn judge_drift(evidence: &Evidence, known: &EnergyDrift) -> Option<Verdict> {
    let now = evidence.drift.as_ref()?;
    let rule = |ruling, detail| Some(ruled(evidence, ClaimName::DriftOnRecord, "energy", ruling, detail));
    let undecided = now.class == DriftClass::Undecided || known.class == DriftClass::Undecided;
    // The kinds stand in the order of their harm.
    if !undecided && now.class > known.class {
        return rule(Ruling::Fail, format!("the drift of the energy was {}, now {}", known.class, now.class));
    }
    let pair =
        |run: &EnergyRung| Some((*run, *known.rungs.iter().find(|one| same_step(one.step, run.step))?));
    let pairs: Vec<(EnergyRung, EnergyRung)> = now.rungs.iter().filter_map(pair).collect();
    let grows = |(now, known): &&(EnergyRung, EnergyRung)| {
        // A rounding of the energy over a run is one of its rate.
        let rounding = |run: &EnergyRung| run.rounding / BELOW / (run.step * run.steps as f64);
        let open = now.uncertainty + known.uncertainty + rounding(now) + rounding(known);
        // A rate is known to a tenth.
        now.rate.abs() > (1.0 + BELOW) * known.rate.abs() + open
    };
    match pairs.iter().find(grows) {
        _ if pairs.is_empty() => None,
        None => rule(
            Ruling::Pass,
            format!("{}: {} of {} rates compared", now.class, pairs.len(), known.rungs.len()),
        ),
        Some((run, old)) => {
            let verdict = rule(
                Ruling::Fail,
                format!(
                    "the energy drifts at {:.2e} 1/s at h = {:.2e} s, {:.2e} 1/s on record",
                    run.rate, run.step, old.rate
                ),
            )?;
            let measured = run.rate.is_finite().then_some(run.rate);
            Some(Verdict { measured, high: Some(old.rate.abs()), ..verdict })
        }
    }
}
