//! Per scene: how far the energy and the angular momentum have moved, against time.

use std::sync::Arc;

use crate::record::{Records, Series};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::labels::{self, Label};
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame, Panel};
use super::sketch::{Place, Sketch};

const WIDTH: f64 = 2400.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;
/// Height of the note about quantities that do not change at all.
const NOTE: f64 = 190.0;
/// Points that a curve is drawn with: each the largest of its part of the run.
const BINS: usize = 220;
/// Markers on a curve.
const MARKERS: usize = 12;

/// One scheme's quantity: (time, log₁₀ of its size, true where it is above its start).
struct Curve<'a> {
    series: &'a Series,
    points: Vec<(f64, f64, bool)>,
}

/// The picture; `None` where the scene has no series.
pub(super) fn sketch(records: &Records, palette: &Palette, scene: &str) -> Option<Sketch> {
    let here: Vec<&Series> =
        records.series.iter().map(Arc::as_ref).filter(|row| row.scene == scene).collect();
    let quantities = survey::distinct(here.iter().map(|row| row.quantity.as_str()));
    if quantities.is_empty() {
        return None;
    }
    let of = |quantity: &str| here.iter().filter(|row| row.quantity == quantity).copied().collect::<Vec<_>>();
    let (still, moving): (Vec<&str>, Vec<&str>) =
        quantities.into_iter().partition(|one| of(one).iter().all(is_still));
    let entries = entries(palette, &here);
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let strip = legend::height(&entries, room);
    let note = if still.is_empty() { 0.0 } else { NOTE };
    let body = row_height(moving.len()) * moving.len() as f64;
    let height = (TOP + body + 100.0 + note + strip + 2.0 * MARGIN).max(1040.0);
    let title = survey::title(records, scene);
    let mut sketch = Sketch::new(WIDTH, height, format!("{title}: change of the invariants against time"));
    let shared = shared_step(&here);
    panel::headline(&mut sketch, title, &subtitle(scene, shared));
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom: TOP + body };
    let words: Vec<String> = here.iter().map(|row| end_words(row, shared)).collect();
    let column = labels::column_width(words.iter().map(String::as_str));
    for (index, quantity) in moving.iter().enumerate() {
        let frame = all.cell((1, moving.len()), index).inside(140.0, 62.0, column, 14.0);
        draw_panel(&mut sketch, palette, (&of(quantity), shared), frame, index + 1 == moving.len());
    }
    if !still.is_empty() {
        let top = if moving.is_empty() { TOP } else { all.bottom + 90.0 };
        let bottom = height - strip - 2.0 * MARGIN;
        let frame = Frame { left: all.left + 140.0, top: top + 20.0, right: all.right - column, bottom };
        let names: Vec<String> = still.iter().map(|name| survey::quantity_words(name)).collect();
        panel::words(&mut sketch, frame, "No change at all in any scheme", &[names.join(" · ")]);
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, height - strip - MARGIN, room);
    Some(sketch)
}

/// Height of a panel with its title, so that few panels are not flat and many not endless.
fn row_height(panels: usize) -> f64 {
    (1080.0 / panels.max(1) as f64).clamp(330.0, 620.0)
}

fn is_still(series: &&Series) -> bool {
    series.value.iter().all(|value| *value == 0.0 || !value.is_finite())
}

/// The step of all series, if it is one.
fn shared_step(here: &[&Series]) -> Option<f64> {
    let first = here.first()?.step_s;
    here.iter().all(|row| row.step_s == first).then_some(first)
}

fn subtitle(scene: &str, shared: Option<f64>) -> String {
    let step = shared.map(|step| format!(" · h = {} s", number::setting(step))).unwrap_or_default();
    format!("{scene} · size of the change since the start, against time{step}")
}

/// What stands at a curve's end: its step, where the curves have different ones, and else the scheme.
fn end_words(series: &Series, shared: Option<f64>) -> String {
    match shared {
        Some(_) => series.scheme.clone(),
        None => format!("h = {} s", number::setting(series.step_s)),
    }
}

