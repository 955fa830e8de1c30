//! A section of the report: one scene.

use std::sync::Arc;

use serde::Serialize;

use crate::record::{Measurement, Records, ReferenceRow, RunStatus, SceneRow};
use crate::report::plot::{Cast, Group, Subject};
use crate::report::{number, survey};

use super::rankings::Ranking;
use super::tables::{DriftRow, OrderRow, cost};
use super::{Figure, FigureView, VerdictRow, figure};

/// One scene.
#[derive(Serialize)]
pub(super) struct Scene {
    name: String,
    anchor: String,
    title: String,
    tally: String,
    worst: &'static str,
    card: Option<Card>,
    schemes: Vec<String>,
    costs: Vec<String>,
    figures: Vec<FigureView>,
    ranking: Option<Ranking>,
    orders: Vec<OrderRow>,
    drifts: Vec<DriftRow>,
    measures: Vec<Measure>,
    verdicts: Vec<VerdictRow>,
    attention: Vec<VerdictRow>,
}

/// What a scene is.
#[derive(Serialize)]
struct Card {
    why: String,
    duration: String,
    model: String,
    model_reason: &'static str,
    points: String,
    laws: String,
    not_for_order: Option<String>,
    references: Vec<Reference>,
    reduction_difference: Option<String>,
    reduction_speedup: Option<String>,
}

/// A source of the reference solution.
#[derive(Serialize)]
struct Reference {
    source: String,
    detail: String,
    role: String,
    disagreement: String,
}

/// A metric at the finest step, a cell a scheme.
#[derive(Serialize)]
struct Measure {
    metric: String,
    cells: Vec<String>,
}

impl Scene {
    pub(super) fn new(records: &Records, figures: &[Figure], name: &str, ranking: Option<Ranking>) -> Scene {
        let verdicts = records.verdicts.iter().filter(|row| row.scene == name);
        let worst = verdicts.clone().map(survey::Outcome::of).min();
        let rows: Vec<&Measurement> =
            records.measurements.iter().map(Arc::as_ref).filter(|row| row.scene == name).collect();
        let schemes = survey::distinct(rows.iter().map(|row| row.scheme.as_str()));
        Scene {
            name: name.into(),
            anchor: survey::file_stem(name),
            title: survey::title(records, name).into(),
            tally: survey::tally_words(&survey::tally(verdicts.clone())),
            worst: worst.map_or("", survey::Outcome::class),
            card: survey::scene(records, name).map(Card::new),
            costs: costs(records, name, &schemes),
            figures: scene_figures(figures, name),
            ranking,
            orders: records.orders.iter().filter(|row| row.scene == name).map(OrderRow::new).collect(),
            drifts: records.drifts.iter().filter(|row| row.scene == name).map(DriftRow::new).collect(),
            measures: measures(&rows, &schemes),
            schemes: schemes.iter().map(|scheme| finest_words(&rows, scheme)).collect(),
            attention: super::attention(verdicts.clone()),
            verdicts: verdicts.map(VerdictRow::new).collect(),
        }
    }
}

impl Card {
    fn new(row: &SceneRow) -> Card {
        let points = match row.points {
            0 => "no positive masses stand for its inertia".into(),
            count => number::counted(count, "mass point"),
        };
        Card {
            why: row.why.clone(),
            duration: format!("{} s", number::setting(row.duration_s)),
            model: row.model.clone(),
            model_reason: model_reason(&row.model),
            points,
            laws: if row.laws.is_empty() { "none".into() } else { row.laws.join(", ") },
            not_for_order: row.not_for_order.clone(),
            references: row.references.iter().map(Reference::new).collect(),
            reduction_difference: row.reduction_difference.map(|value| number::significant(value, 2)),
            reduction_speedup: row.reduction_speedup.map(|value| number::significant(value, 3)),
        }
    }
}

/// Why a model is the least that determines the motion.
fn model_reason(model: &str) -> &'static str {
    match model {
        "free" => "neither force nor torque: only the orientation has to be stepped",
        "falling" => {
            "forces act on the centre of mass only: it moves by itself, and the body turns as if free"
        }
        "torque" => "torques and no force: only orientation and angular momentum have to be stepped",
        "pivot" => "a fixed point: orientation and angular momentum about it determine the motion",
        "forced" => "forces on points: everything moves, but only the points that carry a force are visited",
        _ => "",
    }
}

impl Reference {
    fn new(row: &ReferenceRow) -> Reference {
        let angle = |angle| format!("{} rad", number::significant(angle, 2));
        Reference {
            source: row.source.clone(),
            detail: row.detail.clone(),
            role: row.role.clone(),
            disagreement: row.disagreement_rad.map_or(number::NONE.into(), angle),
        }
    }
}

fn scene_figures(figures: &[Figure], name: &str) -> Vec<FigureView> {
    let convergence = "Error at the end of the run against the time step.";
    let invariants = "Change of energy and angular momentum against time.";
    let mut views = vec![
        figure(figures, &Subject::Convergence(name.into()), convergence),
        figure(figures, &Subject::Invariants(name.into()), invariants),
    ];
    for cast in [Cast::Main, Cast::Everyone] {
        let caption = match cast {
            Cast::Main => "Error at the end of the run against cost and against the step.",
            Cast::Everyone => "Every scheme: error at the end of the run against cost and against the step.",
        };
        let of = |group| figure(figures, &Subject::WorkPrecision(name.into(), cast, group), caption);
        views.extend(Group::ALL.map(of));
    }
    views.into_iter().flatten().collect()
}

fn costs(records: &Records, scene: &str, schemes: &[&str]) -> Vec<String> {
    let of_scheme = |scheme: &&str| {
        let range = cost(records, |row| row.scene == scene && row.scheme == **scheme);
        (range != number::NONE).then(|| format!("{scheme} {range} a step"))
    };
    schemes.iter().filter_map(of_scheme).collect()
}

/// The finest step at which a scheme was run.
fn finest(rows: &[&Measurement], scheme: &str) -> Option<f64> {
    rows.iter().filter(|row| row.scheme == scheme).map(|row| row.step_s).reduce(f64::min)
}

fn finest_words(rows: &[&Measurement], scheme: &str) -> String {
    let step = finest(rows, scheme).map(|step| format!(", h = {} s", number::setting(step)));
    format!("{scheme}{}", step.unwrap_or_default())
}

fn measures(rows: &[&Measurement], schemes: &[&str]) -> Vec<Measure> {
    let metrics = survey::distinct(rows.iter().map(|row| row.metric.as_str()));
    let steps: Vec<Option<f64>> = schemes.iter().map(|scheme| finest(rows, scheme)).collect();
    let cell = |metric: &str, scheme: &str, step: Option<f64>| {
        let same =
            |row: &&&Measurement| row.metric == metric && row.scheme == scheme && Some(row.step_s) == step;
        rows.iter().find(same).map_or(number::NONE.into(), |row| measured(row))
    };
    let one = |metric: &str| Measure {
        metric: metric.replace('-', " "),
        cells: schemes.iter().zip(&steps).map(|(scheme, step)| cell(metric, scheme, *step)).collect(),
    };
    metrics.into_iter().map(one).collect()
}

fn measured(row: &Measurement) -> String {
    if row.status != RunStatus::Ok {
        let why = row.why.as_ref().map(|why| format!(": {why}")).unwrap_or_default();
        return format!("{}{why}", row.status.word().replace('-', " "));
    }
    number::quantity(row.value, row.uncertainty, &row.unit)
}
