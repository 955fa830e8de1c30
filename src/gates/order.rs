//! What the one rule for an order ([`crate::measure::Order`]) says, quantity by quantity. It is the same for schemes of the list, of other
//! crates and for programs under test.
//!
//! - The first state of a run is the start of the scene.
//! - The runs converge to the truth. Runs that converge to one another and not to the truth fail, in every scene.
//! - The order is at least the claimed one in every scene, and exactly that in the generic ones. An order is the least over all problems and
//!   quantities: a higher one is a remark.
//! - A run of an odd number of steps is what the others make of it.
//! - What is on record is compared by [`super::on_record`].

use super::{Baseline, SOLVED_TO, on_record, promised_exact, ruled};
use crate::claim::Claim;
use crate::measure::{
    Asked, BELOW, Decision, Doubt, GIANT_STEPS, HIGHEST, Order, Run, decide_either, start_allows,
};
use crate::model::Quantity;
use crate::record::{ClaimName, Evidence, Ladder, Rule, Ruling, Rung, Verdict, length};

/// Least fall of an error from one run to the next, over what its order explains, that is named: three orders more.
const NAMED: f64 = 8.0;
/// Most that an error between two runs differs from that of the coarser one, over the difference of the two.
const BETWEEN: f64 = 2.0;

pub(super) fn judge(evidence: &Evidence, baseline: &Baseline) -> Vec<Verdict> {
    if evidence.claims.iter().any(|claim| matches!(claim, Claim::FollowsTolerance(_))) {
        return all_broke(evidence).into_iter().collect();
    }
    if let Some(broke) = all_broke(evidence) {
        return vec![broke];
    }
    let judged = Quantity::ALL.into_iter().filter(|quantity| !does_not_turn(evidence, *quantity));
    let decide = |quantity| {
        let (decision, finer) = decide_either(evidence.ladders(), quantity);
        (quantity, decision, finer)
    };
    let decided: Vec<(Quantity, Decision, Option<&Ladder>)> = judged.map(decide).collect();
    let mut verdicts: Vec<Verdict> = Vec::new();
    for (quantity, decision, other) in &decided {
        verdicts.extend(judge_start(evidence, *quantity).filter(|_| evidence.program));
        // An order that is judged says whether the runs converge.
        let order = judge_order(evidence, *quantity, decision);
        let mut order = order.unwrap_or_else(|| judge_convergence(evidence, *quantity, decision));
        let order_fails = order.claim == ClaimName::Order && order.verdict == Ruling::Fail;
        if let Some(other) = other {
            let runs = if other.double_double { "in double-double" } else { "in runs that end there" };
            order.detail += &format!(", {runs}");
        }
        verdicts.push(order);
        // Both are of the runs in f64 over the whole motion, whose order others do not tell.
        let of_whole = if other.is_some() { None } else { Some(decision) };
        verdicts.extend(judge_jump(evidence, *quantity, of_whole));
        verdicts.extend(of_whole.and_then(|decision| judge_odd(evidence, *quantity, decision)));
        verdicts.extend(on_record::judge_quantity(evidence, *quantity, (decision, order_fails), baseline));
    }
    if let Some(reason) = &evidence.setting.not_for_order {
        verdicts.push(ruled(evidence, ClaimName::Order, "all", Ruling::NotApplicable, reason.as_str()));
    }
    let found =
        |decision: &Decision| if let Decision::Order(found) = decision { Some(found.order) } else { None };
    let orders = || decided.iter().filter_map(|(_, decision, _)| found(decision));
    verdicts.extend(judge_generic(evidence, orders().min()));
    verdicts.extend(evidence.ladder.cause.iter().map(|cause| {
        ruled(
            evidence,
            ClaimName::Converges,
            "cause",
            Ruling::NotApplicable,
            format!("likeliest cause: {cause}"),
        )
    }));
    if evidence.program && evidence.order() == 0 && evidence.setting.not_for_order.is_none() {
        let detail =
            "the program claims no order, so none was judged: --order P says which one to hold it to";
        let verdict = ruled(evidence, ClaimName::Order, "all", Ruling::Inconclusive, detail);
        verdicts.push(verdict.by(Rule::NoClaim));
    }
    verdicts
}

