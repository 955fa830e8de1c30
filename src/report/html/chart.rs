//! What the script draws: the numbers of a chart, in four digits.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Serialize;

use crate::quantity::Quantity;
use crate::record::{Measurement, PrecisionRow, Records, RunStatus, Series};
use crate::report::plot::Looks;
use crate::report::survey;

/// Digits of a number that is drawn: a tenth of a pixel on a chart of a decade in 100 pixels.
const DIGITS: usize = 4;

/// A chart: the reader chooses what stands along its axes.
#[derive(Default, Serialize)]
pub(super) struct Chart {
    /// What it shows, for those who cannot see it.
    title: String,
    /// Whether the axes are logarithmic at first.
    log: [bool; 2],
    /// Whether each error comes with its rounding, so that truncation can be separated from it.
    parts: bool,
    /// The choices along x and along y: a key, and a label with its unit.
    x: Vec<(&'static str, String)>,
    y: Vec<(String, String)>,
    lines: Vec<Line>,
}

/// A line. Lines of one name are switched together.
#[derive(Default, Serialize)]
struct Line {
    name: String,
    /// Tells lines of one name apart.
    #[serde(skip_serializing_if = "String::is_empty")]
    note: String,
    /// Colour on white, colour on a dark ground, dashes.
    look: String,
    x: BTreeMap<&'static str, Vec<Option<f64>>>,
    y: BTreeMap<String, Vec<Option<f64>>>,
    /// Rounding, by the keys of y.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    f: BTreeMap<String, Vec<Option<f64>>>,
}

impl Chart {
    /// `None` where there is nothing to draw.
    fn some(self) -> Option<Chart> {
        (!self.lines.is_empty()).then_some(self)
    }
}

fn drawn(value: f64) -> Option<f64> {
    value.is_finite().then(|| crate::record::to_digits(value, DIGITS))
}

/// The largest |Ω| of the reference [rad/s]; `None` without evidence, and where nothing turns.
pub(in crate::report) fn largest_spin(records: &Records, scene: &str) -> Option<f64> {
    let own = records.evidence.iter().find(|evidence| evidence.scene == scene)?;
    Some(own.ladder.sizes[Quantity::AngularVelocity]).filter(|spin| *spin > 0.0)
}

const X_OF_ERRORS: [(&str, &str); 4] = [
    ("rad", "radians per step"),
    ("step", "step h [s]"),
    ("evaluations", "force evaluations of a run"),
    ("time", "time of a run [s]"),
];

/// The errors at the end of runs that are asked for; `name` and `note` of a line follow from scene and scheme.
pub(super) fn errors(
    records: &Records,
    title: &str,
    wanted: impl Fn(&Measurement) -> bool,
    words: impl Fn(&Measurement) -> (String, String, String),
) -> Option<Chart> {
    let rows = || {
        let end = |row: &&Measurement| row.metric.ends_with("-end") && row.status == RunStatus::Ok;
        records.measurements.iter().map(Arc::as_ref).filter(end).filter(|row| wanted(row))
    };
    let mut cells: Vec<((&str, &str), Vec<&Measurement>)> = Vec::new();
    for row in rows() {
        let key = (row.scene.as_str(), row.scheme.as_str());
        match cells.last_mut().filter(|(last, _)| *last == key) {
            Some((_, own)) => own.push(row),
            None => cells.push((key, vec![row])),
        }
    }
    let mut keys = survey::distinct(rows().map(|row| row.metric.as_str()));
    // Orientation is what most readers ask for.
    keys.sort_by_key(|key| *key != "orientation-end");
    let unit = |metric: &str| rows().find(|row| row.metric == metric).map_or("", |row| row.unit.as_str());
    let label = |key: &str| format!("error of {} at the end [{}]", survey::quantity_words(key), unit(key));
    let lines: Vec<Line> = cells
        .iter()
        .map(|((scene, _), own)| line(own, &keys, largest_spin(records, scene), words(own[0])))
        .collect();
    let has = |key: &str| lines.iter().any(|line| line.x[key].iter().any(Option::is_some));
    let x = X_OF_ERRORS.into_iter().filter(|(key, _)| has(key)).map(|(key, words)| (key, words.to_owned()));
    let x = x.collect();
    let y = keys.iter().map(|key| ((*key).to_owned(), label(key))).collect();
    Chart { title: title.into(), log: [true, true], parts: true, x, y, lines }.some()
}

fn line(
    own: &[&Measurement],
    keys: &[&str],
    spin: Option<f64>,
    (name, note, look): (String, String, String),
) -> Line {
    let mut steps: Vec<f64> = own.iter().map(|row| row.step_s).filter(|step| *step > 0.0).collect();
    steps.sort_by(|a, b| b.total_cmp(a));
    steps.dedup();
    let at = |step: f64, key: Option<&str>| {
        own.iter().find(|row| row.step_s == step && key.is_none_or(|key| row.metric == key))
    };
    let run = |value: &dyn Fn(&Measurement) -> Option<f64>| -> Vec<Option<f64>> {
        steps.iter().map(|step| at(*step, None).and_then(|row| value(row)).and_then(drawn)).collect()
    };
    let x = BTreeMap::from([
        ("step", run(&|row| Some(row.step_s))),
        ("rad", run(&|row| Some(row.step_s * spin?))),
        ("evaluations", run(&|row| Some(row.force_evaluations as f64))),
        ("time", run(&|row| Some(row.nanoseconds_per_step? * 1e-9 * row.steps as f64))),
    ]);
    let each = |value: &dyn Fn(&Measurement) -> Option<f64>| {
        let of = |key: &&str| {
            let own =
                steps.iter().map(|step| at(*step, Some(key)).and_then(|row| value(row)).and_then(drawn));
            ((*key).to_owned(), own.collect())
        };
        keys.iter().map(of).collect()
    };
    Line { name, note, look, x, y: each(&|row| row.value), f: each(&|row| row.uncertainty) }
}

/// What is conserved against time, in a scene.
pub(super) fn against_time(records: &Records, looks: &Looks, scene: &str) -> Option<Chart> {
    let rows: Vec<&Series> = records
        .series
        .iter()
        .map(Arc::as_ref)
        .filter(|row| row.scene == scene && !row.value.is_empty())
        .collect();
    let keys = survey::distinct(rows.iter().map(|row| row.quantity.as_str()));
    let label = |key: &str| {
        let unit = rows.iter().find(|row| row.quantity == key).map_or("", |row| row.unit.as_str());
        let words = key.replace('-', " ");
        if unit == "1" {
            format!("relative change of {words}")
        } else {
            format!("change of {words} [{unit}]")
        }
    };
    let numbers = |list: &[f64]| list.iter().map(|value| drawn(*value)).collect::<Vec<_>>();
    let of = |scheme: &str| {
        let own = || rows.iter().filter(|row| row.scheme == scheme);
        Line {
            name: scheme.into(),
            look: looks.of(scheme),
            x: own().next().map(|row| ("seconds", numbers(&row.time_s))).into_iter().collect(),
            y: own().map(|row| (row.quantity.clone(), numbers(&row.value))).collect(),
            ..Line::default()
        }
    };
    Chart {
        title: format!("Conserved quantities against time, {scene}"),
        log: [false, false],
        x: vec![("seconds", "time [s]".into())],
        y: keys.iter().map(|key| ((*key).to_owned(), label(key))).collect(),
        lines: survey::distinct(rows.iter().map(|row| row.scheme.as_str())).into_iter().map(of).collect(),
        ..Chart::default()
    }
    .some()
}

/// Errors by the arithmetic, in a scene: double-double is truncation alone.
pub(super) fn precision(records: &Records, looks: &Looks, scene: &str) -> Option<Chart> {
    let rows = records.precision.iter().filter(|row| row.scene == scene && !row.runs.is_empty());
    let spin = largest_spin(records, scene);
    let of = |row: &PrecisionRow| {
        let each = |value: &dyn Fn(usize) -> Option<f64>| {
            (0..row.runs.len()).map(|n| value(n).and_then(drawn)).collect()
        };
        Line {
            name: row.scheme.clone(),
            note: row.arithmetic.clone(),
            look: looks.of(&row.scheme),
            x: BTreeMap::from([
                ("step", each(&|n| Some(row.runs[n].step_s))),
                ("rad", each(&|n| Some(row.runs[n].step_s * spin?))),
            ]),
            y: BTreeMap::from([
                ("error".into(), each(&|n| row.runs[n].error_rad)),
                ("rounding".into(), each(&|n| row.runs[n].rounding_rad)),
            ]),
            ..Line::default()
        }
    };
    let mut x = vec![("step", "step h [s]".to_owned())];
    x.extend(spin.map(|_| ("rad", "radians per step".to_owned())));
    let y = [("error", "largest orientation error [rad]"), ("rounding", "rounding of the run [rad]")];
    Chart {
        title: format!("Error by arithmetic, {scene}"),
        log: [true, true],
        x,
        y: y.map(|(key, words)| (key.to_owned(), words.to_owned())).into(),
        lines: rows.map(of).collect(),
        ..Chart::default()
    }
    .some()
}
