//! The rows of a sweep, as CSV and as JSON.

use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::study::sweep::{Row, STEP, Sweep};

pub(super) fn csv(sweep: &Sweep, rows: &[Row]) -> String {
    let quantity = sweep.quantity.name().replace('-', "_");
    let unit = sweep.quantity.unit().replace(' ', "_").replace('²', "2").replace('/', "_");
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = vec!["scheme".to_owned()];
    // The step that was taken has a column besides.
    header.extend(
        sweep.axes.iter().map(
            |axis| {
                if axis.key == STEP { "step_asked_s".to_owned() } else { axis.key.clone() }
            },
        ),
    );
    header.extend(["step_s", "steps", "status", "why"].map(str::to_owned));
    header.extend([
        format!("{quantity}_error_{unit}"),
        "energy_change".to_owned(),
        "force_evaluations".to_owned(),
    ]);
    writer.write_record(&header).expect("a vector takes every row");
    let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    for row in rows {
        let mut fields = vec![row.scheme.clone()];
        fields.extend(row.values.iter().map(f64::to_string));
        fields.extend([row.step.to_string(), row.steps.to_string(), row.status.to_string()]);
        fields.extend([row.why.clone().unwrap_or_default(), number(row.error), number(row.energy)]);
        fields.push(row.evaluations.to_string());
        writer.write_record(&fields).expect("rows are of one length");
    }
    let bytes = writer.into_inner().expect("a vector takes every byte");
    String::from_utf8(bytes).expect("CSV of UTF-8 fields is UTF-8")
}

/// What is written as JSON, the schema first.
#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    scene: &'a str,
    quantity: &'static str,
    unit: &'static str,
    rows: Vec<Value>,
}

/// As JSON, schema polhode/sweep/1: an object a row, with the numbers that are varied under their keys.
pub(super) fn json(scene: &str, sweep: &Sweep, rows: &[Row]) -> String {
    let row = |row: &Row| {
        let varied = sweep.axes.iter().zip(&row.values).map(|(axis, value)| (axis.key.clone(), json!(value)));
        json!({
            "scheme": row.scheme,
            "varied": varied.collect::<Map<String, Value>>(),
            "step_s": row.step,
            "steps": row.steps,
            "status": row.status,
            "why": row.why,
            "error": row.error,
            "energy_change": row.energy,
            "force_evaluations": row.evaluations,
        })
    };
    let (quantity, unit) = (sweep.quantity.name(), sweep.quantity.unit());
    let rows = rows.iter().map(row).collect();
    let document = Document { schema: "polhode/sweep/1", scene, quantity, unit, rows };
    serde_json::to_string_pretty(&document).expect("keys are text") + "\n"
}