/// The verdict where no run came to its end, or the finest did not. An implicit equation that is not solved says that every step tried is too
/// large; the limit h → 0 is not seen.
fn all_broke(evidence: &Evidence) -> Option<Verdict> {
    let broken = |ruling, why: String| ruled(evidence, ClaimName::Run, "all", ruling, why);
    let Some(finest) = evidence.ladder.rungs.last() else {
        return Some(broken(Ruling::Broken, "no run".to_owned()));
    };
    let why = finest.broken.as_deref()?;
    let detail = format!("{why}, at the finest step of {:.1e} s", finest.step);
    Some(if finest.unsolved {
        broken(Ruling::Inconclusive, format!("{detail}: a smaller step would decide it")).by(Rule::NotSolved)
    } else {
        broken(Ruling::Broken, detail)
    })
}

/// Rotation of a single point is no quantity.
fn does_not_turn(evidence: &Evidence, quantity: Quantity) -> bool {
    let rotational =
        matches!(quantity, Quantity::Orientation | Quantity::AngularVelocity | Quantity::AngularMomentum);
    rotational && evidence.setting.point
}

/// A failure where the first state is not the start of the scene.
fn judge_start(evidence: &Evidence, quantity: Quantity) -> Option<Verdict> {
    let ladder = &evidence.ladder;
    let apart = ladder.start[quantity];
    let allowed = start_allows(ladder, quantity);
    if apart <= allowed {
        return None;
    }
    let unit = quantity.unit();
    let detail = format!(
        "the first state is off by {apart:.3e} {unit} from the start of the scene; its digits allow {allowed:.1e} {unit}"
    );
    let verdict = ruled(evidence, ClaimName::Start, quantity.name(), Ruling::Fail, detail);
    Some(Verdict { measured: Some(apart), low: Some(0.0), high: Some(allowed), ..verdict })
}

/// Whether the runs converge to the truth.
fn judge_convergence(evidence: &Evidence, quantity: Quantity, decision: &Decision) -> Verdict {
    let rule = |ruling, detail| ruled(evidence, ClaimName::Converges, quantity.name(), ruling, detail);
    match decision {
        Decision::Order(found) => rule(Ruling::Pass, words(found)),
        Decision::Exact => {
            rule(Ruling::Pass, "every error is at its rounding".to_owned()).by(Rule::AtRounding)
        }
        Decision::Undecided(doubt) => rule(Ruling::NotApplicable, doubted(doubt)).by(rule_of(doubt)),
        Decision::Elsewhere { error, .. } if is_of_a_kink(evidence, quantity) => {
            let unit = quantity.unit();
            let detail = format!(
                "the error stays at {error:.1e} {unit} and is another one where the steps meet the kinks of a force elsewhere"
            );
            rule(Ruling::NotApplicable, detail).by(Rule::Kink)
        }
        Decision::Elsewhere { error, apart, step, until } => {
            let unit = quantity.unit();
            let another = evidence.claims.contains(&Claim::SolvesAnotherMotion);
            let ruling = if another { Ruling::Pass } else { Ruling::Fail };
            let detail = format!(
                "the error stays at {error:.4} {unit} however small the step: another motion is solved (the two finest runs differ \
                 by {apart:.1e} {unit}, h = {step:.1e} s, up to t = {until} s)"
            );
            Verdict { measured: Some(*error), low: Some(0.0), ..rule(ruling, detail).by(Rule::Elsewhere) }
        }
    }
}

/// Whether a force has kinks and a run whose steps meet them elsewhere has another error at the end: runs of halved steps may all meet a kink at
/// one distance from the end of a step, and then have one error.
fn is_of_a_kink(evidence: &Evidence, quantity: Quantity) -> bool {
    let ladder = &evidence.ladder;
    let [.., coarser, finest] = &ladder.rungs[..] else { return false };
    let at_end = finest.error(quantity, &ladder.arms);
    let another = |odd: &Rung| {
        let of_odd = odd.error(quantity, &ladder.arms);
        let at_end = &at_end[at_end.len().saturating_sub(of_odd.len())..];
        let apart: Vec<f64> = of_odd.iter().zip(at_end).map(|(odd, finest)| odd - finest).collect();
        length(&apart) > BELOW * length(at_end)
    };
    let mut between = ladder.odd.iter().filter(|odd| coarser.steps < odd.steps && odd.steps < finest.steps);
    evidence.setting.not_for_order.is_some() && between.any(another)
}

