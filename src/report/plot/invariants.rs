//! Per scene: how far what is conserved has moved, and how far energy and angular momentum under a torque are from the reference, against time.

use std::sync::Arc;

use crate::record::{Records, Series};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::key::{Key, Row};
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
/// Roundings of a step in a quantity, each of half a unit in the last place and at worst all of one sign: what n steps change it by is
/// rounding up to ten n of them.
const ROUNDINGS_A_STEP: f64 = 10.0;

/// One scheme's quantity: (time, log₁₀ of its size, true where it is above its start).
struct Curve<'a> {
    series: &'a Series,
    points: Vec<(f64, f64, bool)>,
}

/// The picture; `None` where the scene has no series, or where none is more than rounding.
pub(super) fn sketch(records: &Records, palette: &Palette, scene: &str) -> Option<Sketch> {
    let here: Vec<&Series> =
        records.series.iter().map(Arc::as_ref).filter(|row| row.scene == scene).collect();
    let quantities = survey::distinct(here.iter().map(|row| row.quantity.as_str()));
    let of = |quantity: &str| here.iter().filter(|row| row.quantity == quantity).copied().collect::<Vec<_>>();
    let (still, moving): (Vec<&str>, Vec<&str>) =
        quantities.into_iter().partition(|one| of(one).iter().all(is_still));
    if moving.is_empty() {
        return None;
    }
    let shared = shared_step(&here);
    let (key, entries) = (key(palette, &here, &moving, shared), entries());
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let note = if still.is_empty() { 0.0 } else { NOTE };
    let body = row_height(moving.len()) * moving.len() as f64;
    let strip = key.height(room) + legend::height(&entries, room);
    let height = TOP + body + 100.0 + note + strip + 3.0 * MARGIN;
    let title = survey::title(records, scene);
    let mut sketch = Sketch::new(WIDTH, height, format!("{title}: energy and angular momentum against time"));
    panel::headline(&mut sketch, title, &subtitle(scene, shared));
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom: TOP + body };
    for (index, quantity) in moving.iter().enumerate() {
        let frame = all.cell((1, moving.len()), index).inside(140.0, 62.0, 30.0, 14.0);
        draw_panel(&mut sketch, palette, &of(quantity), frame, index + 1 == moving.len());
    }
    let below = all.bottom + 100.0;
    if !still.is_empty() {
        note_still(&mut sketch, &still, Frame { top: below, bottom: below + note - 20.0, ..all });
    }
    key.draw(&mut sketch, MARGIN + 20.0, below + note, room);
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, below + note + key.height(room) + MARGIN / 2.0, room);
    Some(sketch)
}

fn note_still(sketch: &mut Sketch, still: &[&str], cell: Frame) {
    let names: Vec<String> = still.iter().map(|name| survey::quantity_words(name)).collect();
    let frame = cell.inside(140.0, 0.0, 30.0, 0.0);
    panel::words(sketch, frame, "Changed by rounding alone in every scheme", &[names.join(" · ")]);
}

/// A row a scheme, with the largest value of each quantity.
fn key(palette: &Palette, here: &[&Series], moving: &[&str], shared: Option<f64>) -> Key {
    let row = |scheme: &&str| {
        let own = || here.iter().filter(|row| row.scheme == **scheme);
        let step = own().next()?.step_s;
        let cell = |quantity: &&str| match own().find(|row| row.quantity == **quantity) {
            Some(row) if is_still(row) => "rounding".to_owned(),
            Some(row) => number::joined(&number::significant(largest(row), 2), &row.unit),
            None => number::NONE.to_owned(),
        };
        let name = match shared {
            Some(_) => (*scheme).to_owned(),
            None => format!("{scheme}, h = {} s", number::setting(step)),
        };
        Some(Row { look: palette.look(scheme), name, cells: moving.iter().map(cell).collect() })
    };
    let heads = moving.iter().map(|name| survey::quantity_words(name)).collect();
    Key { heads, rows: palette.schemes().iter().filter_map(row).collect() }
}

