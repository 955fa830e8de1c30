//! How fast the rotational energy drifts, against the time step: a panel a scene, each on axes of its own:
//! steps and rates go with the spin, and spins differ by sixteen powers of ten. Scenes whose energy changes by rounding alone are left out.

use std::sync::Arc;

use crate::record::{Drift, DriftClass, Measurement, Records};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::legend::{self, Entry, Sign};
use super::palette::{INK, Palette};
use super::panel::{self, Frame, Panel};
use super::sketch::{Anchor, Place, Sketch, Type};

const METRIC: &str = "rotational-energy-drift-rate";
const LEVEL: &str = "rotational-energy-drift-level";
const QUANTITY: &str = "rotational-energy";
const MARGIN: f64 = 30.0;
const TOP: f64 = 160.0;
/// Names of scenes over their panels.
const NAME: Type = Type::bold(28.0, INK);
const CELL: (f64, f64) = (660.0, 520.0);

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
    let width = (CELL.0 * columns as f64 + 2.0 * MARGIN).max(1700.0);
    let strip = legend::height(&entries, width - 2.0 * MARGIN);
    let body = (CELL.1 * grid.1 as f64).max(700.0);
    let height = TOP + body + strip + 2.0 * MARGIN;
    let mut sketch =
        Sketch::new(width, height, "Drift rate of the rotational energy against the time step".into());
    let subtitle =
        "|relative drift rate| of the rotational energy [1/s] against the step, with its order in h";
    panel::headline(&mut sketch, "Energy drift", subtitle);
    let all = Frame { left: MARGIN, top: TOP, right: width - MARGIN, bottom: TOP + body };
    for (index, one) in drifting.iter().enumerate() {
        let frame = all.cell(grid, index).inside(104.0, 56.0, 10.0, 100.0);
        let (x, y) = axes(one);
        let panel = Panel { frame, x, y };
        draw_panel(&mut sketch, records, palette, one, &panel);
        panel.label_y(&mut sketch);
        panel.label_x(&mut sketch, "step h [s]");
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
    let all: Vec<&Measurement> =
        records.measurements.iter().map(Arc::as_ref).filter(|row| row.metric == METRIC).collect();
    let schemes = survey::schemes(records);
    let one = |scene| {
        let rows: Vec<&Measurement> = all.iter().filter(|row| row.scene == scene).copied().collect();
        let curves: Vec<Curve> = schemes
            .iter()
            .map(|scheme| signed(curves::curve(scheme, &rows, None), &rows))
            .filter(|curve| curve.rungs.len() > 1 && !is_exact(records, scene, curve.scheme))
            .collect();
        (!curves.is_empty()).then_some(Drifting { scene, curves })
    };
    survey::scenes(records).into_iter().filter_map(one).collect()
}

/// Roundings of the energy that are still rounding.
const FEW: f64 = 10.0;

/// Whether what is left of a drift is rounding: in its class, or in the level that the energy moves by at every step.
fn is_exact(records: &Records, scene: &str, scheme: &str) -> bool {
    let level = |row: &&Measurement| row.scene == scene && row.scheme == scheme && row.metric == LEVEL;
    let levels = || records.measurements.iter().map(Arc::as_ref).filter(level);
    let small = |row: &Measurement| row.value.map(f64::abs) <= row.uncertainty.map(|rounding| FEW * rounding);
    if levels().next().is_some() && levels().all(small) {
        return true;
    }
    let exact = |row: &Drift| row.quantity == QUANTITY && row.class == DriftClass::Exact;
    records.drifts.iter().any(|row| row.scene == scene && row.scheme == scheme && exact(row))
}

/// Keeps the rates that are larger than their uncertainty, and marks those that are positive as filled.
fn signed<'a>(mut curve: Curve<'a>, rows: &[&Measurement]) -> Curve<'a> {
    curve.rungs.retain(|rung| rung.error.is_finite() && !rung.lost);
    for rung in &mut curve.rungs {
        let same = |row: &&&Measurement| row.scheme == curve.scheme && row.step_s.log10() == rung.step;
        rung.used = rows.iter().find(same).and_then(|row| row.value).is_some_and(|value| value > 0.0);
    }
    curve
}

/// The part of a panel's width that is left free of curves for the orders.
const FREE: f64 = 0.4;

fn axes(one: &Drifting) -> (Axis, Axis) {
    let rungs = || one.curves.iter().flat_map(|curve| &curve.rungs);
    let (left, right) = bounds(&rungs().map(|rung| rung.step).collect::<Vec<_>>());
    let (low, high) = bounds(&rungs().map(|rung| rung.error).collect::<Vec<_>>());
    let room = (right - left).max(0.5) * FREE / (1.0 - FREE);
    (Axis::logarithmic(left - 0.15 - room, right + 0.15, 4), Axis::logarithmic(low - 0.6, high + 0.6, 6))
}

fn draw_panel(sketch: &mut Sketch, records: &Records, palette: &Palette, one: &Drifting, panel: &Panel) {
    panel.draw_grid(sketch);
    for curve in &one.curves {
        let look = palette.look(curve.scheme);
        let places: Vec<Place> = curve.rungs.iter().map(|rung| panel.place(rung.step, rung.error)).collect();
        sketch.stroke(places.clone(), look.ink, 4.0, look.dash);
        for (place, rung) in places.into_iter().zip(&curve.rungs) {
            sketch.marker(look.marker, place, 10.0, look.ink, rung.used);
        }
    }
    panel.draw_frame(sketch);
    let Frame { left, top, right, .. } = panel.frame;
    let name = panel::fitted(one.scene, NAME, right - left);
    sketch.text(&name, (left, top - 26.0), Anchor::Start, NAME);
    write_orders(sketch, records, palette, one, panel.frame);
}

/// The fitted orders, in the corner that rising curves leave free, each behind the marker of its scheme.
fn write_orders(sketch: &mut Sketch, records: &Records, palette: &Palette, one: &Drifting, frame: Frame) {
    let fits = one.curves.iter().filter_map(|curve| {
        Some((fitted_words(records, one.scene, curve.scheme)?, palette.look(curve.scheme)))
    });
    let fits: Vec<_> = fits.collect();
    for (row, (words, look)) in fits.iter().rev().enumerate() {
        let place = (frame.left + 26.0, frame.bottom - 34.0 - 36.0 * row as f64);
        sketch.marker(look.marker, place, 10.0, look.ink, true);
        sketch.text(words, (place.0 + 20.0, place.1), Anchor::Start, Type::plain(28.0, look.text));
    }
}

fn fitted_words(records: &Records, scene: &str, scheme: &str) -> Option<String> {
    let same = |row: &&Drift| row.scene == scene && row.scheme == scheme && row.quantity == QUANTITY;
    let drift = records.drifts.iter().find(same)?;
    drift.rate_order.map(|_| number::order(drift.rate_order, drift.low, drift.high))
}
