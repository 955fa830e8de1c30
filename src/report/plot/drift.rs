//! How fast the rotational energy drifts, against the time step: a panel a scene, all on the same axes.

use crate::record::{Drift, Measurement, Order, Records};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame, Panel, TITLE};
use super::sketch::{Anchor, Place, Sketch, Type};

const METRIC: &str = "rotational-energy-drift-rate";
const QUANTITY: &str = "rotational-energy";
const MARGIN: f64 = 30.0;
const TOP: f64 = 160.0;
const CELL: (f64, f64) = (640.0, 440.0);

struct Drifting<'a> {
    scene: &'a str,
    curves: Vec<Curve<'a>>,
}

/// The picture; `None` where no scene drifts.
pub(super) fn sketch(records: &Records, palette: &Palette) -> Option<Sketch> {
    let drifting = drifting(records);
    if drifting.is_empty() {
        return None;
    }
    let columns = drifting.len().clamp(3, 4);
    let grid = (columns, drifting.len().div_ceil(columns));
    let entries = entries(palette);
    let width = (CELL.0 * columns as f64 + 2.0 * MARGIN + 120.0).max(1700.0);
    let strip = legend::height(&entries, width - 2.0 * MARGIN);
    let body = (CELL.1 * grid.1 as f64).max(700.0);
    let height = TOP + body + 120.0 + strip + MARGIN;
    let mut sketch = Sketch::new(width, height, "Drift rate of the rotational energy against the time step".into());
    let subtitle = "|relative drift rate| of the rotational energy [1/s] against the step, with its order in h";
    panel::headline(&mut sketch, "Energy drift", subtitle);
    let all = Frame { left: MARGIN + 110.0, top: TOP, right: width - MARGIN, bottom: TOP + body };
    let (x, y) = shared_axes(&drifting);
    for (index, one) in drifting.iter().enumerate() {
        let frame = all.cell(grid, index).inside(10.0, 56.0, 10.0, 10.0);
        let panel = Panel { frame, x: x.clone(), y: y.clone() };
        draw_panel(&mut sketch, records, palette, one, &panel);
        if index % columns == 0 {
            panel.label_y(&mut sketch);
        }
        if index + columns >= drifting.len() {
            panel.label_x(&mut sketch, "step h [s]");
        }
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, height - strip - MARGIN / 2.0, width - 2.0 * MARGIN);
    Some(sketch)
}

fn entries(palette: &Palette) -> Vec<Entry> {
    let schemes = palette.schemes().iter();
    let mut entries: Vec<Entry> =
        schemes.map(|scheme| Entry::new(Sign::Scheme(palette.look(scheme)), *scheme)).collect();
    entries.push(Entry::new(Sign::Filled, "grows"));
    entries.push(Entry::new(Sign::Hollow, "decays"));
    entries
}

/// The scenes with a drift rate that is not zero.
fn drifting(records: &Records) -> Vec<Drifting<'_>> {
    let all: Vec<&Measurement> = records.measurements.iter().filter(|row| row.metric == METRIC).collect();
    let schemes = survey::schemes(records);
    let one = |scene| {
        let rows: Vec<&Measurement> = all.iter().filter(|row| row.scene == scene).copied().collect();
        let curves: Vec<Curve> = schemes
            .iter()
            .map(|scheme| signed(curves::curve(scheme, &rows, None), &rows))
            .filter(|curve| !curve.rungs.is_empty())
            .collect();
        (!curves.is_empty()).then_some(Drifting { scene, curves })
    };
    survey::scenes(records).into_iter().filter_map(one).collect()
}

/// Keeps the rates that are not zero, and marks those that are positive as filled.
fn signed<'a>(mut curve: Curve<'a>, rows: &[&Measurement]) -> Curve<'a> {
    curve.rungs.retain(|rung| rung.error.is_finite());
    for rung in &mut curve.rungs {
        let same = |row: &&&Measurement| row.scheme == curve.scheme && row.step_s.log10() == rung.step;
        rung.used = rows.iter().find(same).and_then(|row| row.value).is_some_and(|value| value > 0.0);
    }
    curve
}

fn shared_axes(drifting: &[Drifting]) -> (Axis, Axis) {
    let rungs = || drifting.iter().flat_map(|one| &one.curves).flat_map(|curve| &curve.rungs);
    let (left, right) = bounds(&rungs().map(|rung| rung.step).collect::<Vec<_>>());
    let (low, high) = bounds(&rungs().map(|rung| rung.error).collect::<Vec<_>>());
    (Axis::logarithmic(left - 0.15, right + 0.15, 5), Axis::logarithmic(low - 0.6, high + 0.6, 6))
}

fn draw_panel(sketch: &mut Sketch, records: &Records, palette: &Palette, one: &Drifting, panel: &Panel) {
    panel.draw_grid(sketch);
    for curve in &one.curves {
        let look = palette.look(curve.scheme);
        let places: Vec<Place> = curve.rungs.iter().map(|rung| panel.place(rung.step, rung.error)).collect();
        sketch.line(places.clone(), look.ink, 4.0);
        for (place, rung) in places.into_iter().zip(&curve.rungs) {
            sketch.marker(look.marker, place, 10.0, look.ink, rung.used);
        }
    }
    panel.draw_frame(sketch);
    let Frame { left, top, right, .. } = panel.frame;
    let mut end = right;
    // The fitted orders stand over the panel, at its right, each in the colour of its scheme.
    for curve in one.curves.iter().rev() {
        let look = palette.look(curve.scheme);
        let Some(words) = fitted_words(records, one.scene, curve.scheme) else { continue };
        let face = Type::bold(28.0, look.text);
        sketch.text(&words, (end, top - 28.0), Anchor::End, face);
        end -= face.width(&words) + 24.0;
    }
    let name = panel::fitted(one.scene, TITLE, end - left);
    sketch.text(&name, (left, top - 28.0), Anchor::Start, TITLE);
}

fn fitted_words(records: &Records, scene: &str, scheme: &str) -> Option<String> {
    let same = |row: &&Drift| row.scene == scene && row.scheme == scheme && row.quantity == QUANTITY;
    let drift = records.drifts.iter().find(same)?;
    let fit = Order { order: drift.rate_order, low: drift.low, high: drift.high, ..Order::default() };
    drift.rate_order.map(|_| number::order(fit.order, fit.low, fit.high))
}
