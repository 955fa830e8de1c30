//! The energy gate of a free body: the order in h of the secular rate, its sign, and the bound L²/(2 I_min).

use super::{Case, at_most, ruled};
use crate::claim::EnergyOfFreeBody;
use crate::metrics::{BAND, Class, EnergyDrift};
use crate::record::{Ruling, Verdict};

pub(super) fn judge(case: &Case, claim: EnergyOfFreeBody) -> Vec<Verdict> {
    let EnergyOfFreeBody::GrowsSecularly { rate_order } = claim;
    let Some(drift) = case.drift else {
        let detail =
            "the body is not free of torque, does not turn, or is too near the separatrix for many periods";
        return vec![ruled(case, "energy", "rotational-energy", Ruling::NotApplicable, detail)];
    };
    let most = drift.rungs.iter().map(|r| r.of_largest).fold(0.0, f64::max);
    let rounding = drift.rungs.iter().map(|r| r.rounding).fold(0.0, f64::max);
    let detail = format!("largest E over L²/(2 I_min), the most that L allows: 1 {:+.2e}", most - 1.0);
    vec![
        judge_rate(case, drift, rate_order),
        at_most(case, "energy", "rotational-energy-bound", most, 1.0 + rounding, detail),
    ]
}

fn judge_rate(case: &Case, drift: &EnergyDrift, rate_order: u32) -> Verdict {
    let name = "rotational-energy-rate";
    let shown = &drift.rungs[drift.shown];
    let rate = format!("rate {:.3e} 1/s at h = {:.3e} s", shown.rate, shown.step);
    match (drift.class, drift.order) {
        (Class::Exact, _) => {
            let detail = "exact: the energy changes by rounding only, so there is no rate to measure";
            ruled(case, "energy", name, Ruling::NotApplicable, detail)
        }
        (Class::Secular, Some(fit)) => {
            let (bottom, top) = (f64::from(rate_order) - BAND, f64::from(rate_order) + BAND);
            let verdict = if shown.rate <= 0.0 || fit.slope < bottom || fit.slope > top {
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
                    "energy",
                    name,
                    verdict,
                    format!(
                        "order {:.3} [{:.3}, {:.3}] of the rate in h, band {bottom:.2} … {top:.2}; {rate}",
                        fit.slope, fit.low, fit.high
                    ),
                )
            }
        }
        (Class::Growing, _) => {
            ruled(case, "energy", name, Ruling::Fail, format!("grows without bound; {rate}"))
        }
        (class, _) => {
            let detail = format!("{}: no order of the rate in h can be read; {rate}", class.word());
            ruled(case, "energy", name, Ruling::Inconclusive, detail)
        }
    }
}
