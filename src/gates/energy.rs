//! The energy gate of a free body: the order in h of the secular rate, its sign, and the bounds that L allows; or no secular rate
//! at all.

use super::{Case, at_most, ruled};
use crate::claim::EnergyOfFreeBody;
use crate::measure::{BAND, EnergyDrift};
use crate::record::{ClaimName, DriftClass, Ruling, Verdict};

/// Name of the rate's order.
pub(super) const RATE: &str = "rotational-energy-rate";

pub(super) fn judge(case: &Case, claim: EnergyOfFreeBody) -> Vec<Verdict> {
    let Some(drift) = case.drift else {
        let detail = "the body is not free of torque, does not turn, is too near the separatrix for many periods, or a run broke";
        return vec![ruled(case, ClaimName::Energy, "rotational-energy", Ruling::NotApplicable, detail)];
    };
    match claim {
        EnergyOfFreeBody::GrowsSecularly { rate_order } => {
            vec![judge_rate(case, drift, rate_order, true), judge_bound(case, drift)]
        }
        EnergyOfFreeBody::Secular { rate_order } => vec![judge_rate(case, drift, rate_order, false)],
        EnergyOfFreeBody::Bounded => {
            vec![judge_class(case, drift, &[DriftClass::Bounded, DriftClass::Exact])]
        }
        EnergyOfFreeBody::Constant => vec![judge_class(case, drift, &[DriftClass::Exact])],
        EnergyOfFreeBody::Falls => vec![judge_fall(case, drift)],
    }
}

/// With L exact the energy cannot pass L²/(2 I_min).
fn judge_bound(case: &Case, drift: &EnergyDrift) -> Verdict {
    let most = drift.rungs.iter().map(|r| r.of_largest).fold(0.0, f64::max);
    let rounding = drift.rungs.iter().map(|r| r.rounding).fold(0.0, f64::max);
    let detail = format!("largest E over L²/(2 I_min), the most that L allows: 1 {:+.2e}", most - 1.0);
    at_most(case, ClaimName::Energy, "rotational-energy-bound", most, 1.0 + rounding, detail)
}

/// One of the classes that the claim allows.
fn judge_class(case: &Case, drift: &EnergyDrift, allowed: &[DriftClass]) -> Verdict {
    let shown = &drift.rungs[drift.shown];
    let verdict = match drift.class {
        class if allowed.contains(&class) => Ruling::Pass,
        DriftClass::Undecided => Ruling::Inconclusive,
        _ => Ruling::Fail,
    };
    Verdict {
        measured: Some(shown.level),
        ..ruled(
            case,
            ClaimName::Energy,
            "rotational-energy-drift",
            verdict,
            format!(
                "{}: largest change {:.2e} of E, rate {:.2e} ± {:.1e} 1/s, at h = {:.3e} s",
                drift.class.word(),
                shown.level,
                shown.rate,
                shown.uncertainty,
                shown.step
            ),
        )
    }
}

/// No run gains energy, but for rounding.
fn judge_fall(case: &Case, drift: &EnergyDrift) -> Verdict {
    let gain = drift.rungs.iter().map(|rung| rung.gain / rung.rounding).fold(0.0, f64::max);
    let detail = format!("largest gain of E over the start, in roundings of the run: {gain:.2}; at most 10");
    at_most(case, ClaimName::Energy, "rotational-energy-gain", gain, 10.0, detail)
}

fn judge_rate(case: &Case, drift: &EnergyDrift, rate_order: u32, grows: bool) -> Verdict {
    let name = RATE;
    let shown = &drift.rungs[drift.shown];
    let control = case.control.and_then(|control| control.shows(ClaimName::Energy, RATE));
    let rate = format!("rate {:.3e} 1/s at h = {:.3e} s", shown.rate, shown.step);
    match (drift.class, drift.order) {
        (DriftClass::Exact, _) => {
            let detail = "exact: the energy changes by rounding only, so there is no rate to measure";
            ruled(case, ClaimName::Energy, name, Ruling::NotApplicable, detail)
        }
        (DriftClass::Secular, Some(fit)) => {
            let (bottom, top) = (f64::from(rate_order) - BAND, f64::from(rate_order) + BAND);
            // Above the band the claimed term may be too small to be seen in this motion.
            let above = fit.low > top && !(grows && shown.rate <= 0.0);
            let excuse = control.filter(|_| above);
            let verdict = if excuse.is_some() {
                Ruling::Inconclusive
            } else if (grows && shown.rate <= 0.0) || fit.high < bottom || fit.low > top {
                Ruling::Fail
            } else if fit.low < bottom || fit.high > top {
                Ruling::Inconclusive
            } else {
                Ruling::Pass
            };
            Verdict {
                measured: Some(fit.slope),
                low: Some(fit.low),
                high: Some(fit.high),
                ..ruled(
                    case,
                    ClaimName::Energy,
                    name,
                    verdict,
                    format!(
                        "order {:.3} [{:.3}, {:.3}] of the rate in h, band {bottom:.2} … {top:.2}; {rate}{}",
                        fit.slope,
                        fit.low,
                        fit.high,
                        excuse.map(|scene| format!("; {scene} shows the claimed order")).unwrap_or_default()
                    ),
                )
            }
        }
        // A thin body may be stiffer than any step that long runs can afford.
        (DriftClass::Growing, _) => match control {
            None => {
                ruled(case, ClaimName::Energy, name, Ruling::Fail, format!("grows without bound; {rate}"))
            }
            Some(scene) => {
                let detail = format!("grows without bound; {rate}; {scene} shows the claimed order");
                ruled(case, ClaimName::Energy, name, Ruling::Inconclusive, detail)
            }
        },
        (class, _) => {
            let why = why_no_order(drift);
            let detail =
                format!("{}: no order of the rate in h can be read, since {why}; {rate}", class.word());
            ruled(case, ClaimName::Energy, name, Ruling::Inconclusive, detail)
        }
    }
}

/// What keeps the rates of a ladder from having an order.
fn why_no_order(drift: &EnergyDrift) -> String {
    let finest = &drift.rungs[drift.rungs.len() - 1];
    let floor = finest.rounding / (finest.step * finest.steps as f64);
    let at = format!("at h = {:.1e} s, the smallest step that the long runs can afford,", finest.step);
    if finest.rate.abs() <= 10.0 * floor {
        format!("{at} it is {:.1e} 1/s, and rounding alone leaves {floor:.1e}", finest.rate.abs())
    } else if finest.rate.abs() <= 3.0 * finest.uncertainty {
        format!("{at} it is {:.1e} ± {:.1e} 1/s: not told from zero", finest.rate, finest.uncertainty)
    } else {
        format!(
            "{at} it is {:.2e} ± {:.1e} 1/s, and too few rates before it are steady",
            finest.rate, finest.uncertainty
        )
    }
}
