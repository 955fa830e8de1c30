//! What was measured, written as rows. A number that does not exist becomes `None` here, never a NaN.

use crate::claim::Claim;
use crate::measure::regression::Ladder;
use crate::measure::{self, EnergyDrift, Evidence, Place, QuantityLadder, Rung};
use crate::model::{Quantity, Snapshot, System};
use crate::record::stability::Stability;
use crate::record::{
    Drift, EngineRow, Measurement, Order, OrderStatus, ReferenceRow, RunStatus, SceneRow, SchemeRow, Series,
};
use crate::reference::Reference;
use crate::rotation;
use crate::scenes::Scene;
use crate::schemes::Card;
use crate::simulate::{Contestant, Outcome, Program};

/// Whose rows they are.
pub(super) struct Names<'a> {
    pub(super) scene: &'a str,
    pub(super) scheme: &'a str,
    pub(super) model: &'a str,
}

pub(super) fn scheme(card: &Card) -> SchemeRow {
    SchemeRow {
        name: card.name.to_owned(),
        title: card.title.to_owned(),
        family: card.family.to_owned(),
        order: card.order(),
        evaluations: card.evaluations(),
        claims: card.claims.iter().map(Claim::to_string).collect(),
        source: card.source.to_owned(),
        apart: false,
        fails_where: Stability::built_in().line(card.name).map(str::to_owned),
    }
}

/// Who a foreign program is; `None` for a scheme of the list.
pub(super) fn engine(contestant: &Contestant) -> Option<EngineRow> {
    let Program { name, version, integrator, single_precision, .. } = contestant.program()?;
    Some(EngineRow { scheme: contestant.card.name.to_owned(), name, version, integrator, single_precision })
}

pub(super) fn scene(
    scene: &Scene,
    reference: Option<&Reference>,
    reduction_difference: Option<f64>,
) -> SceneRow {
    let references = reference.map_or(Vec::new(), |reference| {
        reference
            .sources
            .iter()
            .map(|source| ReferenceRow {
                source: source.name.clone(),
                detail: source.detail.clone(),
                role: source.role.name().to_owned(),
                disagreement_rad: source.disagreement.and_then(|d| finite(d[Quantity::Orientation])),
            })
            .collect()
    });
    SceneRow {
        name: scene.name.clone(),
        title: scene.title.clone(),
        why: scene.why.clone(),
        duration_s: scene.duration,
        model: scene.system.least().name().to_owned(),
        points: scene.system.body.points.len(),
        laws: scene.system.forces.laws().iter().map(|law| law.name().to_owned()).collect(),
        not_for_order: scene.not_for_order.clone(),
        references,
        reduction_difference: reduction_difference.and_then(finite),
        reduction_speedup: None,
    }
}

/// `own_clock`: whether the runs were timed by the program itself that made them. All others are timed after the campaign, alone.
pub(super) fn measurements(names: &Names, evidence: &Evidence, own_clock: bool) -> Vec<Measurement> {
    let told = |rung: &Rung| {
        let Outcome { steps, nanoseconds, .. } = rung.outcome;
        (own_clock && steps > 0).then(|| nanoseconds as f64 / steps as f64)
    };
    evidence.rungs.iter().flat_map(|rung| rung_rows(names, rung, told(rung))).collect()
}

fn rung_rows(names: &Names, rung: &Rung, nanoseconds_per_step: Option<f64>) -> Vec<Measurement> {
    let outcome = &rung.outcome;
    let common = Measurement {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        model: names.model.to_owned(),
        step_s: rung.step,
        steps: rung.steps,
        status: if outcome.broken.is_some() { RunStatus::Broken } else { RunStatus::Ok },
        why: outcome.broken.as_ref().map(ToString::to_string),
        force_evaluations: outcome.evaluations,
        nanoseconds_per_step,
        ..Measurement::default()
    };
    let mut rows = Vec::new();
    for (quantity, errors) in rung.errors.iter() {
        for place in Place::ALL {
            rows.push(Measurement {
                metric: format!("{}-{}", quantity.name(), place.suffix()),
                value: finite(place.of(errors)),
                unit: quantity.unit().to_owned(),
                uncertainty: finite(place.of(&rung.floors[quantity])),
                ..common.clone()
            });
        }
    }
    for (metric, reading) in measure::ALL.iter().zip(&rung.readings) {
        let Some(reading) = reading else { continue };
        for place in Place::ALL {
            rows.push(Measurement {
                metric: format!("{}-{}", metric.name, place.suffix()),
                value: finite(place.of(reading)),
                unit: metric.unit.to_owned(),
                uncertainty: Some(f64::EPSILON * (rung.steps as f64).sqrt()),
                ..common.clone()
            });
        }
    }
    rows
}

/// The row of a scheme that cannot take a scene.
pub(super) fn not_applicable(names: &Names, reason: &str) -> Measurement {
    Measurement {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        model: names.model.to_owned(),
        metric: "all".to_owned(),
        unit: "1".to_owned(),
        status: RunStatus::NotApplicable,
        why: Some(reason.to_owned()),
        ..Measurement::default()
    }
}

