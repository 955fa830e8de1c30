//! Per scene: the error of foreign programs and of our schemes, against the step and against the time that a run takes. A program
//! has a colour and a marker, whatever its integrator; its integrators are named at the ends of their lines. Ours are
//! grey; single precision has hollow markers.

use std::sync::Arc;

use crate::record::{EngineRow, Measurement, Records, RunStatus};
use crate::report::{ranking, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::labels::{self, Label};
use super::legend::{self, Entry, Sign};
use super::palette::{INK, Look, Marker, Palette, SOFT};
use super::panel::{self, Frame, Panel};
use super::sketch::{Place, Sketch};

const WIDTH: f64 = 2600.0;
/// Height of the panels at the least, and of a label in them.
const PANELS: f64 = 1200.0;
const LEADING: f64 = 40.0;
/// Below the panels: numbers and titles of the axes.
const FOOT: f64 = 150.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;
/// Letters of a label at the most.
const LETTERS: usize = 26;

/// A ladder of one program or scheme.
struct Line<'a> {
    scheme: &'a str,
    words: String,
    look: Look,
    filled: bool,
    width: f64,
    /// log₁₀ of step, of nanoseconds a simulated second, of the error.
    points: Vec<(f64, f64, f64)>,
    engine: Option<&'a EngineRow>,
}

/// The picture; `None` where no program has errors.
pub(super) fn sketch(records: &Records, scene: &str) -> Option<Sketch> {
    let palette = Palette::new(survey::distinct(records.engines.iter().map(|row| row.name.as_str())));
    let lines = lines(records, scene, &palette);
    if !lines.iter().any(|line| line.engine.is_some()) {
        return None;
    }
    let title = survey::title(records, scene);
    let quantity = survey::quantity_words(ranking::quantity(records, scene));
    let entries = entries(&lines, &palette);
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let bottom = TOP + FOOT + PANELS.max(LEADING * lines.len() as f64);
    let height = bottom + legend::height(&entries, room) + 2.0 * MARGIN;
    let mut sketch =
        Sketch::new(WIDTH, height, format!("{title}: foreign engines, error against step and cost"));
    let unit = unit(records, scene);
    let subtitle =
        format!("{scene} · engines beside our schemes (grey): error of the {quantity} at the end [{unit}]");
    panel::headline(&mut sketch, title, &subtitle);
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom };
    let merged = merged(records, scene, &lines);
    draw(&mut sketch, &lines, &merged, all.cell((2, 1), 0), "step h [s]", |point| point.0);
    let words = "nanoseconds a simulated second (this machine)";
    let each: Vec<Option<String>> = lines.iter().map(|line| Some(line.words.clone())).collect();
    draw(&mut sketch, &lines, &each, all.cell((2, 1), 1), words, |point| point.1);
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, bottom + MARGIN, room);
    Some(sketch)
}

/// Unit of the error.
fn unit<'a>(records: &'a Records, scene: &str) -> &'a str {
    let metric = ranking::quantity(records, scene);
    let own = records.measurements.iter().find(|row| row.scene == scene && row.metric == metric);
    own.map_or("1", |row| row.unit.as_str())
}

fn entries(lines: &[Line], palette: &Palette) -> Vec<Entry> {
    let drawn = |name: &&&str| lines.iter().any(|line| line.engine.is_some_and(|row| row.name == **name));
    let names = palette.schemes().iter().filter(drawn);
    let mut entries: Vec<Entry> =
        names.map(|name| Entry::new(Sign::Scheme(palette.look(name)), *name)).collect();
    entries.push(Entry::new(Sign::Scheme(OURS), "Polhode's own"));
    if lines.iter().any(|line| !line.filled) {
        entries.push(Entry::new(Sign::Hollow, "single precision (f32)"));
    }
    entries
}

/// The look of our own schemes.
const OURS: Look = Look { ink: SOFT, text: INK, marker: Marker::Disc, dash: &[] };

