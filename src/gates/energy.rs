//! The energy gate of a free body: the order in h of the secular rate, its sign, and the bounds that L allows; or no secular rate
//! at all.

use super::{at_most, ruled};
use crate::claim::EnergyOfFreeBody;
use crate::measure::drift::rate_order;
use crate::measure::{BELOW, Decision, Doubt};
use crate::record::{ClaimName, DriftClass, EnergyDrift, Evidence, Rule, Ruling, Verdict};

/// Name of the rate's order.
pub(super) const RATE: &str = "rotational-energy-rate";

pub(super) fn judge(evidence: &Evidence, claim: EnergyOfFreeBody) -> Vec<Verdict> {
    let Some(drift) = &evidence.drift else {
        let detail = "the body is not free of torque, does not turn, is too near the separatrix for many periods, or a run broke";
        return vec![ruled(evidence, ClaimName::Energy, "rotational-energy", Ruling::NotApplicable, detail)];
    };
    match claim {
        EnergyOfFreeBody::GrowsSecularly { rate_order } => {
            vec![judge_rate(evidence, drift, rate_order, true), judge_bound(evidence, drift)]
        }
        EnergyOfFreeBody::Secular { rate_order } => vec![judge_rate(evidence, drift, rate_order, false)],
        EnergyOfFreeBody::Bounded => {
            vec![judge_class(evidence, drift, &[DriftClass::Bounded, DriftClass::Exact])]
        }
        EnergyOfFreeBody::Constant => vec![judge_class(evidence, drift, &[DriftClass::Exact])],
        EnergyOfFreeBody::Falls => vec![judge_fall(evidence, drift)],
    }
}

/// With L exact the energy cannot pass L²/(2 I_min).
fn judge_bound(evidence: &Evidence, drift: &EnergyDrift) -> Verdict {
    let most = drift.rungs.iter().map(|r| r.of_largest).fold(0.0, f64::max);
    let rounding = drift.rungs.iter().map(|r| r.rounding).fold(0.0, f64::max);
    let detail = format!("largest E over L²/(2 I_min), the most that L allows: 1 {:+.2e}", most - 1.0);
    at_most(evidence, ClaimName::Energy, "rotational-energy-bound", most, 1.0 + rounding, detail)
}

/// Said of a drift in double-double.
fn arithmetic(drift: &EnergyDrift) -> &'static str {
    if drift.double_double { " in double-double" } else { "" }
}

/// One of the classes that the claim allows.
fn judge_class(evidence: &Evidence, drift: &EnergyDrift, allowed: &[DriftClass]) -> Verdict {
    let shown = &drift.rungs[drift.shown];
    let verdict = match drift.class {
        class if allowed.contains(&class) => Ruling::Pass,
        DriftClass::Undecided => Ruling::Inconclusive,
        _ => Ruling::Fail,
    };
    Verdict {
        measured: Some(shown.level),
        ..ruled(
            evidence,
            ClaimName::Energy,
            "rotational-energy-drift",
            verdict,
            format!(
                "{}: largest change {:.2e} of E, rate {:.2e} ± {:.1e} 1/s, at h = {:.3e} s{}",
                drift.class.word(),
                shown.level,
                shown.rate,
                shown.uncertainty,
                shown.step,
                arithmetic(drift)
            ),
        )
    }
}

/// Long runs of more than a tenth of a radian a step: they begin at a fifth, and steps fall by √2.
const COARSE: usize = 2;

/// No run gains energy, but for rounding.
fn judge_fall(evidence: &Evidence, drift: &EnergyDrift) -> Verdict {
    // Larger steps than a tenth of a radian are none of which the claim speaks.
    let small = &drift.rungs[COARSE.min(drift.rungs.len() - 1)..];
    let gain = small.iter().map(|rung| rung.gain / rung.rounding).fold(0.0, f64::max);
    let detail = format!("largest gain of E over the start, in roundings of the run: {gain:.2}; at most 10");
    at_most(evidence, ClaimName::Energy, "rotational-energy-gain", gain, BELOW.recip(), detail)
}

/// At least the claimed order in h, and its sign: the least over all bodies, as for an error.
fn judge_rate(evidence: &Evidence, drift: &EnergyDrift, claimed: u32, grows: bool) -> Verdict {
    let shown = &drift.rungs[drift.shown];
    let rate = format!("rate {:.3e} 1/s at h = {:.3e} s{}", shown.rate, shown.step, arithmetic(drift));
    let rule = |ruling, detail: String| ruled(evidence, ClaimName::Energy, RATE, ruling, detail);
    match (drift.class, rate_order(drift)) {
        (DriftClass::Exact, _) => {
            let detail = "exact: the energy changes by rounding only, so there is no rate to measure";
            rule(Ruling::NotApplicable, detail.to_owned())
        }
        (DriftClass::Growing, _) => rule(Ruling::Fail, format!("grows without bound; {rate}")),
        (DriftClass::Secular, Decision::Order(found)) => {
            let too_low = evidence.setting.generic && found.order > claimed;
            let wrong = found.order < claimed || too_low || (grows && shown.rate <= 0.0);
            let ruling = if wrong { Ruling::Fail } else { Ruling::Pass };
            let (low, high) = found.bounds();
            let detail = format!(
                "order {} of the rate in h, {claimed} claimed: slope {:.3}, r = {:.3}; {rate}",
                found.order, found.slope, found.r
            );
            Verdict { measured: Some(found.slope), low: Some(low), high: Some(high), ..rule(ruling, detail) }
        }
        (class, decision) => {
            let (of, why) = match decision {
                Decision::Undecided(Doubt::NotAsymptotic { order, least }) => {
                    let why = format!("r falls for no order (the least is {least:.2}, for order {order})");
                    (Rule::NotAsymptotic, why)
                }
                _ => (Rule::Rounding, "fewer than four rates are larger than their uncertainty".to_owned()),
            };
            let finest = &drift.rungs[drift.rungs.len() - 1];
            if finest.level >= 1.0 {
                let detail = format!(
                    "down to h = {:.1e} s the energy changes by as much as itself: the rate at small steps is not seen",
                    finest.step
                );
                return rule(Ruling::NotApplicable, detail);
            }
            let detail = format!(
                "{}: no order of the rate in h down to h = {:.1e} s, where it is {:.1e} ± {:.1e} 1/s: {why}",
                class.word(),
                finest.step,
                finest.rate,
                finest.uncertainty
            );
            rule(Ruling::Inconclusive, detail).by(of)
        }
    }
}
