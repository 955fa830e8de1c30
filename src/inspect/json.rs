//! An inspection as JSON, schema polhode/inspect/1.

use nalgebra::Matrix3;
use serde_json::{Value, json};

use super::link::{Inertial, Link, SIX, six_of};
use super::repair::{Advice, Repair};
use super::verdict::Judged;
use super::{Inspection, Verdict};

pub(super) fn of(inspection: &Inspection) -> Value {
    let bodies: Vec<Value> = inspection
        .bodies
        .iter()
        .zip(&inspection.advice)
        .map(|((link, judged), advice)| body(link, judged, advice))
        .collect();
    let verdicts: serde_json::Map<String, Value> = inspection
        .counts()
        .into_iter()
        .map(|(verdict, count)| (verdict.word().to_owned(), count.into()))
        .collect();
    json!({
        "schema": "polhode/inspect/1",
        "file": inspection.file,
        "format": inspection.format,
        "verdicts": verdicts,
        "notes": inspection.notes,
        "stepping": inspection.stepping.as_ref().map(|stepping| json!({
            "integrator": stepping.integrator,
            "step_s": stepping.step,
            "step_given": stepping.step_given,
            "nearest_scheme": stepping.scheme,
        })),
        "bodies": bodies,
    })
}

fn body(link: &Link, judged: &Judged, advice: &Advice) -> Value {
    let inertial = link.inertial.as_ref();
    json!({
        "name": link.name,
        "line": link.line,
        "source": link.source.word(),
        "mass_kg": inertial.map(|inertial| inertial.mass.value),
        "com_m": inertial.map(|inertial| inertial.pose.position.as_slice().to_vec()),
        "tensor_link_axes_kg_m2": inertial.map(Inertial::tensor).map(|tensor| six(&tensor)),
        "principal_kg_m2": judged.moments,
        "gyration_radius_max_m": inertial.zip(judged.moments).map(|(inertial, moments)| (moments[2] / inertial.mass.value).sqrt()),
        "verdict": judged.verdict.word(),
        "findings": judged.findings,
        "triangle_slack": judged.moments.map(|moments| judged.slack / moments[2]),
        "printed_resolution_kg_m2": judged.resolution,
        "outline": judged.outline.as_ref().map(|outline| if outline.exact { "exact" } else { "approximate" }),
        "fill": judged.fill,
        "uniform_ratio": judged.uniform_ratio,
        "after_compiler": link.compiled.map(|(mass, moments)| json!({ "mass_kg": mass, "principal_kg_m2": moments })),
        "oddities": advice.oddities,
        "single_changes": advice.candidates,
        "repair": advice.repair.as_ref().map(repair),
        "several": advice.several.iter().map(repair).collect::<Vec<_>>(),
        "no_repair": judged.verdict <= Verdict::Suspect && advice.repair.is_none() && advice.several.is_empty(),
        "notes": link.notes,
    })
}

fn repair(repair: &Repair) -> Value {
    json!({
        "kind": repair.kind,
        "what": repair.what,
        "how_known": repair.how_known,
        "unique": repair.unique,
        "mass_after_kg": repair.mass,
        "com_after_m": repair.center.as_slice(),
        "tensor_after_link_axes_kg_m2": six(&repair.tensor),
    })
}

fn six(tensor: &Matrix3<f64>) -> Value {
    SIX.into_iter()
        .map(str::to_owned)
        .zip(six_of(tensor).map(Value::from))
        .collect::<serde_json::Map<_, _>>()
        .into()
}
