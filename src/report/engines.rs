//! The section on foreign programs: who they are, how far each is off at equal steps, and which of them make the same
//! motion.

mod groups;

use std::io::Write;

use serde::Serialize;

use crate::record::{EngineRow, PeerRow, Records};

use super::page::{Figure, FigureView, figure, machine_words};
use super::plot::Subject;
use super::{markdown, number, survey, template};
use groups::{Alike, Group, Kin};

const PAGE: &str = include_str!("template/engines_page.md");

/// The section.
#[derive(Serialize)]
pub(super) struct Section {
    engines: Vec<EngineView>,
    scenes: Vec<SceneView>,
}

/// A program.
#[derive(Serialize)]
struct EngineView {
    name: String,
    version: String,
    integrator: String,
    precision: &'static str,
    single: bool,
    order: String,
    command: String,
}

/// A scene that programs were compared in.
#[derive(Serialize)]
struct SceneView {
    name: String,
    title: String,
    steps: Vec<String>,
    figure: Option<FigureView>,
    groups: Vec<Group>,
    alike: Vec<Alike>,
    rows: Vec<Row>,
}

/// A program or a scheme in a scene.
#[derive(Serialize)]
struct Row {
    label: String,
    foreign: bool,
    single: bool,
    errors: Vec<String>,
    order: String,
    position: String,
    energy: String,
    cost: String,
    why: String,
}

impl Section {
    /// `None` where the records hold no foreign program.
    pub(super) fn new(records: &Records, figures: &[Figure]) -> Option<Section> {
        // A scene that no program took says nothing about them.
        let foreign = |row: &&PeerRow| records.engines.iter().any(|engine| engine.scheme == row.scheme);
        let scenes = survey::distinct(records.peers.iter().filter(foreign).map(|row| row.scene.as_str()));
        (!records.engines.is_empty()).then(|| Section {
            engines: records.engines.iter().map(|row| engine(records, row)).collect(),
            scenes: scenes.into_iter().map(|scene| scene_view(records, figures, scene)).collect(),
        })
    }
}

fn engine(records: &Records, row: &EngineRow) -> EngineView {
    EngineView {
        name: row.name.clone(),
        version: row.version.clone(),
        integrator: row.integrator.clone(),
        precision: if row.single_precision { "single" } else { "double" },
        single: row.single_precision,
        order: survey::claimed_order(records, &row.scheme).map_or(number::NONE.into(), |p| p.to_string()),
        command: row.scheme.trim_start_matches("engine:").to_owned(),
    }
}

fn scene_view(records: &Records, figures: &[Figure], scene: &str) -> SceneView {
    let rows: Vec<&PeerRow> = records.peers.iter().filter(|row| row.scene == scene).collect();
    let mut steps: Vec<f64> = rows.iter().map(|row| row.step_s).collect();
    steps.sort_by(|a, b| b.total_cmp(a));
    steps.dedup();
    let mut schemes = survey::distinct(rows.iter().map(|row| row.scheme.as_str()));
    let coarse = |scheme: &str| {
        let row = rows.iter().find(|row| row.scheme == scheme && Some(&row.step_s) == steps.first());
        row.and_then(|row| row.orientation_end_rad).unwrap_or(f64::INFINITY)
    };
    schemes.sort_by(|a, b| coarse(a).total_cmp(&coarse(b)));
    let caption =
        "Orientation error at the end of the run against the step and against the time that a run takes.";
    let kin = Kin::new(records, scene, steps.first().copied().unwrap_or_default());
    SceneView {
        name: scene.into(),
        title: survey::title(records, scene).into(),
        figure: figure(figures, &Subject::Engines(scene.into()), caption),
        groups: kin.groups(),
        alike: kin.alike(),
        rows: schemes.iter().map(|scheme| row(records, &rows, &steps, scheme)).collect(),
        steps: steps.into_iter().map(number::setting).collect(),
    }
}

fn row(records: &Records, rows: &[&PeerRow], steps: &[f64], scheme: &str) -> Row {
    let at = |step: &f64| rows.iter().find(|row| row.scheme == scheme && row.step_s == *step);
    let coarse = steps.first().and_then(at);
    let engine = records.engines.iter().find(|row| row.scheme == scheme);
    let errors = || steps.iter().map(|step| at(step).and_then(|row| row.orientation_end_rad));
    let costs = steps.iter().filter_map(|step| at(step)?.nanoseconds_per_step);
    let cost = costs.reduce(f64::min).map(|cost| number::significant(cost, 3));
    Row {
        label: label(records, scheme),
        foreign: engine.is_some(),
        single: engine.is_some_and(|row| row.single_precision),
        order: slope(&errors().collect::<Vec<_>>(), steps),
        errors: errors().map(|error| number::quantity(error, None, "rad")).collect(),
        position: number::quantity(coarse.and_then(|row| row.position_end_m), None, "m"),
        energy: number::quantity(coarse.and_then(|row| row.rotational_energy_max), None, "1"),
        cost: number::joined(&cost.unwrap_or(number::NONE.into()), "ns"),
        why: steps.iter().filter_map(|step| at(step)?.why.clone()).next().unwrap_or_default(),
    }
}

/// Errors from here on show an order; below rounding has a part.
const CLEAR_OF_ROUNDING: f64 = 1e-10;

/// Slope between the first and the last step, where both errors are clear of rounding.
fn slope(errors: &[Option<f64>], steps: &[f64]) -> String {
    let (Some(Some(a)), Some(Some(b))) = (errors.first(), errors.last()) else { return number::NONE.into() };
    if steps.len() < 2 || a.min(*b) < CLEAR_OF_ROUNDING {
        return number::NONE.into();
    }
    let slope = (a / b).log10() / (steps[0] / steps[steps.len() - 1]).log10();
    number::order(Some(slope), None, None)
}

/// Name and integrator of a program, where no other has both; a scheme's own name.
pub(super) fn label(records: &Records, scheme: &str) -> String {
    let Some(row) = records.engines.iter().find(|row| row.scheme == scheme) else { return scheme.into() };
    let label = row.label();
    let others = records.engines.iter().filter(|other| other.label() == label).count();
    if others > 1 { scheme.trim_start_matches("engine:").into() } else { label }
}

/// What the section is made from, without the runs behind its pictures, which are ten times as much.
pub(super) fn kept(records: &Records) -> Records {
    let quantity = |scene: &str| super::ranking::quantity(records, scene);
    let orders = records
        .orders
        .iter()
        .filter(|row| row.quantity == survey::base(quantity(&row.scene)))
        .cloned()
        .collect();
    let brief = Records { measurements: Vec::new(), series: Vec::new(), ..records.clone() };
    Records { verdicts: Vec::new(), drifts: Vec::new(), orders, ..brief }
}

/// The section as a separate page.
#[derive(Serialize)]
struct Page {
    version: String,
    made_at: String,
    machine: String,
    alone: bool,
    engines: Option<Section>,
}

/// Writes the section as a separate page, in Markdown, its pictures beside it.
pub(super) fn page(
    records: &Records,
    figures: &[Figure],
    writer: impl Write,
) -> Result<(), minijinja::Error> {
    let page = Page {
        version: records.polhode.clone(),
        made_at: records.made_at.clone(),
        machine: machine_words(&records.machine),
        alone: true,
        engines: Section::new(records, figures),
    };
    template::fill(&markdown::environment()?, PAGE, &page, writer)
}
