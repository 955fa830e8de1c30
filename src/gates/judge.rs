//! Every claim to its gate: the match is exhaustive.

use super::{
    Baseline, budget, deviations, energy, equivariant, evaluations, exact, flip_times, follows_tolerance,
    on_record, order, reduction, reference, reversible, rigid, ruled, solves, stability, symplectic,
    vertical_momentum,
};
use crate::claim::Claim;
use crate::record::{Evidence, Records, Ruling, Verdict};

/// Judges every claim of a scheme in a scene, by what was measured and what is on record.
pub fn judge(evidence: &Evidence, baseline: &Baseline) -> Vec<Verdict> {
    if let Some(reason) = &evidence.refused {
        let of_claim =
            |claim: &Claim| ruled(evidence, claim.name(), "all", Ruling::NotApplicable, reason.as_str());
        return evidence.claims.iter().map(of_claim).collect();
    }
    if evidence.is_unaffordable() {
        return budget::judge(evidence).into_iter().collect();
    }
    let mut verdicts = Vec::new();
    for claim in &evidence.claims {
        match *claim {
            // Both are judged once, with whether the runs converge to the truth.
            Claim::Order(_) | Claim::OrderWithoutTorque(_) | Claim::SolvesAnotherMotion => {}
            Claim::FollowsTolerance(power) => verdicts.extend(follows_tolerance::judge(evidence, power)),
            Claim::Exact(quantity, when) => verdicts.extend(exact::judge(evidence, quantity, when)),
            Claim::Energy(energy) => verdicts.extend(energy::judge(evidence, energy)),
            Claim::VerticalMomentum => verdicts.push(vertical_momentum::judge(evidence)),
            Claim::FlipTimes => verdicts.push(flip_times::judge(evidence)),
            Claim::Rigid => verdicts.push(rigid::judge(evidence)),
            Claim::Reversible => verdicts.push(reversible::judge(evidence)),
            Claim::Symplectic => verdicts.push(symplectic::judge(evidence)),
            Claim::Equivariant => verdicts.push(equivariant::judge(evidence)),
            Claim::Evaluations(count) => verdicts.push(evaluations::judge(evidence, count)),
            Claim::Solves(count) => verdicts.push(solves::judge(evidence, count)),
        }
    }
    verdicts.extend(order::judge(evidence, baseline));
    verdicts.extend(on_record::judge_cell(evidence, baseline));
    verdicts.push(reduction::judge(evidence));
    verdicts.extend(stability::judge(evidence));
    verdicts.extend(budget::judge(evidence));
    if evidence.setting.built_in {
        deviations::apply(&mut verdicts);
    }
    verdicts
}

/// Judges stored evidence: the references first, then every scheme in every scene.
pub fn judge_all(records: &Records, baseline: &Baseline) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for scene in &records.scenes {
        let references = records.references.iter().filter(|row| row.scene == scene.name);
        verdicts.extend(references.map(reference::judge_reference));
        let measured = records.evidence.iter().filter(|row| row.scene == scene.name);
        verdicts.extend(measured.flat_map(|row| judge(row, baseline)));
    }
    verdicts
}