/// A fall of an error from one run to the next that the order does not explain: named above [`NAMED`], and a failure where the error vanishes
/// into its rounding from more than the highest order makes of a halving. An error of the size of the motion falls as it likes, and so does one
/// of a kink, which a step that ends at it does not make.
fn judge_jump(evidence: &Evidence, quantity: Quantity, decision: Option<&Decision>) -> Option<Verdict> {
    let order = if let Some(Decision::Order(found)) = decision { found.order } else { HIGHEST };
    let asked = Asked::of(&evidence.ladder, quantity);
    let samples = asked.times.len();
    let fall = |pair: &[Run]| {
        let (coarse, fine) = (length(&pair[0].errors), length(&pair[1].errors));
        let whole = !pair[0].errors.is_empty() && !pair[1].errors.is_empty();
        let small = coarse < BELOW * asked.scale * (samples as f64).sqrt();
        // A step that is unstable amplifies roundings, which smaller steps do not.
        let clear = coarse > asked.floor(&pair[0], samples);
        let floor = asked.floor(&pair[1], samples);
        let vanishes = fine <= floor && coarse > 2f64.powi(HIGHEST as i32) * floor;
        let fall = coarse / fine.max(floor) / (pair[0].step / pair[1].step).powi(order as i32);
        (whole && small && clear && fall > NAMED).then_some((vanishes, fall, pair[0].step))
    };
    let falls = asked.runs.windows(2).filter_map(fall);
    let (vanishes, fall, step) = falls.max_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)))?;
    let smooth = evidence.setting.not_for_order.is_none();
    let ruling = if vanishes && smooth { Ruling::Fail } else { Ruling::NotApplicable };
    let over = if order == HIGHEST { "the highest order".to_owned() } else { format!("order {order}") };
    let detail = format!(
        "from h = {step:.2e} s to the next run the error falls {fall:.0} times as much as {over} explains"
    );
    Some(Verdict {
        measured: fall.is_finite().then_some(fall),
        ..ruled(evidence, ClaimName::Converges, quantity.name(), ruling, detail).by(Rule::Jump)
    })
}

/// Whether the order is at least the claimed one; `None` without a claim, or where the quantity is promised to be exact.
fn judge_order(evidence: &Evidence, quantity: Quantity, decision: &Decision) -> Option<Verdict> {
    let claimed = evidence.order();
    let smooth = evidence.setting.not_for_order.is_none();
    if claimed == 0 || !smooth || promised_exact(evidence, quantity) {
        return None;
    }
    let rule = |ruling, detail| ruled(evidence, ClaimName::Order, quantity.name(), ruling, detail);
    match decision {
        Decision::Elsewhere { .. } => None,
        Decision::Exact => {
            let detail = "every error is at its rounding: there is no order to measure".to_owned();
            Some(rule(Ruling::NotApplicable, detail).by(Rule::AtRounding))
        }
        Decision::Undecided(doubt) => Some(rule(Ruling::Inconclusive, doubted(doubt)).by(rule_of(doubt))),
        Decision::Order(found) => {
            let (ruling, remark) = match found.order.cmp(&claimed) {
                std::cmp::Ordering::Less => (Ruling::Fail, format!("{claimed} claimed: ")),
                std::cmp::Ordering::Equal => (Ruling::Pass, String::new()),
                std::cmp::Ordering::Greater => (Ruling::Pass, format!("easy scene, {claimed} claimed: ")),
            };
            let (low, high) = found.bounds();
            let verdict = rule(ruling, remark + &words(found));
            Some(Verdict { measured: Some(found.slope), low: Some(low), high: Some(high), ..verdict })
        }
    }
}

/// In a generic scene one quantity at least has exactly the claimed order.
fn judge_generic(evidence: &Evidence, least: Option<u32>) -> Option<Verdict> {
    let claimed = evidence.order();
    let least = least.filter(|least| evidence.setting.generic && claimed > 0 && *least > claimed)?;
    let detail = format!(
        "order {least} in every quantity of a generic scene, {claimed} claimed: the claim is too low"
    );
    let verdict = ruled(evidence, ClaimName::Order, "all", Ruling::Fail, detail).by(Rule::Generic);
    Some(Verdict { measured: Some(f64::from(least)), high: Some(f64::from(claimed)), ..verdict })
}

