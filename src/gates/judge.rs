//! Every claim to its gate: the match is exhaustive.

use super::{
    Case, convergence, deviations, energy, equivariant, evaluations, exact, flip_times, follows_tolerance,
    order, order_here, reduction, reversible, rigid, ruled, solves, stability, symplectic, vertical_momentum,
};
use crate::claim::Claim;
use crate::record::{ClaimName, Ruling, Verdict};
use crate::schemes::Card;

/// Judges every claim of a scheme in a scene.
pub fn judge(case: &Case) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for claim in case.card.claims {
        match *claim {
            // A program under test is judged by the rule below.
            Claim::Order(_) if case.evidence.by_rule.is_some() => {}
            Claim::Order(order) => verdicts.extend(order::judge(case, order_here(case, order))),
            // Judged in place of the order, in the scenes that it speaks of.
            Claim::OrderWithoutTorque(_) => {}
            Claim::FollowsTolerance(power) => verdicts.extend(follows_tolerance::judge(case, power)),
            Claim::Exact(quantity, when) => verdicts.extend(exact::judge(case, quantity, when)),
            Claim::Energy(energy) => verdicts.extend(energy::judge(case, energy)),
            Claim::VerticalMomentum => verdicts.extend(vertical_momentum::judge(case)),
            Claim::FlipTimes => verdicts.extend(flip_times::judge(case)),
            Claim::Rigid => verdicts.extend(rigid::judge(case)),
            Claim::Reversible => verdicts.push(reversible::judge(case)),
            Claim::Symplectic => verdicts.push(symplectic::judge(case)),
            Claim::Equivariant => verdicts.extend(equivariant::judge(case)),
            Claim::Evaluations(count) => verdicts.extend(evaluations::judge(case, count)),
            Claim::Solves(count) => verdicts.push(solves::judge(case, count)),
        }
    }
    verdicts.extend(case.evidence.by_rule.iter().flat_map(|by_rule| convergence::judge(case, by_rule)));
    verdicts.extend(reduction::judge(case));
    verdicts.extend(stability::judge(case));
    verdicts.extend(judge_without_order(case));
    deviations::apply(&mut verdicts);
    verdicts
}

/// A scheme that claims no order is not judged by its ladder; that its runs broke is said all the same.
fn judge_without_order(case: &Case) -> Option<Verdict> {
    let broken = case.evidence.rungs.iter().find_map(|rung| rung.outcome.broken.as_ref())?;
    (case.card.order() == 0).then(|| ruled(case, ClaimName::Run, "all", Ruling::Broken, broken.to_string()))
}

/// The verdicts of a scheme that cannot take a scene: every claim not applicable, with the reason.
pub fn refuse(scene: &str, card: &Card, reason: &str) -> Vec<Verdict> {
    card.claims
        .iter()
        .map(|claim| Verdict {
            scene: scene.to_owned(),
            scheme: card.name.to_owned(),
            claim: claim.name(),
            quantity: "all".to_owned(),
            verdict: Ruling::NotApplicable,
            detail: reason.to_owned(),
            ..Verdict::default()
        })
        .collect()
}