/// Height of a panel with its title, so that few panels are not flat and many not endless.
fn row_height(panels: usize) -> f64 {
    (1080.0 / panels.max(1) as f64).clamp(330.0, 620.0)
}

fn largest(series: &Series) -> f64 {
    series.value.iter().filter(|value| value.is_finite()).fold(0.0, |most, value| most.max(value.abs()))
}

/// What roundings may add up to by the end of the run.
fn rounding(series: &Series) -> f64 {
    let steps = series.time_s.last().map_or(0.0, |end| end / series.step_s);
    ROUNDINGS_A_STEP * steps.max(1.0) * f64::EPSILON / 2.0
}

fn is_still(series: &&Series) -> bool {
    largest(series) <= rounding(series)
}

/// The step of all series, if it is one.
fn shared_step(here: &[&Series]) -> Option<f64> {
    let first = here.first()?.step_s;
    here.iter().all(|row| row.step_s == first).then_some(first)
}

fn subtitle(scene: &str, shared: Option<f64>) -> String {
    let step = shared.map(|step| format!(" · h = {} s", number::setting(step))).unwrap_or_default();
    format!("{scene} · against time{step}; below, the largest of each")
}

fn entries() -> Vec<Entry> {
    vec![Entry::new(Sign::Filled, "above"), Entry::new(Sign::Hollow, "below its start, or the reference")]
}

/// Draws a panel of the series of one quantity.
fn draw_panel(sketch: &mut Sketch, palette: &Palette, rows: &[&Series], frame: Frame, lowest: bool) {
    let moving = rows.iter().filter(|row| !is_still(row));
    let curves: Vec<Curve> = moving.map(|row| Curve { series: row, points: envelope(row) }).collect();
    let sizes: Vec<f64> = curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1)).collect();
    let times: Vec<f64> = rows.iter().flat_map(|row| row.time_s.iter().copied()).collect();
    let (start, end) = bounds(&times);
    let (low, high) = bounds(&sizes);
    let floor = rows.iter().map(|row| rounding(row)).fold(f64::INFINITY, f64::min).log10();
    let head = 0.08 * (high - low).max(1.0);
    let y = Axis::logarithmic((low - head).max(floor), high + head, 6);
    let panel = Panel { frame, x: Axis::linear(start, end, 8), y };
    panel.draw_grid(sketch);
    for curve in &curves {
        draw_curve(sketch, palette, &panel, curve);
    }
    panel.draw_frame(sketch);
    panel.label_y(sketch);
    panel.title(sketch, &title(rows));
    if lowest {
        panel.label_x(sketch, "time t [s]");
    }
}

fn title(rows: &[&Series]) -> String {
    let Some(row) = rows.first() else { return String::new() };
    let words = survey::quantity_words(row.quantity.trim_end_matches("-error"));
    let is_error = row.quantity.ends_with("-error");
    match (is_error, row.unit.as_str()) {
        (true, "" | "1") => format!("|error of {words}| against the reference, relative"),
        (true, unit) => format!("error of {words} against the reference [{unit}]"),
        (false, "" | "1") => format!("|relative change| of {words}, which is conserved"),
        (false, unit) => format!("|change| of {words}, which is conserved [{unit}]"),
    }
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

fn draw_curve(sketch: &mut Sketch, palette: &Palette, panel: &Panel, curve: &Curve) {
    let look = palette.look(&curve.series.scheme);
    let seen: Vec<(Place, bool)> = curve
        .points
        .iter()
        .filter(|(_, size, _)| *size >= panel.y.low)
        .map(|(time, size, above)| (panel.place(*time, *size), *above))
        .collect();
    sketch.stroke(seen.iter().map(|(place, _)| *place).collect(), look.ink, 4.0, look.dash);
    let stride = seen.len().div_ceil(MARKERS).max(1);
    for (place, above) in seen.iter().skip(stride / 2).step_by(stride) {
        sketch.marker(look.marker, *place, 10.0, look.ink, *above);
    }
}
