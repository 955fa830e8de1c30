//! What was measured, written as rows. A number that does not exist becomes `None` here, never a NaN.

use crate::claim::Claim;
use crate::measure::drift::rate_order;
use crate::measure::{self, Asked, Decision, Doubt, Metric, Reading, Rung, decide_either};
use crate::model::{Quantity, sizes};
use crate::record::stability::Stability;
use crate::record::{
    Drift, EnergyDrift, EnergyRung, EngineRow, Evidence, Measurement, Order, OrderStatus, ReferenceEvidence,
    ReferenceRow, RunStatus, SceneRow, SchemeRow, to_digits,
};
use crate::reference::Reference;
use crate::scenes::Scene;
use crate::schemes::{self, Card};
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
        look: schemes::look(card.name),
        fails_where: Stability::built_in().line(card.name).map(str::to_owned),
    }
}

/// Who a foreign program is; `None` for a scheme of the list.
pub(super) fn engine(contestant: &Contestant) -> Option<EngineRow> {
    let Program { name, version, integrator, single_precision, remarks, .. } = contestant.program()?;
    let scheme = contestant.card.name.to_owned();
    Some(EngineRow { scheme, name, version, integrator, single_precision, remarks })
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
        content: scene.content(),
        file: scene.file.clone(),
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

/// A reference, as its gate reads it.
pub(super) fn reference(scene: &Scene, reference: &Reference) -> ReferenceEvidence {
    let (uncertainty, sizes) = (reference.largest_uncertainty(), sizes(&scene.system, &reference.states));
    let of_size = uncertainty.zip(sizes).map(|(off, size)| if size > 0.0 { off / size } else { 0.0 });
    let worst = of_size.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
    ReferenceEvidence {
        scene: scene.name.clone(),
        sources: reference.sources.iter().map(|source| source.name.clone()).collect(),
        worst: worst.filter(|(_, worst)| worst.is_finite()),
        missing: None,
    }
}

/// `own_clock`: whether the runs were timed by the program itself that made them. All others are timed after the campaign, alone.
pub(super) fn measurements(names: &Names, rungs: &[Rung], own_clock: bool) -> Vec<Measurement> {
    let finest = rungs.iter().rposition(|rung| rung.outcome.broken.is_none());
    let is_zero = |rung: &Rung, quantity| rung.outcome.broken.is_none() && rung.errors[quantity].end == 0.0;
    // What is zero at every step is said once.
    let varies = |quantity: Quantity| {
        ranking_reads(&end(quantity)) || !rungs.iter().all(|rung| is_zero(rung, quantity))
    };
    let rows = |(index, rung): (usize, &Rung)| {
        let run = run_row(names, rung, own_clock);
        let is_finest = Some(index) == finest;
        let mut rows = error_rows(&run, rung, |quantity| is_finest || varies(quantity));
        if is_finest {
            rows.extend(metric_rows(&run, rung));
        }
        rows
    };
    rungs.iter().enumerate().flat_map(rows).collect()
}

/// Metric of the error of a quantity at the end.
fn end(quantity: Quantity) -> String {
    format!("{}-end", quantity.name())
}

/// Whether rankings read a metric at every step.
pub(super) fn ranking_reads(metric: &str) -> bool {
    [Quantity::Orientation, Quantity::BodyPoint].map(end).iter().any(|read| read == metric)
}

/// Digits of a value in a row, …
const VALUE_DIGITS: usize = 7;
/// … of a cost, which differs from run to run, …
pub(super) const COST_DIGITS: usize = 4;
/// … and of an uncertainty.
const UNCERTAINTY_DIGITS: usize = 3;

/// A row of a run, without its metric.
fn run_row(names: &Names, rung: &Rung, own_clock: bool) -> Measurement {
    let Outcome { steps, nanoseconds, evaluations, ref broken, .. } = rung.outcome;
    let timed = own_clock && steps > 0;
    Measurement {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        model: names.model.to_owned(),
        step_s: rung.step,
        steps: rung.steps,
        status: if broken.is_some() { RunStatus::Broken } else { RunStatus::Ok },
        why: broken.as_ref().map(ToString::to_string),
        force_evaluations: evaluations,
        nanoseconds_per_step: timed.then(|| to_digits(nanoseconds as f64 / steps as f64, COST_DIGITS)),
        ..Measurement::default()
    }
}

/// The errors at the end of a run in the quantities that are asked for.
fn error_rows(run: &Measurement, rung: &Rung, asked: impl Fn(Quantity) -> bool) -> Vec<Measurement> {
    let row = |(quantity, errors): (Quantity, &Reading)| Measurement {
        metric: end(quantity),
        value: shown(errors.end),
        unit: quantity.unit().to_owned(),
        uncertainty: uncertain(rung.floors[quantity].end),
        ..run.clone()
    };
    rung.errors.iter().filter(|(quantity, _)| asked(*quantity)).map(row).collect()
}

/// The other metrics: the largest value of each over the run. They have rows at the finest step only, the one that tables show.
fn metric_rows(run: &Measurement, rung: &Rung) -> Vec<Measurement> {
    let rounding = f64::EPSILON * (rung.steps as f64).sqrt();
    let row = |(metric, reading): (&Metric, &Option<Reading>)| {
        let reading = reading.filter(|reading| reading.max != 0.0)?;
        Some(Measurement {
            metric: format!("{}-max", metric.name),
            value: shown(reading.max),
            unit: metric.unit.to_owned(),
            uncertainty: uncertain(rounding),
            ..run.clone()
        })
    };
    measure::ALL.iter().zip(&rung.readings).filter_map(row).collect()
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
    Quantity::ALL.into_iter().map(|quantity| order(names, evidence, quantity)).collect()
}

/// What the rule of orders says of a quantity.
fn order(names: &Names, evidence: &Evidence, quantity: Quantity) -> Order {
    let ladder = &evidence.ladder;
    let (decision, finer) = decide_either(evidence.ladders(), quantity);
    let asked = Asked::of(finer.unwrap_or(ladder), quantity);
    let last = asked.runs.last();
    let mut row = Order {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        quantity: quantity.name().to_owned(),
        rungs_dropped: asked.runs.len(),
        floor: last.and_then(|run| shown(asked.floor(run, asked.times.len()))),
        unit: quantity.unit().to_owned(),
        ..Order::default()
    };
    match decision {
        Decision::Order(found) => {
            let (low, high) = found.bounds();
            // The pairs of runs that r fell over.
            let used = &asked.runs[found.rungs - RUNGS_OF_DECISION..found.rungs];
            row.status = OrderStatus::Decided;
            (row.order, row.low, row.high) = (shown(found.slope), shown(low), shown(high));
            (row.constant, row.r, row.until_s) = (shown(found.constant), shown(found.r), Some(found.until));
            (row.rungs_used, row.rungs_dropped) = (used.len(), asked.runs.len() - used.len());
            row.steps_used_s = used.iter().map(|run| run.step).collect();
        }
        Decision::Exact => {
            row.status = OrderStatus::Exact;
            row.why = Some("every error is at its rounding".to_owned());
        }
        Decision::Elsewhere { error, .. } => {
            row.status = OrderStatus::Elsewhere;
            row.why = Some(format!("the error stays at {error:.4} {}", quantity.unit()));
        }
        Decision::Undecided(doubt) => {
            row.status = match doubt {
                _ if last.is_none_or(|run| run.errors.is_empty()) => OrderStatus::Broken,
                Doubt::NotAsymptotic { .. } => OrderStatus::Undecided,
                _ => OrderStatus::TooFew,
            };
            row.why = Some("r falls below a tenth for no order".to_owned());
        }
    }
    row
}

/// Runs that r falls over: two falls lie between three pairs.
const RUNGS_OF_DECISION: usize = 4;

pub(super) fn drift(names: &Names, drift: &EnergyDrift) -> Drift {
    let shown = &drift.rungs[drift.shown];
    let order = if let Decision::Order(order) = rate_order(drift) { Some(order) } else { None };
    Drift {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        quantity: "rotational-energy".to_owned(),
        class: drift.class,
        rate_order: order.map(|order| order.slope),
        low: order.map(|order| order.bounds().0),
        high: order.map(|order| order.bounds().1),
        rate: finite(shown.rate),
        step_s: Some(shown.step),
        level: finite(shown.level),
        unit: "1".to_owned(),
    }
}

pub(super) fn drift_rates(names: &Names, drift: &EnergyDrift) -> Vec<Measurement> {
    let row = |rung: &EnergyRung, metric: &str, value, unit: &str, uncertainty| Measurement {
        scene: names.scene.to_owned(),
        scheme: names.scheme.to_owned(),
        model: "free".to_owned(),
        step_s: rung.step,
        steps: rung.steps,
        metric: metric.to_owned(),
        value: shown(value),
        unit: unit.to_owned(),
        uncertainty: shown(uncertainty),
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

/// A value as a row has it.
fn shown(value: f64) -> Option<f64> {
    finite(to_digits(value, VALUE_DIGITS))
}

/// An uncertainty as a row has it.
fn uncertain(value: f64) -> Option<f64> {
    finite(to_digits(value, UNCERTAINTY_DIGITS))
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
