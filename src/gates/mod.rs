//! Judgement: one file a gate, a pure function of what was measured, and the table of known deviations.
//!
//! `judge` matches on [`Claim`] exhaustively: a claim without a gate does not compile.

pub(crate) mod baseline;
mod budget;
mod deviations;
mod energy;
mod equivariant;
mod evaluations;
mod exact;
mod flip_times;
mod follows_tolerance;
pub(crate) mod judge;
mod on_record;
pub(crate) mod order;
mod reduction;
pub(crate) mod reference;
mod reversible;
mod rigid;
mod solves;
mod stability;
mod symplectic;
mod vertical_momentum;

use crate::claim::{Claim, Quantity, When};
use crate::record::{ClaimName, Evidence, Ruling, Setting, Verdict};
use crate::schemes::SOLVED_TO;

pub use baseline::{Baseline, Tolerance};
pub use judge::{judge, judge_all};
pub(crate) use reference::judge_reference;

/// What solves to [`SOLVED_TO`] leave by the end of a run, over the roundings of its steps, which a floor counts as √n.
fn left_by_solves(solves: u64, steps: u64) -> f64 {
    solves as f64 * SOLVED_TO / f64::EPSILON / (steps.max(1) as f64).sqrt()
}

/// Exit code of a gate: 1 where a claim failed or a run broke, 2 where nothing failed but something is
/// undecided or nothing was judged, 0 where all holds. Known deviations do not count.
pub fn exit_code(verdicts: &[Verdict]) -> u8 {
    let judged = |v: &Verdict| v.scheme != "reference" && v.verdict != Ruling::NotApplicable;
    let counted = |ruling| verdicts.iter().any(|v| v.verdict == ruling && v.known_deviation.is_none());
    if counted(Ruling::Fail) || counted(Ruling::Broken) {
        1
    } else if counted(Ruling::Inconclusive) || !verdicts.iter().any(judged) {
        2
    } else {
        0
    }
}

/// Whether a promise of exactness speaks about a scene.
fn applies(setting: &Setting, when: When) -> bool {
    match when {
        When::NoForce => setting.no_force,
        When::ConstantForce => setting.constant_force,
        When::NoTorque => setting.torque_free,
        When::SteadySpin => setting.steady_spin,
        When::SymmetricBody => setting.torque_free && setting.symmetric,
    }
}

/// Whether this quantity is promised to be exact in this scene. A body point is where both X_cm and the
/// orientation are.
fn promised_exact(evidence: &Evidence, quantity: Quantity) -> bool {
    if quantity == Quantity::BodyPoint {
        return promised_exact(evidence, Quantity::Position)
            && promised_exact(evidence, Quantity::Orientation);
    }
    evidence.claims.iter().any(|claim| match claim {
        Claim::Exact(exact, when) => *exact == quantity && applies(&evidence.setting, *when),
        _ => false,
    })
}

/// Units that n roundings of one quantity may leave: √n of them in the mean, four times that at most, and a few of the first and the last.
fn walk(steps: u64) -> f64 {
    8.0 + 4.0 * (steps as f64).sqrt()
}

/// How many times its rounding a difference is, for a message.
fn times(of_rounding: f64) -> String {
    if of_rounding < 1e4 { format!("{of_rounding:.2}") } else { format!("{of_rounding:.1e}") }
}

/// A verdict without numbers.
fn ruled(
    evidence: &Evidence,
    claim: ClaimName,
    quantity: &str,
    verdict: Ruling,
    detail: impl Into<String>,
) -> Verdict {
    Verdict {
        scene: evidence.scene.clone(),
        scheme: evidence.scheme.clone(),
        claim,
        quantity: quantity.to_owned(),
        verdict,
        rule: claim.word().into(),
        detail: detail.into(),
        ..Verdict::default()
    }
}

/// Passes where `measured` is at most `bound`; NaN never passes.
fn at_most(
    evidence: &Evidence,
    claim: ClaimName,
    quantity: &str,
    measured: f64,
    bound: f64,
    detail: String,
) -> Verdict {
    let verdict = if measured <= bound { Ruling::Pass } else { Ruling::Fail };
    Verdict {
        measured: measured.is_finite().then_some(measured),
        low: Some(0.0),
        high: Some(bound),
        ..ruled(evidence, claim, quantity, verdict, detail)
    }
}
