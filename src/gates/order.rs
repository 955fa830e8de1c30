//! The order gate: the 95 % interval of the fitted slope inside p ± 0.15, and the error constant within 5 % of the
//! one on record.

use super::{Case, broke, excuses, promised_exact, ruled};
use crate::measure::regression::{Fit, Ladder};
use crate::measure::{APART, BAND, QuantityLadder};
use crate::model::Quantity;
use crate::model::body::Shape;
use crate::record::{ClaimName, Ruling, Verdict};

/// Largest relative change of an error constant.
const CONSTANT_CHANGE: f64 = 0.05;
/// Error over its floor that cannot have been overlooked.
const LARGE: f64 = 1e3;

pub(super) fn judge(case: &Case, order: u32) -> Vec<Verdict> {
    if let Some(reason) = case.not_for_order {
        let order = ruled(case, ClaimName::Order, "all", Ruling::NotApplicable, reason);
        return std::iter::once(order).chain(judge_consistency(case)).collect();
    }
    let judged = judged_ladders(case);
    let name = |ladder: &QuantityLadder| format!("{}-{}", ladder.quantity.name(), ladder.place.suffix());
    let mut slopes: Vec<Verdict> =
        judged.iter().map(|ladder| judge_slope(case, order, ladder, &name(ladder))).collect();
    excuses::apply(case, order, &judged, &mut slopes);
    let with_constant = |(slope, ladder): (Verdict, &&QuantityLadder)| {
        std::iter::once(slope).chain(judge_constant(case, ladder, &name(ladder)))
    };
    slopes.into_iter().zip(&judged).flat_map(with_constant).collect()
}

/// Those of quantities that are not promised to be exact.
fn judged_ladders<'a>(case: &'a Case) -> Vec<&'a QuantityLadder> {
    let judged = |ladder: &&QuantityLadder| {
        !promised_exact(case, ladder.quantity) && !does_not_turn(case, ladder.quantity)
    };
    case.evidence.ladders.iter().filter(judged).collect()
}

/// Where no order applies, a scheme must at least not converge to another motion. At order p and halved steps two runs differ by
/// 2ᵖ − 1 times the error of the finer one, half of that at least where the ratio of steps is less. Runs that twice agree with one
/// another ten times better than with the truth, and the second time better than the first, have come to something else; once may
/// be two errors that happen to be alike.
fn judge_consistency(case: &Case) -> Option<Verdict> {
    let point = Quantity::BodyPoint;
    let mut sound = case.evidence.rungs.iter().rev().filter(|rung| rung.outcome.broken.is_none());
    let (last, before) = (sound.next()?, sound.next());
    let (error, floor, moved) = (last.errors[point].max, last.floors[point].max, last.moved[point].max);
    let moved_before = before.map_or(f64::NAN, |rung| rung.moved[point].max);
    let apart = |moved: f64, error: f64| moved / error;
    let ratio_before = before.map_or(f64::NAN, |rung| apart(moved_before, rung.errors[point].max));
    let at_floor = error <= 10.0 * floor;
    let ratio = if at_floor { 1.0 } else { apart(moved, error) };
    let (verdict, words) = if at_floor {
        (Ruling::Pass, "the error is at its floor")
    } else if ratio >= APART {
        (Ruling::Pass, "runs differ from one another as much as from the truth")
    } else if ratio.max(ratio_before) < APART / 2.0 && moved < moved_before {
        (Ruling::Fail, "runs agree with one another and not with the truth")
    } else if ratio.is_nan() {
        (Ruling::Inconclusive, "there is no run before it to compare with")
    } else {
        (Ruling::Inconclusive, "runs differ from one another less than from the truth")
    };
    let detail = format!(
        "{words}: moved {moved:.2e} m from the run before, error {error:.2e} m at h = {:.3e} s",
        last.step
    );
    Some(Verdict {
        measured: ratio.is_finite().then_some(ratio),
        low: Some(APART),
        ..ruled(case, ClaimName::Consistency, "body-point-max", verdict, detail)
    })
}

/// Rotation of a single point is no quantity.
fn does_not_turn(case: &Case, quantity: Quantity) -> bool {
    let rotational =
        matches!(quantity, Quantity::Orientation | Quantity::AngularVelocity | Quantity::AngularMomentum);
    rotational && case.system.body.shape == Shape::Point
}

fn judge_slope(case: &Case, order: u32, ladder: &QuantityLadder, name: &str) -> Verdict {
    let (verdict, detail) = match &ladder.ladder {
        Ladder::Broken => return judge_broken(case, ladder, name),
        _ => rule(ladder, order),
    };
    let fit = ladder.fit();
    Verdict {
        measured: fit.map(|fit| fit.slope),
        low: fit.map(|fit| fit.low),
        high: fit.map(|fit| fit.high),
        ..ruled(case, ClaimName::Order, name, verdict, detail)
    }
}

