//! The equivariance gate: other worlds, other units and the same body told in another way give the same motion, to rounding; in
//! binary units to the last bit. Where implicit equations were solved to their tolerance and no further, the verdict names what that leaves.

use super::{Case, SOLVED_TO, left_by_solves, ruled};
use crate::measure::OtherWorld;
use crate::record::{ClaimName, Ruling, Verdict};

/// Difference over its floor that rounding may leave: the same factor that tells an error from its floor elsewhere.
const CLEAR: f64 = 10.0;

pub(super) fn judge(case: &Case) -> Vec<Verdict> {
    if case.other_worlds.is_empty() {
        let detail =
            "no run of the ladder follows the truth to a tenth of the body's size: nothing to compare with";
        return vec![ruled(case, ClaimName::Equivariant, "all", Ruling::NotApplicable, detail)];
    }
    case.other_worlds.iter().map(|world| judge_world(case, world)).collect()
}

fn judge_world(case: &Case, world: &OtherWorld) -> Verdict {
    let bound = if world.to_the_bit { 0.0 } else { CLEAR };
    // NaN is a run that broke in the other world alone: no pass.
    let left = left_by_solves(world.solves, world.steps);
    let (verdict, named) = if world.of_floor <= bound {
        (Ruling::Pass, String::new())
    } else if !world.to_the_bit && world.of_floor <= CLEAR * left {
        (Ruling::Inconclusive, format!("; within what {} solves to {SOLVED_TO:.0e} leave", world.solves))
    } else {
        (Ruling::Fail, String::new())
    };
    let detail = if world.of_floor.is_nan() {
        "the run breaks in the other world and not in its own".to_owned()
    } else if world.of_floor == 0.0 {
        "equal to the last bit".to_owned()
    } else {
        format!(
            "{} differs by {:.2e} {}, {:.2} of its floor; at most {bound}{named}",
            world.quantity.name(),
            world.difference,
            world.quantity.unit(),
            world.of_floor
        )
    };
    Verdict {
        measured: world.of_floor.is_finite().then_some(world.of_floor),
        low: Some(0.0),
        high: Some(bound),
        ..ruled(case, ClaimName::Equivariant, world.name, verdict, detail)
    }
}
