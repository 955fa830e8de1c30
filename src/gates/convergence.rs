//! What the one rule for an order ([`crate::measure::Order`]) says of a program under test, quantity by quantity.
//!
//! - Its first state is the start of the scene, to the digits that it prints.
//! - Its runs converge to the truth. Runs that converge to one another and not to the truth fail, in every scene.
//! - The order is at least the claimed one in every scene, and exactly that in the generic ones. An order is the least over all problems: in
//!   one scene a higher one is a remark.

use super::{Case, ruled};
use crate::measure::{ByRule, Cause, Decision, Doubt, Order};
use crate::model::Quantity;
use crate::model::body::Shape;
use crate::record::{ClaimName, Ruling, Verdict};

pub(super) fn judge(case: &Case, by_rule: &ByRule) -> Vec<Verdict> {
    if let Some(why) = all_broke(case) {
        return vec![ruled(case, ClaimName::Order, "all", Ruling::Broken, why)];
    }
    let order = super::order_here(case, case.card.order());
    let judged = Quantity::ALL.into_iter().filter(|quantity| !does_not_turn(case, *quantity));
    let mut verdicts: Vec<Verdict> = judged
        .flat_map(|quantity| {
            let start = judge_start(case, quantity, by_rule.start[quantity], by_rule.allowed[quantity]);
            start.into_iter().chain(judge_decision(case, quantity, order, &by_rule.decisions[quantity]))
        })
        .collect();
    if by_rule.fails() {
        let words = by_rule.cause.map(Cause::words);
        let detail = words.map_or(
            "no hypothesis explains the run; a program that chooses its own steps ends at its own tolerance"
                .to_owned(),
            |words| format!("likeliest cause: {words}"),
        );
        verdicts.push(ruled(case, ClaimName::Converges, "cause", Ruling::NotApplicable, detail));
    }
    if case.card.order() == 0 && case.not_for_order.is_none() {
        let detail =
            "the program claims no order, so none was judged: --order P says which one to hold it to";
        verdicts.push(ruled(case, ClaimName::Order, "all", Ruling::Inconclusive, detail));
    }
    verdicts
}

/// Why no run came to its end, if none did.
fn all_broke(case: &Case) -> Option<String> {
    let broken = |rung: &crate::measure::Rung| rung.outcome.broken.as_ref().map(ToString::to_string);
    case.evidence.rungs.iter().map(broken).collect::<Option<Vec<_>>>()?.pop()
}

/// Rotation of a single point is no quantity.
fn does_not_turn(case: &Case, quantity: Quantity) -> bool {
    let rotational =
        matches!(quantity, Quantity::Orientation | Quantity::AngularVelocity | Quantity::AngularMomentum);
    rotational && case.system.body.shape == Shape::Point
}

/// A failure where the first state is not the start of the scene.
fn judge_start(case: &Case, quantity: Quantity, apart: f64, allowed: f64) -> Option<Verdict> {
    if apart <= allowed {
        return None;
    }
    let unit = quantity.unit();
    let detail = format!(
        "the first state is off by {apart:.3e} {unit} from the start of the scene; its digits allow {allowed:.1e} {unit}"
    );
    Some(Verdict {
        measured: Some(apart),
        low: Some(0.0),
        high: Some(allowed),
        ..ruled(case, ClaimName::Start, quantity.name(), Ruling::Fail, detail)
    })
}

fn judge_decision(case: &Case, quantity: Quantity, order: u32, decision: &Decision) -> Vec<Verdict> {
    let name = quantity.name();
    match decision {
        Decision::Elsewhere { error, apart, step, until } => {
            let unit = quantity.unit();
            let detail = format!(
                "the error stays at {error:.4} {unit} however small the step: another motion is solved (the two finest runs differ \
                 by {apart:.1e} {unit}, h = {step:.1e} s, up to t = {until} s)"
            );
            let verdict = ruled(case, ClaimName::Converges, name, Ruling::Fail, detail);
            vec![Verdict { measured: Some(*error), low: Some(0.0), ..verdict }]
        }
        Decision::Exact => {
            let detail = "every error is at its rounding: there is no order to measure";
            vec![ruled(case, ClaimName::Order, name, Ruling::NotApplicable, detail)]
        }
        Decision::Order(found) => {
            let converges = ruled(case, ClaimName::Converges, name, Ruling::Pass, words(found));
            std::iter::once(converges).chain(judge_order(case, name, order, found)).collect()
        }
        Decision::Undecided(doubt) => {
            let (ruling, words) = match case.not_for_order {
                Some(reason) => (Ruling::NotApplicable, format!("{reason}; {}", doubted(doubt))),
                None => (Ruling::Inconclusive, doubted(doubt)),
            };
            vec![ruled(case, ClaimName::Order, name, ruling, words)]
        }
    }
}

/// The order that is decided, against the claimed one; nothing where none is claimed.
fn judge_order(case: &Case, name: &str, order: u32, found: &Order) -> Option<Verdict> {
    if case.not_for_order.is_some() || case.card.order() == 0 {
        return None;
    }
    let (ruling, remark) = match found.order.cmp(&order) {
        std::cmp::Ordering::Equal => (Ruling::Pass, String::new()),
        std::cmp::Ordering::Less => (Ruling::Fail, format!("order was {order} by the claim: ")),
        std::cmp::Ordering::Greater if case.generic => (
            Ruling::Fail,
            format!("more than the claimed {order} in a generic scene: the claim is too low: "),
        ),
        std::cmp::Ordering::Greater => (Ruling::Pass, format!("easy scene, {order} claimed: ")),
    };
    let (low, high) = found.bounds();
    Some(Verdict {
        measured: Some(found.slope),
        low: Some(low),
        high: Some(high),
        ..ruled(case, ClaimName::Order, name, ruling, remark + &words(found))
    })
}

fn words(found: &Order) -> String {
    let Order { order, slope, r, rungs, step, until, .. } = found;
    format!(
        "order {order}: slope {slope:.3}, r = {r:.3} over {rungs} rungs down to h = {step:.1e} s, up to t = {until} s"
    )
}

/// Why nothing is decided, and what would decide it.
fn doubted(doubt: &Doubt) -> String {
    match doubt {
        Doubt::FewRuns { whole } => {
            format!(
                "{whole} runs of halved steps came to their end, and the rule needs four: smaller steps would decide it"
            )
        }
        Doubt::Rounding { clear } => {
            format!(
                "{clear} errors stand clear of rounding, and the rule needs four: larger steps would decide it"
            )
        }
        Doubt::NotAsymptotic { order, least } => format!(
            "r falls for no order (the least is {least:.2}, for order {order}): smaller steps would decide it"
        ),
    }
}