fn lines<'a>(records: &'a Records, scene: &str, palette: &Palette) -> Vec<Line<'a>> {
    let metric = ranking::quantity(records, scene);
    let here = |row: &&Measurement| row.scene == scene && row.metric == metric && row.status == RunStatus::Ok;
    let rows: Vec<&Measurement> = records.measurements.iter().map(Arc::as_ref).filter(here).collect();
    let line = |scheme: &'a str| {
        let engine = records.engines.iter().find(|row| row.scheme == scheme);
        let words = match engine {
            Some(row) if row.integrator.is_empty() => row.name.clone(),
            Some(row) => row.integrator.clone(),
            None => scheme.to_owned(),
        };
        let mut points: Vec<_> =
            rows.iter().filter(|row| row.scheme == scheme).filter_map(|row| point(row)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Line {
            scheme,
            words: panel_words(&words),
            look: engine.map_or(OURS, |row| palette.look(&row.name)),
            filled: !engine.is_some_and(|row| row.single_precision),
            width: if engine.is_some() { 4.0 } else { 3.0 },
            points,
            engine,
        }
    };
    survey::schemes(records).into_iter().map(line).filter(|line| !line.points.is_empty()).collect()
}

/// What stands at the end of each line where twins lie over one another: the first is named for all.
fn merged(records: &Records, scene: &str, lines: &[Line]) -> Vec<Option<String>> {
    let here = || records.twins.iter().filter(|twin| twin.scene == scene);
    let coarsest = here().map(|twin| twin.step_s).fold(0.0, f64::max);
    let twins = |a: &Line, b: &Line| {
        here().any(|twin| {
            let pair = [twin.one.as_str(), twin.other.as_str()];
            twin.step_s == coarsest
                && twin.to_rounding
                && pair.contains(&a.scheme)
                && pair.contains(&b.scheme)
        })
    };
    let first =
        |line: &Line| lines.iter().position(|other| other.scheme == line.scheme || twins(line, other));
    let firsts: Vec<Option<usize>> = lines.iter().map(first).collect();
    let name = |(index, line): (usize, &Line)| {
        let others = firsts.iter().filter(|first| **first == Some(index)).count();
        match others {
            0 => None,
            1 => Some(line.words.clone()),
            2 => Some(format!("{} and its twin", line.words)),
            _ => Some(format!("{} and {} twins", line.words, others - 1)),
        }
    };
    lines.iter().enumerate().map(name).collect()
}

fn panel_words(words: &str) -> String {
    if words.chars().count() <= LETTERS {
        return words.to_owned();
    }
    words.chars().take(LETTERS - 1).chain(['…']).collect()
}

fn point(row: &Measurement) -> Option<(f64, f64, f64)> {
    let error = row.value.filter(|value| *value > 0.0 && value.is_finite())?;
    let cost = row.nanoseconds_per_step.filter(|cost| *cost > 0.0)? / row.step_s;
    Some((row.step_s.log10(), cost.log10(), error.log10()))
}

fn draw(
    sketch: &mut Sketch,
    lines: &[Line],
    named: &[Option<String>],
    cell: Frame,
    words: &str,
    across: fn(&(f64, f64, f64)) -> f64,
) {
    let column = labels::column_width(named.iter().flatten().map(String::as_str));
    let frame = cell.inside(128.0, 40.0, column, 110.0);
    let points = || lines.iter().flat_map(|line| &line.points);
    let (left, right) = bounds(&points().map(across).collect::<Vec<_>>());
    let (low, high) = bounds(&points().map(|point| point.2).collect::<Vec<_>>());
    let panel = Panel {
        frame,
        x: Axis::logarithmic(left - 0.15, right + 0.15, 6),
        y: Axis::logarithmic(low - 0.4, high + 0.4, 9),
    };
    panel.draw_grid(sketch);
    // Ours first, so that the programs lie over them.
    for foreign in [false, true] {
        for line in lines.iter().filter(|line| line.engine.is_some() == foreign) {
            let places: Vec<Place> = line.points.iter().map(|p| panel.place(across(p), p.2)).collect();
            sketch.line(places.clone(), line.look.ink, line.width);
            for place in places {
                sketch.marker(line.look.marker, place, 9.0, line.look.ink, line.filled);
            }
        }
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, words);
    panel.label_y(sketch);
    let ends = lines.iter().zip(named).filter_map(|(line, words)| {
        let words = words.clone()?;
        let last = line.points.iter().max_by(|a, b| across(a).total_cmp(&across(b)))?;
        Some(Label { words, end: panel.place(across(last), last.2), look: line.look })
    });
    labels::draw(sketch, frame, ends.collect());
}
