//! How cost grows: a step with the mass points of the body, a campaign with its cells and its threads.

use crate::record::{Grows, Records, ScalingRow};
use crate::report::survey;

use super::line_chart::{Line, LineChart, LinePanel};
use super::sketch::Sketch;

/// The picture; `None` where nothing was measured.
pub(super) fn sketch(records: &Records) -> Option<Sketch> {
    let panels: Vec<LinePanel> = [
        panel(records, Grows::Points, "mass points K", "Cost of a step [ns], one thread"),
        panel(records, Grows::Cells, "cells: schemes × scenes", "Time of a campaign [s]"),
    ]
    .into_iter()
    .flatten()
    .collect();
    if panels.is_empty() {
        return None;
    }
    let title = "How cost grows with the size of the body and of the campaign".to_owned();
    let chart = LineChart { description: title.clone(), title, subtitle: subtitle(records), panels };
    Some(chart.sketch())
}

fn subtitle(records: &Records) -> String {
    let scheme = records.scaling.iter().map(|row| row.scheme.as_str()).find(|name| !name.is_empty());
    scheme.map_or(String::new(), |scheme| {
        format!("{scheme} on a helix of K points, free and with drag on every point")
    })
}

fn panel(records: &Records, what: Grows, across: &str, up: &str) -> Option<LinePanel> {
    let rows: Vec<&ScalingRow> = records.scaling.iter().filter(|row| row.what == what).collect();
    let names: Vec<String> = rows.iter().map(|row| name(row)).collect();
    let line = |words: &str| Line {
        words: words.to_owned(),
        points: rows
            .iter()
            .filter(|row| name(row) == words)
            .map(|row| (row.size as f64, Some(row.value)))
            .collect(),
    };
    let lines: Vec<Line> = survey::distinct(names.iter().map(String::as_str)).into_iter().map(line).collect();
    (!lines.is_empty()).then(|| LinePanel {
        across: across.to_owned(),
        across_logarithmic: true,
        up: up.to_owned(),
        lines,
    })
}

fn name(row: &ScalingRow) -> String {
    match row.what {
        Grows::Points => row.form.clone(),
        _ if row.threads == 1 => "1 thread".to_owned(),
        _ => format!("{} threads", row.threads),
    }
}