/// Runs of an odd number of steps at the end: at their rounding where the others are, and otherwise between the coarser and the finer run.
/// Where the motion has kinks, between any two successive runs. `None` where that holds.
fn judge_odd(evidence: &Evidence, quantity: Quantity, decision: &Decision) -> Option<Verdict> {
    let ladder = &evidence.ladder;
    let asked = Asked::of(ladder, quantity);
    let smooth = evidence.setting.not_for_order.is_none();
    let whole = match decision {
        Decision::Exact => true,
        Decision::Order(found) => found.until >= asked.times[asked.times.len() - 1],
        _ => false,
    };
    let off = |odd: &Run| {
        if *decision == Decision::Exact {
            return Some(length(&odd.errors));
        }
        let finer = asked.runs.iter().position(|run| run.step < odd.step).filter(|index| *index > 0)?;
        let apart = |a: &[f64], b: &[f64]| length(&a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>());
        // Over the run: at the end alone two errors may be alike by chance.
        let jump = |finer: usize| apart(&asked.runs[finer - 1].errors, &asked.runs[finer].errors);
        let coarse = &asked.runs[finer - 1].errors;
        let from_coarse = apart(&odd.errors, coarse.get(coarse.len().checked_sub(odd.errors.len())?..)?);
        // The step of which a run meets a kink decides its error: any jump between two runs may come again.
        let jumps = if smooth { finer..finer + 1 } else { 1..asked.runs.len() };
        let explained = jumps.map(jump).fold(0.0, f64::max);
        (from_coarse > BETWEEN * explained).then_some(from_coarse)
    };
    let wrong = |rung: &&Rung| {
        let odd = Run::of(rung, quantity, &ladder.arms);
        // A composition rounds the state in each of its parts, of which an evaluation is one; the parts of a step are many.
        let of_parts = f64::EPSILON * rung.evaluations as f64 * asked.scale;
        let of_solves = rung.solves as f64 * SOLVED_TO * asked.scale;
        // The others are within what is known of the truth over all sample times, of which one may be off by more.
        let known = asked.known() * (asked.times.len() as f64).sqrt();
        let floor = asked.floor(&odd, 1).max(known).max(of_parts).max(of_solves);
        // Giant steps are asked of what is promised to be exact alone.
        let asked_for = !GIANT_STEPS.contains(&rung.steps) || promised_exact(evidence, quantity);
        whole && asked_for && rung.broken.is_none() && floor <= BELOW * asked.scale && off(&odd) > Some(floor)
    };
    let rung = ladder.odd.iter().find(wrong)?;
    let error = length(&rung.error(quantity, &ladder.arms));
    let unit = quantity.unit();
    let detail = format!(
        "in {} steps, an odd number, the error at the end is {error:.2e} {unit}, which the runs of even numbers do not explain",
        rung.steps
    );
    let verdict = ruled(evidence, ClaimName::Converges, quantity.name(), Ruling::Fail, detail).by(Rule::Odd);
    Some(Verdict { measured: Some(error), ..verdict })
}

fn words(found: &Order) -> String {
    let Order { order, slope, r, rungs, step, until, .. } = found;
    format!(
        "order {order}: slope {slope:.3}, r = {r:.3} over {rungs} rungs down to h = {step:.1e} s, up to t = {until} s"
    )
}

/// The rule that leaves a quantity undecided.
pub(super) fn rule_of(doubt: &Doubt) -> Rule {
    match doubt {
        Doubt::FewRuns { .. } => Rule::FewRuns,
        Doubt::Rounding { .. } => Rule::Rounding,
        Doubt::NotAsymptotic { .. } => Rule::NotAsymptotic,
        Doubt::Open { .. } => Rule::Open,
    }
}

/// Why nothing is decided, and what would decide it.
pub(super) fn doubted(doubt: &Doubt) -> String {
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
        Doubt::Open { rounding } => format!(
            "rounding leaves {:.0} % of the quantity open: a shorter run would decide it",
            100.0 * rounding
        ),
    }
}
