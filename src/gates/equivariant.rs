//! The equivariance gate: other worlds, other units and the same body told in another way give the same motion, to rounding; in
//! binary units to the last bit. Where implicit equations were solved to their tolerance and no further, the verdict names what that leaves.

use super::{SOLVED_TO, left_by_solves, ruled, times};
use crate::measure::CLEAR;
use crate::record::{ClaimName, Evidence, OtherWorld, Rule, Ruling, Verdict};

/// What the verdict is about.
const WORLDS: &str = "other-worlds";

/// One verdict of all worlds: that of the worst one, which it names.
pub(super) fn judge(evidence: &Evidence) -> Verdict {
    let worlds = &evidence.other_worlds;
    let judged: Vec<Verdict> = worlds.iter().map(|world| judge_world(evidence, world)).collect();
    let harm = |verdict: &Verdict| match verdict.verdict {
        Ruling::Pass => 0,
        Ruling::Inconclusive => 1,
        _ => 2,
    };
    let worse = |a: &(&Verdict, &OtherWorld), b: &(&Verdict, &OtherWorld)| {
        let off = |verdict: &Verdict| verdict.measured.unwrap_or(f64::INFINITY);
        harm(a.0).cmp(&harm(b.0)).then(off(a.0).total_cmp(&off(b.0)))
    };
    let Some((worst, world)) = judged.iter().zip(worlds).max_by(worse) else {
        let detail =
            "no run of the ladder follows the truth to a tenth of the body's size: nothing to compare with";
        return ruled(evidence, ClaimName::Equivariant, WORLDS, Ruling::NotApplicable, detail);
    };
    let alike = judged.iter().filter(|one| one.verdict == worst.verdict).count();
    let detail = format!("{alike} of {} worlds, the worst {}: {}", worlds.len(), world.name, worst.detail);
    Verdict { detail, ..worst.clone() }
}

fn judge_world(evidence: &Evidence, world: &OtherWorld) -> Verdict {
    let bound = if world.to_the_bit { 0.0 } else { CLEAR };
    let rule = |ruling, detail: String| ruled(evidence, ClaimName::Equivariant, WORLDS, ruling, detail);
    let (Some(of_rounding), Some((quantity, difference))) = (world.of_rounding, world.worst) else {
        if world.unsolved {
            let detail =
                "an implicit equation is not solved in the other world: a smaller step would decide it";
            return rule(Ruling::Inconclusive, detail.to_owned()).by(Rule::NotSolved);
        }
        return rule(Ruling::Fail, "the run breaks in the other world and not in its own".to_owned());
    };
    let left = left_by_solves(world.solves, world.steps);
    let (ruling, named) = if of_rounding <= bound {
        (Ruling::Pass, String::new())
    } else if !world.to_the_bit && of_rounding <= CLEAR * left {
        (Ruling::Inconclusive, format!("; within what {} solves to {SOLVED_TO:.0e} leave", world.solves))
    } else {
        (Ruling::Fail, String::new())
    };
    let arithmetic = if world.double_double { " in double-double" } else { "" };
    let detail = if difference == 0.0 {
        format!("equal to the last bit{arithmetic}")
    } else {
        format!(
            "{} differs by {difference:.2e} {}{arithmetic}, {} of its rounding; at most {bound}{named}",
            quantity.name(),
            quantity.unit(),
            times(of_rounding)
        )
    };
    let ruled = rule(ruling, detail).undecided_by(Rule::Solves);
    Verdict { measured: Some(of_rounding), low: Some(0.0), high: Some(bound), ..ruled }
}
