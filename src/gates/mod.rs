//! Judgement: one file a gate, a pure function of what was measured, and the table of known deviations.
//!
//! `judge` matches on [`Claim`] exhaustively: a claim without a gate does not compile.

mod deviations;
pub(crate) mod case;
pub(crate) mod control;
mod convergence;
mod energy;
mod equivariant;
mod evaluations;
mod exact;
mod excuses;
mod flip_times;
mod follows_tolerance;
pub(crate) mod judge;
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
use crate::model::System;
use crate::record::{ClaimName, Records, Ruling, Verdict};

pub(crate) use case::Case;
pub(crate) use control::{Control, ask_for_control, judge_orders};
pub(crate) use judge::{judge, refuse};
pub(crate) use order::rule;
pub(crate) use reference::judge_reference;

/// Error constants on record, by scene, scheme and quantity.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    rows: Vec<(String, String, String, f64)>,
}

impl Baseline {
    /// The constants of a records file.
    pub fn from_records(records: &Records) -> Baseline {
        let rows = records
            .orders
            .iter()
            .filter_map(|o| Some((o.scene.clone(), o.scheme.clone(), o.quantity.clone(), o.constant?)))
            .collect();
        Baseline { rows }
    }

    /// The constants of this version, for the built-in scenes.
    ///
    /// # Panics
    /// The file in the program is not a records file, which a test rules out.
    pub fn built_in() -> Baseline {
        let text = include_str!("../../references/constants.json");
        Baseline::from_records(
            &serde_json::from_str(text).expect("references/constants.json is a records file"),
        )
    }

    /// The constant of a quantity, in its unit over sᵖ.
    pub fn constant(&self, scene: &str, scheme: &str, quantity: &str) -> Option<f64> {
        self.rows.iter().find(|r| r.0 == scene && r.1 == scheme && r.2 == quantity).map(|r| r.3)
    }
}

/// What the iteration of an implicit equation may leave, relative.
const SOLVED_TO: f64 = 1e-12;

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

/// The order that is claimed for the scene.
fn order_here(case: &Case, order: u32) -> u32 {
    if case.system.torque_free() { case.card.order_without_torque() } else { order }
}

/// Whether a promise of exactness speaks about this scene.
fn applies(system: &System, when: When) -> bool {
    let (constant_force, no_force) = system.constant_force();
    match when {
        When::NoForce => no_force,
        When::ConstantForce => constant_force,
        When::NoTorque => system.torque_free(),
        When::SteadySpin => system.steady_spin(),
        When::SymmetricBody => system.torque_free() && system.body.symmetric(),
    }
}

/// Whether the card promises this quantity to be exact in this scene. A body point is where both X_cm and the
/// orientation are.
fn promised_exact(case: &Case, quantity: Quantity) -> bool {
    if quantity == Quantity::BodyPoint {
        return promised_exact(case, Quantity::Position) && promised_exact(case, Quantity::Orientation);
    }
    case.card.claims.iter().any(|claim| match claim {
        Claim::Exact(exact, when) => *exact == quantity && applies(case.system, *when),
        _ => false,
    })
}

/// Angle that rounding and reference leave open from which on a rotation is anyone's [rad].
const OPEN: f64 = 1e-3;

/// What rounding and reference leave open of the orientation over the run [rad], where that is too much to judge a rotation by:
/// a spin about the middle axis, for long enough, or chaos.
fn open_angle(case: &Case) -> Option<f64> {
    let finest = case.evidence.rungs.last()?;
    Some(finest.floors[Quantity::Orientation].max).filter(|floor| *floor > OPEN)
}

/// A verdict without numbers.
fn ruled(
    case: &Case,
    claim: ClaimName,
    quantity: &str,
    verdict: Ruling,
    detail: impl Into<String>,
) -> Verdict {
    Verdict {
        scene: case.scene.to_owned(),
        scheme: case.card.name.to_owned(),
        claim,
        quantity: quantity.to_owned(),
        verdict,
        detail: detail.into(),
        ..Verdict::default()
    }
}

/// The verdict on runs that broke, the finest too; undecided where that would have gone on in smaller steps.
fn broke(case: &Case, claim: ClaimName, quantity: &str, why: &str) -> Verdict {
    match case.evidence.goes_on_in {
        None => ruled(case, claim, quantity, Ruling::Broken, why),
        Some(step) => {
            let detail = format!("{why}; it goes on there in steps of {step:.1e} s: too large a step");
            ruled(case, claim, quantity, Ruling::Inconclusive, detail)
        }
    }
}

/// Passes where `measured` is at most `bound`; NaN never passes.
fn at_most(
    case: &Case,
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
        ..ruled(case, claim, quantity, verdict, detail)
    }
}
