//! The table of what a step costs.

use serde::Serialize;

use crate::record::{CostRow, Records};
use crate::report::{number, survey};

/// Costs of a step: a row a scheme, a column a kind of scene.
#[derive(Serialize)]
pub(super) struct Costs {
    kinds: Vec<String>,
    rows: Vec<Row>,
    /// The scheme that was timed twice.
    yardstick: String,
    /// How far its two results are apart.
    noise: Option<String>,
    /// Least time spent on a scheme and kind.
    seconds: String,
}

#[derive(Serialize)]
struct Row {
    scheme: String,
    cells: Vec<String>,
}

impl Costs {
    /// `None` where nothing was timed.
    pub(super) fn new(records: &Records) -> Option<Costs> {
        let rows = || records.costs.iter().filter(|row| !row.again);
        let kinds = survey::distinct(rows().map(|row| row.kind.as_str()));
        let schemes = survey::distinct(rows().map(|row| row.scheme.as_str()));
        if schemes.is_empty() {
            return None;
        }
        let of = |scheme: &str, kind: &str| -> Vec<&CostRow> {
            rows().filter(|row| row.scheme == scheme && row.kind == kind).collect()
        };
        let spent = schemes.iter().flat_map(|scheme| {
            kinds
                .iter()
                .map(|kind| of(scheme, kind))
                .filter(|own| !own.is_empty())
                .map(|own| own.iter().map(|row| row.seconds).sum::<f64>())
                .collect::<Vec<_>>()
        });
        let noise = noise(records);
        Some(Costs {
            rows: schemes
                .iter()
                .map(|scheme| Row {
                    scheme: (*scheme).into(),
                    cells: kinds.iter().map(|kind| cell(&of(scheme, kind))).collect(),
                })
                .collect(),
            kinds: kinds.iter().map(|kind| (*kind).into()).collect(),
            yardstick: noise.as_ref().map_or(String::new(), |(scheme, _)| scheme.clone()),
            noise: noise.map(|(_, words)| words),
            seconds: format!("{} s", number::significant(spent.fold(f64::INFINITY, f64::min), 2)),
        })
    }
}

/// The scheme that was timed twice, and how far its two results are apart.
fn noise(records: &Records) -> Option<(String, String)> {
    let again = records.costs.iter().find(|row| row.again)?;
    let same = |row: &&CostRow| {
        !row.again && (&row.scheme, &row.scene, &row.model) == (&again.scheme, &again.scene, &again.model)
    };
    let first = records.costs.iter().find(same)?;
    let part = (again.nanoseconds_per_step / first.nanoseconds_per_step - 1.0).abs();
    Some((again.scheme.clone(), format!("{} %", number::significant(100.0 * part, 2))))
}

/// `47.1 (2)`, or `47.1 to 92.0 (2)` where the scenes of a kind differ.
fn cell(rows: &[&CostRow]) -> String {
    let range = |value: fn(&CostRow) -> f64, digits: usize| {
        let values: Vec<f64> = rows.iter().map(|row| value(row)).collect();
        let low = values.iter().copied().reduce(f64::min)?;
        let high = values.iter().copied().reduce(f64::max)?;
        let [low, high] = [low, high].map(|value| number::significant(value, digits));
        Some(if low == high { low } else { format!("{low} to {high}") })
    };
    let cost = range(|row| row.nanoseconds_per_step, 3);
    let evaluations = range(|row| (10.0 * row.evaluations_per_step).round() / 10.0, 2);
    match cost.zip(evaluations) {
        Some((cost, evaluations)) => format!("{cost} ({})", evaluations.replace(".0", "")),
        None => number::NONE.into(),
    }
}
