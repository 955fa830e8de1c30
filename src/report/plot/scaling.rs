//! How the cost of a step grows with the mass points of the body.

use crate::record::{Grows, Records, ScalingRow};
use crate::report::survey;

use super::line_chart::{Line, LineChart, LinePanel};
use super::sketch::Sketch;

/// Sizes that a line needs to say how it grows.
const FEWEST: usize = 4;

/// The picture; `None` where no cost was measured at four sizes.
pub(super) fn sketch(records: &Records) -> Option<Sketch> {
    let title = "How the cost of a step grows with the mass points of the body".to_owned();
    let panels = vec![panel(records)?];
    Some(LineChart { description: title.clone(), title, subtitle: subtitle(records), panels }.sketch())
}

fn subtitle(records: &Records) -> String {
    let scheme = records.scaling.iter().map(|row| row.scheme.as_str()).find(|name| !name.is_empty());
    scheme.map_or(String::new(), |scheme| {
        format!("{scheme} on a helix of K points, free and with drag on every point")
    })
}

fn panel(records: &Records) -> Option<LinePanel> {
    let rows: Vec<&ScalingRow> = records.scaling.iter().filter(|row| row.what == Grows::Points).collect();
    let line = |words: &str| Line {
        words: words.to_owned(),
        points: rows
            .iter()
            .filter(|row| row.form == words)
            .map(|row| (row.size as f64, Some(row.value)))
            .collect(),
    };
    let forms = survey::distinct(rows.iter().map(|row| row.form.as_str()));
    let lines: Vec<Line> = forms.into_iter().map(line).filter(|line| line.points.len() >= FEWEST).collect();
    (!lines.is_empty()).then(|| LinePanel {
        across: "mass points K".to_owned(),
        across_logarithmic: true,
        up: "Cost of a step [ns], one thread".to_owned(),
        lines,
    })
}
