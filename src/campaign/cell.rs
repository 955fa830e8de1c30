//! One scheme in one scene: everything that is measured, then judged, as rows.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::{against_time, rows};
use crate::claim::Claim;
use crate::measure::{self, Bounds, Climbed, Decision, Rung};
use crate::model::Quantity;
use crate::model::body::Shape;
use crate::record::stability::LinearLimit;
use crate::record::{Drift, Evidence, LeftOut, Measurement, Order, Series, Setting, Verdict};
use crate::reference::Reference;
use crate::rotation;
use crate::scenes::Scene;
use crate::simulate::{Contestant, Form, Plan};
use crate::study::cause;
#[cfg(feature = "cli")]
use crate::study::stability::{self, Bench};

/// Scenes of three moments and a spin off every axis, without torque and with one of each kind: an order is exactly the claimed one here.
const GENERIC: [&str; 8] = [
    "free-asymmetric",
    "heavy-asymmetric-top",
    "tether-springs",
    "gyrostat",
    "damped-tumble",
    "magnetic-satellite",
    "satellite-circular-orbit",
    "thruster-pulse",
];
/// States of a series.
const SERIES_SAMPLES: u64 = 128;
/// Steps of the run that is drawn against time, at least.
const SERIES_STEPS: u64 = 256;

/// The rows of a cell.
#[derive(Clone, Serialize, Deserialize)]
pub(super) struct Cell {
    pub(super) measurements: Vec<Measurement>,
    pub(super) orders: Vec<Order>,
    pub(super) drifts: Vec<Drift>,
    pub(super) evidence: Arc<Evidence>,
    /// Judged when the row is whole.
    #[serde(skip)]
    pub(super) verdicts: Vec<Verdict>,
    pub(super) series: Vec<Series>,
}

/// Measures; nothing is judged yet.
pub(super) fn measure(
    scene: &Scene,
    reference: &Reference,
    contestant: &Contestant,
    bounds: Bounds,
    series: bool,
) -> Cell {
    if let Some(reason) = contestant.refusal(&scene.system) {
        return refused(scene, contestant, &reason);
    }
    if bounds.afforded == Some(0) {
        return unaffordable(scene, contestant);
    }
    let climbed = climb(scene, reference, contestant, bounds);
    if let Some(reason) = climbed.refusal() {
        return refused(scene, contestant, reason);
    }
    let evidence = evidence(scene, reference, contestant, (&climbed, bounds));
    let names = rows::Names { scene: &scene.name, scheme: contestant.card.name, model: climbed.model };
    let mut measurements = rows::measurements(&names, &climbed.rungs, contestant.has_own_clock());
    measurements.extend(evidence.drift.iter().flat_map(|drift| rows::drift_rates(&names, drift)));
    Cell {
        measurements,
        orders: rows::orders(&names, &evidence),
        drifts: evidence.drift.iter().map(|drift| rows::drift(&names, drift)).collect(),
        verdicts: Vec::new(),
        series: if series {
            series_of(&names, (scene, reference), contestant, &climbed.rungs)
        } else {
            Vec::new()
        },
        evidence: Arc::new(evidence),
    }
}

/// Everything that gates read.
fn evidence(
    scene: &Scene,
    reference: &Reference,
    contestant: &Contestant,
    (climbed, bounds): (&Climbed, Bounds),
) -> Evidence {
    let (system, rungs) = (&scene.system, &climbed.rungs);
    let fastest = reference.states.iter().map(|s| rotation::length(&s.angular_velocity)).fold(0.0, f64::max);
    let asked = |claim: Claim| contestant.card.claims.contains(&claim);
    let long_steps = bounds.afforded.map_or(u64::MAX, measure::long_steps);
    let drift = measure::energy_drift_within(contestant, system, scene.duration, long_steps);
    let left_out = LeftOut { steps: climbed.left_out, drift: drift.is_err(), seconds: 0.0 };
    let truth = asked(Claim::FlipTimes).then(|| measure::true_flips(system, reference, fastest)).flatten();
    Evidence {
        ladder: climbed.ladder.clone(),
        precise: climbed.precise.clone(),
        exactness: climbed.exactness.clone(),
        beginning: climbed.beginning.clone(),
        drift: drift.unwrap_or_default(),
        left_out: (climbed.left_out.is_some() || left_out.drift).then_some(left_out),
        points: measure::point_run(contestant, system, scene.duration, fastest),
        flips: truth.and_then(|truth| measure::flips(contestant, system, &reference.states, fastest, truth)),
        reversal: asked(Claim::Reversible).then(|| measure::reversal(contestant, system, rungs)).flatten(),
        symplecticity: asked(Claim::Symplectic)
            .then(|| measure::symplecticity(contestant, system, rungs))
            .flatten(),
        other_worlds: if asked(Claim::Equivariant) {
            measure::other_worlds(contestant, system, rungs)
        } else {
            Vec::new()
        },
        step_limit: step_limit(scene, contestant),
        ..unmeasured(scene, contestant)
    }
}

