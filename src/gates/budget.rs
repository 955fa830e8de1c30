//! What a budget of time leaves undecided. Runs that it leaves out and that nothing waits for are no matter.

use super::{promised_exact, ruled};
use crate::claim::Claim;
use crate::measure::{Decision, decide_either};
use crate::quantity::Quantity;
use crate::record::{ClaimName, Evidence, LeftOut, Ruling, Verdict};

pub(super) fn judge(evidence: &Evidence) -> Option<Verdict> {
    let left_out = evidence.left_out?;
    let open = open(evidence, &left_out);
    let runs = match left_out.steps {
        _ if evidence.is_unaffordable() => "every run".to_owned(),
        Some(steps) => format!("runs of {steps} steps and more"),
        None => "long runs".to_owned(),
    };
    let seconds = left_out.seconds;
    let (ruling, left) = if open.is_empty() {
        (Ruling::NotApplicable, "the others decide everything".to_owned())
    } else {
        let larger =
            format!("a larger budget would decide it, with {seconds:.3} s for this scheme in this scene");
        (Ruling::Inconclusive, format!("{} undecided: {larger}", open.join(", ")))
    };
    let quantity = if evidence.is_unaffordable() { "all" } else { "runs" };
    let detail = format!("the budget leaves out {runs}; {left}");
    let verdict = ruled(evidence, ClaimName::Budget, quantity, ruling, detail);
    Some(Verdict { measured: Some(seconds), ..verdict })
}

/// What waits for the runs that are left out.
fn open(evidence: &Evidence, left_out: &LeftOut) -> Vec<&'static str> {
    if evidence.is_unaffordable() {
        return vec!["everything"];
    }
    let judged = evidence.order() > 0 && evidence.setting.not_for_order.is_none();
    let waits = |quantity: &Quantity| {
        let (decision, _) = decide_either(evidence.ladders(), *quantity);
        matches!(decision, Decision::Undecided(_)) && !promised_exact(evidence, *quantity)
    };
    let quantities = Quantity::ALL.into_iter().filter(|_| judged && left_out.steps.is_some()).filter(waits);
    let energy = evidence.claims.iter().any(|claim| matches!(claim, Claim::Energy(_))) && left_out.drift;
    quantities.map(Quantity::name).chain(energy.then_some("energy of a free body")).collect()
}
