//! Numbers for dashboards that plot a benchmark over time: error constants, drift and work, smaller is better.

use serde_json::{Map, Value, json};

use crate::record::{Records, to_digits};

/// What marks a file of this program.
pub const MARK: &str = "polhode";

/// Digits of a number: a constant is held to the hundredth.
const DIGITS: usize = 6;

/// One number of a scheme in a scene.
struct Number {
    name: String,
    measure: &'static str,
    unit: String,
    value: f64,
}

/// The error constants, the rates of drift and the evaluations a step.
fn numbers(records: &Records) -> Vec<Number> {
    let place = |scheme: &str, scene: &str| format!("{MARK}/{scheme}/{scene}");
    let constants = records.orders.iter().filter_map(|row| {
        let order = row.order?.round();
        let name = format!("{}/{}", place(&row.scheme, &row.scene), row.quantity);
        let unit = format!("{}/s^{order}", row.unit);
        Some(Number { name, measure: "error-constant", unit, value: row.constant? })
    });
    let drifts = records.drifts.iter().filter_map(|row| {
        let name = format!("{}/{}", place(&row.scheme, &row.scene), row.quantity);
        Some(Number { name, measure: "drift", unit: format!("{}/s", row.unit), value: row.rate?.abs() })
    });
    let work = records.evidence.iter().filter_map(|row| {
        let finest = row.ladder.rungs.iter().rfind(|rung| rung.broken.is_none() && rung.steps > 0)?;
        let value = finest.evaluations as f64 / finest.steps as f64;
        let name = format!("{}/work", place(&row.scheme, &row.scene));
        Some(Number { name, measure: "evaluations", unit: "evaluations/step".to_owned(), value })
    });
    let all = constants.chain(drifts).chain(work).filter(|number| number.value.is_finite());
    all.map(|number| Number { value: to_digits(number.value, DIGITS), ..number }).collect()
}

/// The list that github-action-benchmark reads as `customSmallerIsBetter`.
pub fn smaller_is_better(records: &Records) -> String {
    let row = |number: Number| {
        let name = format!("{} {}", number.name, number.measure);
        json!({"extra": format!("{MARK} {}", records.polhode), "name": name, "unit": number.unit, "value": number.value})
    };
    let rows: Vec<Value> = numbers(records).into_iter().map(row).collect();
    format!("{:#}\n", Value::Array(rows))
}

/// The table of benchmarks and measures that Bencher reads, its Metric Format.
pub fn bencher(records: &Records) -> String {
    let mut benchmarks: Map<String, Value> = Map::new();
    for number in numbers(records) {
        benchmarks.entry(number.name).or_insert_with(|| json!({}))[number.measure] =
            json!({"value": number.value});
    }
    format!("{:#}\n", Value::Object(benchmarks))
}