/// No finite error: the run broke, or shows what is no number; or the run is whole, one step differs from the next by a number, and it
/// is the reference that has none.
fn judge_broken(case: &Case, ladder: &QuantityLadder, name: &str) -> Verdict {
    let last = case.evidence.rungs.last();
    if let Some(why) = last.and_then(|last| last.outcome.broken.as_ref()) {
        return broke(case, ClaimName::Order, name, &why.to_string());
    }
    let moved = last.map(|last| ladder.place.of(&last.moved[ladder.quantity]));
    if moved.is_some_and(f64::is_finite) {
        let detail = "the reference is not finite: there is nothing to compare with";
        return ruled(case, ClaimName::Order, name, Ruling::Inconclusive, detail);
    }
    ruled(
        case,
        ClaimName::Order,
        name,
        Ruling::Broken,
        if last.is_some() { "no finite error" } else { "no run" },
    )
}

/// What a ladder says of a claimed order, and why, by nothing but its numbers.
pub fn rule(ladder: &QuantityLadder, order: u32) -> (Ruling, String) {
    match &ladder.ladder {
        Ladder::Window { fit, rungs } => rule_on_fit(ladder, order, fit, rungs.len()),
        Ladder::Exact => (
            Ruling::NotApplicable,
            "exact: every rung of the ladder is at the floor of rounding and reference, so there is no order to measure"
                .to_owned(),
        ),
        Ladder::TooFew { clear } => (
            Ruling::Inconclusive,
            format!(
                "only {clear} of {} rungs stand 10 times clear of the floor of rounding and reference ({:.2e} {}); a slope needs 4",
                ladder.rungs.len(),
                ladder.rungs.last().map_or(f64::NAN, |rung| rung.2),
                ladder.quantity.unit(),
            ),
        ),
        Ladder::Unsettled => (
            Ruling::Inconclusive,
            format!(
                "no three successive slopes agree to 0.15 down to h = {:.3e} s: not asymptotic",
                ladder.rungs.last().map_or(f64::NAN, |rung| rung.0)
            ),
        ),
        Ladder::Broken => (Ruling::Broken, "no finite error at the finest step".to_owned()),
    }
}

fn rule_on_fit(ladder: &QuantityLadder, order: u32, fit: &Fit, rungs: usize) -> (Ruling, String) {
    let (bottom, top) = (f64::from(order) - BAND, f64::from(order) + BAND);
    let outside = fit.low > top || fit.high < bottom;
    let (verdict, reason) = if ladder.holds(order) {
        (Ruling::Pass, "inside")
    } else if outside && ladder.is_on_its_way(order) {
        (Ruling::Inconclusive, "a term of the claimed order is there, still under the next one:")
    } else if fit.low > top {
        (Ruling::Fail, "above the band (too easy a scene, or mis-declared):")
    } else if fit.high < bottom {
        (Ruling::Fail, "below the band:")
    } else {
        (Ruling::Inconclusive, "the interval reaches across an end of the band:")
    };
    let detail = format!(
        "slope {:.3} [{:.3}, {:.3}] over {rungs} rungs, {reason} {bottom:.2} … {top:.2}",
        fit.slope, fit.low, fit.high
    );
    (verdict, detail)
}

/// A constant on record and none measured: undecided, but where an error is below its floor that the record makes a thousand times
/// larger.
fn judge_without_constant(case: &Case, ladder: &QuantityLadder, known: f64, name: &str) -> Verdict {
    let detail = format!("constant {known:.4e} on record, none measured");
    let expected = |rung: &(f64, f64, f64)| known * rung.0.powi(order_of(case) as i32);
    let vanished = ladder.rungs.iter().any(|rung| expected(rung) > LARGE * rung.2 && rung.1 <= rung.2);
    if !vanished {
        return ruled(case, ClaimName::Constant, name, Ruling::Inconclusive, detail);
    }
    ruled(case, ClaimName::Constant, name, Ruling::Fail, format!("{detail}: an error is below its floor"))
}

/// The order that the constants on record belong to.
fn order_of(case: &Case) -> u32 {
    super::order_here(case, case.card.order())
}

fn judge_constant(case: &Case, ladder: &QuantityLadder, name: &str) -> Option<Verdict> {
    let known = case.baseline.constant(case.scene, case.card.name, name)?;
    let Some(constant) = ladder.constant else {
        return Some(judge_without_constant(case, ladder, known, name));
    };
    let holds = (constant / known - 1.0).abs() <= CONSTANT_CHANGE;
    let verdict = if holds { Ruling::Pass } else { Ruling::Fail };
    Some(Verdict {
        measured: Some(constant),
        low: Some(known * (1.0 - CONSTANT_CHANGE)),
        high: Some(known * (1.0 + CONSTANT_CHANGE)),
        ..ruled(
            case,
            ClaimName::Constant,
            name,
            verdict,
            format!("C = {constant:.4e}, on record {known:.4e} ± 5 %: ratio {:.4}", constant / known),
        )
    })
}