pub(super) fn orders(names: &Names, evidence: &Evidence) -> Vec<Order> {
    evidence.ladders.iter().map(|ladder| order(names, ladder)).collect()
}

fn order(names: &Names, ladder: &QuantityLadder) -> Order {
    let (status, why, used) = match &ladder.ladder {
        Ladder::Window { rungs, .. } => (OrderStatus::Fitted, None, rungs.clone()),
        Ladder::Exact => (
            OrderStatus::Exact,
            Some("every rung is at the floor of rounding and reference".to_owned()),
            0..0,
        ),
        Ladder::TooFew { clear } => {
            (OrderStatus::TooFew, Some(format!("{clear} rungs clear of the floor, 4 needed")), 0..0)
        }
        Ladder::Unsettled => {
            (OrderStatus::Unsettled, Some("no three successive slopes agree to 0.15".to_owned()), 0..0)
        }
        Ladder::Broken => (OrderStatus::Broken, Some("the finest run broke".to_owned()), 0..0),
    };
    let fit = ladder.fit();
    Order {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        quantity: format!("{}-{}", ladder.quantity.name(), ladder.place.suffix()),
        order: fit.map(|fit| fit.slope),
        low: fit.map(|fit| fit.low),
        high: fit.map(|fit| fit.high),
        constant: ladder.constant,
        rungs_used: used.len(),
        rungs_dropped: ladder.rungs.len() - used.len(),
        steps_used_s: ladder.rungs[used].iter().map(|rung| rung.0).collect(),
        floor: ladder.rungs.last().and_then(|rung| finite(rung.2)),
        unit: ladder.quantity.unit().to_owned(),
        status,
        why,
    }
}

pub(super) fn drift(names: &Names, drift: &EnergyDrift) -> Drift {
    let shown = &drift.rungs[drift.shown];
    Drift {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        quantity: "rotational-energy".to_owned(),
        class: drift.class,
        rate_order: drift.order.map(|fit| fit.slope),
        low: drift.order.map(|fit| fit.low),
        high: drift.order.map(|fit| fit.high),
        rate: finite(shown.rate),
        step_s: Some(shown.step),
        level: finite(shown.level),
        unit: "1".to_owned(),
    }
}

pub(super) fn drift_rates(names: &Names, drift: &EnergyDrift) -> Vec<Measurement> {
    let row = |rung: &measure::EnergyRung, metric: &str, value, unit: &str, uncertainty| Measurement {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        model: "free".to_owned(),
        step_s: rung.step,
        steps: rung.steps,
        metric: metric.to_owned(),
        value: finite(value),
        unit: unit.to_owned(),
        uncertainty: finite(uncertainty),
        status: RunStatus::Ok,
        force_evaluations: rung.evaluations,
        ..Measurement::default()
    };
    drift
        .rungs
        .iter()
        .flat_map(|rung| {
            [
                row(rung, "rotational-energy-drift-rate", rung.rate, "1/s", rung.uncertainty),
                row(rung, "rotational-energy-drift-level", rung.level, "1", rung.rounding),
            ]
        })
        .collect()
}

/// Energy, |L| and the direction of L against time, as changes from the start.
pub(super) fn series(names: &Names, system: &System, step: f64, states: &[Snapshot]) -> Vec<Series> {
    let Some(first) = states.first() else { return Vec::new() };
    let momentum = rotation::length(&first.angular_momentum);
    let rotational = system.rotational_energy(first);
    let total = |s: &Snapshot| Some(system.kinetic_energy(s) + system.potential_energy(s)?);
    let mut rows = Vec::new();
    let mut push = |quantity: &str, unit: &str, value: Vec<f64>| {
        if !value.is_empty() && value.iter().all(|v| v.is_finite()) {
            rows.push(Series {
                scene: names.scene.to_owned(),
                scheme: names.scheme.to_owned(),
                step_s: step,
                quantity: quantity.to_owned(),
                unit: unit.to_owned(),
                time_s: states.iter().map(|s| s.time).collect(),
                value,
            });
        }
    };
    if rotational > 0.0 {
        push(
            "rotational-energy",
            "1",
            states.iter().map(|s| system.rotational_energy(s) / rotational - 1.0).collect(),
        );
    }
    if let Some(total_first) = total(first)
        && system.forces.conservative()
        && !system.forces.laws().is_empty()
    {
        let scale = states.iter().map(|s| system.kinetic_energy(s)).fold(0.0, f64::max);
        if scale > 0.0 {
            let change = states.iter().filter_map(|s| Some((total(s)? - total_first) / scale)).collect();
            push("total-energy", "1", change);
        }
    }
    if momentum > 0.0 {
        let magnitude =
            states.iter().map(|s| rotation::length(&s.angular_momentum) / momentum - 1.0).collect();
        push("angular-momentum-magnitude", "1", magnitude);
        let direction =
            |s: &Snapshot| rotation::angle_between_directions(&s.angular_momentum, &first.angular_momentum);
        push("angular-momentum-direction", "rad", states.iter().map(direction).collect());
    }
    rows
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