fn entries(palette: &Palette, here: &[&Series]) -> Vec<Entry> {
    let shown = palette.schemes().iter().filter(|scheme| here.iter().any(|row| row.scheme == **scheme));
    let mut entries: Vec<Entry> =
        shown.map(|scheme| Entry::new(Sign::Scheme(palette.look(scheme)), *scheme)).collect();
    entries.push(Entry::new(Sign::Filled, "above its start"));
    entries.push(Entry::new(Sign::Hollow, "below its start"));
    entries
}

/// More schemes than these are counted in a title.
const MOST_NAMES: usize = 3;

/// Draws a panel of the series of one quantity.
fn draw_panel(
    sketch: &mut Sketch,
    palette: &Palette,
    (rows, shared): (&[&Series], Option<f64>),
    frame: Frame,
    lowest: bool,
) {
    let curves: Vec<Curve> = rows.iter().map(|row| Curve { series: row, points: envelope(row) }).collect();
    let sizes: Vec<f64> = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1)).collect();
    let times: Vec<f64> = rows.iter().flat_map(|row| row.time_s.iter().copied()).collect();
    let (start, end) = bounds(&times);
    let (low, high) = bounds(&sizes);
    let head = 0.08 * (high - low).max(1.0);
    let y = Axis::logarithmic((low - head).max(high - 16.0), high + head, 6);
    let panel = Panel { frame, x: Axis::linear(start, end, 8), y };
    panel.draw_grid(sketch);
    let ends = curves.iter().filter_map(|curve| {
        let end = draw_curve(sketch, palette, &panel, curve)?;
        Some(Label { words: end_words(curve.series, shared), end, look: palette.look(&curve.series.scheme) })
    });
    let ends: Vec<Label> = ends.collect();
    panel.draw_frame(sketch);
    panel.label_y(sketch);
    labels::draw(sketch, frame, ends);
    panel.title(sketch, &title(rows));
    if lowest {
        panel.label_x(sketch, "time t [s]");
    }
}

fn title(rows: &[&Series]) -> String {
    let Some(row) = rows.first() else { return String::new() };
    let words = survey::quantity_words(&row.quantity);
    let still: Vec<&str> = rows.iter().filter(|row| is_still(row)).map(|row| row.scheme.as_str()).collect();
    let mut title = match row.unit.as_str() {
        "" | "1" => format!("|relative change| of {words}"),
        unit => format!("|change| of {words} [{unit}]"),
    };
    if !still.is_empty() && still.len() < rows.len() {
        let names =
            if still.len() > MOST_NAMES { format!("{} schemes", still.len()) } else { still.join(", ") };
        title += &format!(" (none at all in {names})");
    }
    title
}

/// The largest deviation in each part of the run: an oscillation would else be drawn as a comb of its zeros.
fn envelope(series: &Series) -> Vec<(f64, f64, bool)> {
    let pairs: Vec<(f64, f64)> = series.time_s.iter().copied().zip(series.value.iter().copied()).collect();
    let size = pairs.len().div_ceil(BINS).max(1);
    let largest = |part: &[(f64, f64)]| {
        let moved = part.iter().filter(|(_, value)| value.is_finite() && *value != 0.0);
        moved.copied().reduce(|a, b| if b.1.abs() > a.1.abs() { b } else { a })
    };
    let point = |(time, value): (f64, f64)| (time, value.abs().log10(), value > 0.0);
    pairs.chunks(size).filter_map(largest).map(point).collect()
}

fn draw_curve(sketch: &mut Sketch, palette: &Palette, panel: &Panel, curve: &Curve) -> Option<Place> {
    let look = palette.look(&curve.series.scheme);
    let places: Vec<Place> =
        curve.points.iter().map(|(time, size, _)| panel.place(*time, size.max(panel.y.low))).collect();
    let end = *places.last()?;
    sketch.line(places.clone(), look.ink, 4.0);
    let stride = places.len().div_ceil(MARKERS).max(1);
    for (place, (_, _, above)) in places.iter().zip(&curve.points).skip(stride / 2).step_by(stride) {
        sketch.marker(look.marker, *place, 11.0, look.ink, *above);
    }
    Some(end)
}
