//! One scheme in one scene: everything that is measured, then judged, as rows.

use super::{Controls, rows};
use crate::claim::Claim;
use crate::gates::{self, Baseline, Case};
use crate::measure::{self, EnergyDrift, Evidence};
use crate::record::stability::LinearLimit;
#[cfg(feature = "cli")]
use crate::record::stability::Stability;
use crate::record::{Drift, Measurement, Order, Series, Verdict};
use crate::reference::Reference;
use crate::rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form, Plan};
#[cfg(feature = "cli")]
use crate::study::stability::{self, Bench};

/// States of a series.
const SERIES_SAMPLES: u64 = 512;
/// Rung of the ladder, from the coarsest, whose run is drawn against time.
const SERIES_RUNG: usize = 2;

/// The rows of a cell.
pub(super) struct Cell {
    pub(super) measurements: Vec<Measurement>,
    pub(super) orders: Vec<Order>,
    pub(super) drifts: Vec<Drift>,
    pub(super) verdicts: Vec<Verdict>,
    pub(super) series: Vec<Series>,
    /// Difference from the point form.
    pub(super) reduction: Option<f64>,
}

/// Measures and judges. `controls` tell what another order than the claimed one means.
pub(super) fn measure(
    scene: &Scene,
    reference: &Reference,
    contestant: &Contestant,
    baseline: &Baseline,
    series: bool,
    controls: &Controls,
) -> Cell {
    let system = &scene.system;
    if let Some(reason) = contestant.refusal(system) {
        return refused(scene, contestant, &reason);
    }
    let fastest = fastest(reference);
    let evidence = ladder(scene, reference, contestant);
    if let Some(reason) = evidence.refusal() {
        return refused(scene, contestant, reason);
    }
    let drift = measure::energy_drift(contestant, system, scene.duration);
    let points = measure::point_run(contestant, system, scene.duration, fastest);
    let asked = contestant.card.claims.contains(&Claim::FlipTimes);
    let flips = asked
        .then(|| measure::true_flips(system, reference, fastest))
        .flatten()
        .and_then(|truth| measure::flips(contestant, system, scene.duration, fastest, truth));
    let claims = |claim: Claim| contestant.card.claims.contains(&claim);
    let reversal =
        claims(Claim::Reversible).then(|| measure::reversal(contestant, system, &evidence.rungs)).flatten();
    let symplecticity = claims(Claim::Symplectic)
        .then(|| measure::symplecticity(contestant, system, &evidence.rungs))
        .flatten();
    let other_worlds = if claims(Claim::Equivariant) {
        measure::other_worlds(contestant, system, &evidence.rungs)
    } else {
        Vec::new()
    };
    let step_limit = step_limit(scene, contestant);
    let case = Case {
        not_for_order: scene.not_for_order.as_deref(),
        drift: drift.as_ref(),
        points: points.as_ref(),
        flips: flips.as_ref(),
        reversal: reversal.as_ref(),
        symplecticity: symplecticity.as_ref(),
        other_worlds: &other_worlds,
        generic: super::controls::is_generic(scene),
        step_limit: step_limit.as_ref().map(|(stored, measured)| (*stored, measured)),
        ..Case::of(&scene.name, system, &contestant.card, &evidence, baseline)
    };
    let mut verdicts = gates::judge(&case);
    if gates::ask_for_control(&verdicts) {
        let control = controls.of(contestant, system.torque_free());
        verdicts = gates::judge(&Case { control: Some(&control), ..case });
    }
    let names = rows::Names { scene: &scene.name, scheme: contestant.card.name, model: evidence.model };
    let mut measurements = rows::measurements(&names, &evidence, contestant.has_own_clock());
    measurements.extend(drift.iter().flat_map(|drift| rows::drift_rates(&names, drift)));
    Cell {
        measurements,
        orders: rows::orders(&names, &evidence),
        drifts: drifts(&names, drift.as_ref()),
        verdicts,
        series: if series { against_time(&names, scene, contestant, &evidence) } else { Vec::new() },
        reduction: points.as_ref().map(|points| points.difference),
    }
}

/// The limit of stability on record for the scheme in the scene, and as it is now.
#[cfg(feature = "cli")]
fn step_limit(scene: &Scene, contestant: &Contestant) -> Option<(&'static LinearLimit, LinearLimit)> {
    let stored =
        Stability::built_in().linear(&scene.name, contestant.card.name).filter(|_| scene.built_in)?;
    let measured = stability::linear_limit_in(&scene.name, &Bench::of(&scene.system)?, contestant)?;
    Some((stored, measured))
}

/// Limits of stability are measured with the feature `cli`.
#[cfg(not(feature = "cli"))]
fn step_limit(_: &Scene, _: &Contestant) -> Option<(&'static LinearLimit, LinearLimit)> {
    None
}

/// The ladder of the order that the scheme claims in the scene.
fn ladder(scene: &Scene, reference: &Reference, contestant: &Contestant) -> Evidence {
    let (system, card) = (&scene.system, &contestant.card);
    let order = if system.torque_free() { card.order_without_torque() } else { card.order() };
    measure::climb(contestant, system, reference, order, scene.not_for_order.is_none())
}

/// The verdicts that a control is asked for: on orders, of errors and of the energy's rate.
pub(super) fn orders_alone(scene: &Scene, reference: &Reference, contestant: &Contestant) -> Vec<Verdict> {
    let evidence = ladder(scene, reference, contestant);
    let drift = measure::energy_drift(contestant, &scene.system, scene.duration);
    let baseline = Baseline::default();
    let of_ladder = Case::of(&scene.name, &scene.system, &contestant.card, &evidence, &baseline);
    gates::judge_orders(&Case { drift: drift.as_ref(), ..of_ladder })
}

/// A scheme that cannot take the scene: not applicable, with the reason, for every claim.
pub(super) fn refused(scene: &Scene, contestant: &Contestant, reason: &str) -> Cell {
    let names = rows::Names {
        scene: &scene.name,
        scheme: contestant.card.name,
        model: contestant.model(&scene.system),
    };
    Cell {
        measurements: vec![rows::not_applicable(&names, reason)],
        orders: Vec::new(),
        drifts: Vec::new(),
        verdicts: gates::refuse(&scene.name, &contestant.card, reason),
        series: Vec::new(),
        reduction: None,
    }
}

/// Largest |Ω| of the reference [rad/s].
fn fastest(reference: &Reference) -> f64 {
    reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max)
}

fn drifts(names: &rows::Names, drift: Option<&EnergyDrift>) -> Vec<Drift> {
    drift.map(|drift| rows::drift(names, drift)).into_iter().collect()
}

/// Energy and angular momentum against time, at a step that a user might take.
fn against_time(
    names: &rows::Names,
    scene: &Scene,
    contestant: &Contestant,
    evidence: &Evidence,
) -> Vec<Series> {
    let Some(rung) = evidence.rungs.get(SERIES_RUNG) else { return Vec::new() };
    let plan = Plan::over(scene.duration, rung.steps, SERIES_SAMPLES.min(rung.steps));
    let run = contestant.run(&scene.system, Form::Least, &plan);
    rows::series(names, &scene.system, plan.step, &run.states)
}