/// What a scene is to a claim.
pub fn setting(scene: &Scene) -> Setting {
    let system = &scene.system;
    let (constant_force, no_force) = system.constant_force();
    let content = scene.content();
    // A copy in a file is the same scene; an edited one is another that has its name.
    let same = |own: Scene| own.built_in && own.content() == content;
    let built_in = scene.built_in || Scene::find(&scene.name).is_ok_and(same);
    Setting {
        content,
        not_for_order: scene.not_for_order.clone(),
        built_in,
        generic: built_in && GENERIC.contains(&scene.name.as_str()),
        torque_free: system.torque_free(),
        steady_spin: system.steady_spin(),
        symmetric: system.body.symmetric(),
        constant_force,
        no_force,
        point: system.body.shape == Shape::Point,
        jumps: system.forces.pieces().iter().filter(|(end, _)| *end < scene.duration).count() as u64,
    }
}

/// A scheme in a scene, before any measurement.
pub(crate) fn unmeasured(scene: &Scene, contestant: &Contestant) -> Evidence {
    Evidence {
        scene: scene.name.clone(),
        scheme: contestant.card.name.to_owned(),
        model: contestant.model(&scene.system).to_owned(),
        setting: setting(scene),
        claims: contestant.card.claims.to_vec(),
        program: contestant.is_foreign(),
        known_as: contestant.program().map_or(contestant.card.name.to_owned(), |program| program.name),
        ..Evidence::default()
    }
}

/// The order that the ladder of a scheme is climbed for; `None` in a scene that carries no order.
pub(super) fn asked_order(scene: &Scene, contestant: &Contestant) -> Option<u32> {
    let card = &contestant.card;
    let order = if scene.system.torque_free() { card.order_without_torque() } else { card.order() };
    scene.not_for_order.is_none().then_some(order)
}

/// The ladder of the order that the scheme claims in the scene, with the likeliest cause where a program solves another motion.
fn climb(scene: &Scene, reference: &Reference, contestant: &Contestant, bounds: Bounds) -> Climbed {
    let (system, order) = (&scene.system, asked_order(scene, contestant));
    let mut climbed = measure::climb_within(contestant, system, reference, order, bounds);
    if contestant.is_foreign() && goes_elsewhere(&climbed) {
        let [finest, before] = &climbed.finest;
        let cause = cause::likeliest_cause(system, &climbed.truth, finest, before);
        climbed.ladder.cause = cause.map(|cause| cause.words().to_owned());
    }
    climbed
}

/// Whether a program starts or ends elsewhere in any quantity.
fn goes_elsewhere(climbed: &Climbed) -> bool {
    let ladder = &climbed.ladder;
    let elsewhere = |quantity| {
        matches!(measure::decide(&measure::Asked::of(ladder, quantity)), Decision::Elsewhere { .. })
    };
    Quantity::ALL.into_iter().any(|quantity| {
        ladder.start[quantity] > measure::start_allows(ladder, quantity) || elsewhere(quantity)
    })
}

/// The limit of stability of the scheme in the scene, where one is on record.
#[cfg(feature = "cli")]
fn step_limit(scene: &Scene, contestant: &Contestant) -> Option<LinearLimit> {
    let records = crate::record::stability::Stability::built_in();
    records.linear(&scene.name, contestant.card.name).filter(|_| scene.built_in)?;
    stability::linear_limit_in(&scene.name, &Bench::of(&scene.system)?, contestant)
}

/// Limits of stability are measured with the feature `cli`.
#[cfg(not(feature = "cli"))]
fn step_limit(_: &Scene, _: &Contestant) -> Option<LinearLimit> {
    None
}

/// A scheme that there is no time for in the scene.
fn unaffordable(scene: &Scene, contestant: &Contestant) -> Cell {
    let left_out = LeftOut { steps: Some(0), drift: true, seconds: 0.0 };
    let evidence = Evidence { left_out: Some(left_out), ..unmeasured(scene, contestant) };
    Cell {
        measurements: Vec::new(),
        orders: Vec::new(),
        drifts: Vec::new(),
        verdicts: Vec::new(),
        series: Vec::new(),
        evidence: Arc::new(evidence),
    }
}

/// A scheme that cannot take the scene: not applicable, with the reason, for every claim.
pub(super) fn refused(scene: &Scene, contestant: &Contestant, reason: &str) -> Cell {
    let evidence = Evidence { refused: Some(reason.to_owned()), ..unmeasured(scene, contestant) };
    let names = rows::Names {
        scene: &scene.name,
        scheme: contestant.card.name,
        model: contestant.model(&scene.system),
    };
    Cell {
        measurements: vec![rows::not_applicable(&names, reason)],
        orders: Vec::new(),
        drifts: Vec::new(),
        verdicts: Vec::new(),
        series: Vec::new(),
        evidence: Arc::new(evidence),
    }
}

/// Energy and angular momentum against time, at a step that a user might take, the same for every scheme.
fn series_of(
    names: &rows::Names,
    (scene, reference): (&Scene, &Reference),
    contestant: &Contestant,
    rungs: &[Rung],
) -> Vec<Series> {
    let Some(coarsest) = rungs.first() else { return Vec::new() };
    let steps = coarsest.steps * SERIES_STEPS.div_ceil(coarsest.steps);
    let plan = Plan::over(scene.duration, steps, SERIES_SAMPLES);
    let run = contestant.run(&scene.system, Form::Least, &plan);
    let run = against_time::Run { system: &scene.system, reference, step: plan.step, states: &run.states };
    run.series(names)
}
