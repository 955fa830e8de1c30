//! How fast the rotational energy drifts, against the step: a panel a scene, step and rate in radians that the body turns, so that scenes of all
//! time scales share their axes. What is rounding, or stays bounded, is no drift and is not drawn.

use std::sync::Arc;

use crate::record::{Drift, DriftClass, Measurement, Records};
use crate::report::html::largest_spin;
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::legend::{self, Entry, Sign};
use super::palette::{INK, Palette};
use super::panel::{self, Frame, Panel};
use super::sketch::{Anchor, Place, Sketch, Type};

const METRIC: &str = "rotational-energy-drift-rate";
const QUANTITY: &str = "rotational-energy";
const MARGIN: f64 = 30.0;
const TOP: f64 = 160.0;
/// Names of scenes over their panels.
const NAME: Type = Type::bold(28.0, INK);
/// Size of a panel, and what stands beside and between panels: numbers of the axes, titles.
const PANEL: (f64, f64) = (580.0, 400.0);
const LEFT: f64 = 120.0;
/// Width of the picture, at least.
const LEAST: f64 = 2200.0;
const HEAD: f64 = 60.0;
const GAP: f64 = 24.0;
const FOOT: f64 = 110.0;

struct Drifting<'a> {
    scene: &'a str,
    curves: Vec<Curve<'a>>,
}

/// The picture; `None` where no scene drifts.
pub(super) fn sketch(records: &Records, palette: &Palette) -> Option<Sketch> {
    let mut drifting = drifting(records);
    if drifting.is_empty() {
        return None;
    }
    let in_radians = turn(records, &mut drifting);
    let columns = drifting.len().clamp(3, 4);
    let rows = drifting.len().div_ceil(columns);
    let (step, unit) = if in_radians { ("radians per step", "1/rad") } else { ("step h [s]", "1/s") };
    let entries = entries(palette, &drifting);
    let width = (LEFT + (PANEL.0 + GAP) * columns as f64 + 2.0 * MARGIN).max(LEAST);
    let strip = legend::height(&entries, width - 2.0 * MARGIN);
    let body = (PANEL.1 + HEAD) * rows as f64 + FOOT;
    let mut sketch = Sketch::new(
        width,
        TOP + body + strip + 2.0 * MARGIN,
        "Drift rate of the rotational energy against the time step".into(),
    );
    let subtitle = format!("|relative drift rate| of the rotational energy [{unit}], with its order in h");
    panel::headline(&mut sketch, "Energy drift", &subtitle);
    let (x, y) = axes(&drifting);
    for (index, one) in drifting.iter().enumerate() {
        let left = MARGIN + LEFT + (PANEL.0 + GAP) * (index % columns) as f64;
        let top = TOP + HEAD + (PANEL.1 + HEAD) * (index / columns) as f64;
        let frame = Frame { left, top, right: left + PANEL.0, bottom: top + PANEL.1 };
        let panel = Panel { frame, x: x.clone(), y: y.clone() };
        draw_panel(&mut sketch, records, palette, one, &panel);
        if index % columns == 0 {
            panel.label_y(&mut sketch);
        }
        if index + columns >= drifting.len() {
            panel.label_x(&mut sketch, step);
        }
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, TOP + body + MARGIN, width - 2.0 * MARGIN);
    Some(sketch)
}

/// Steps and rates over the largest spin of each scene, so that they are radians; false where one is not known, and nothing is changed.
fn turn(records: &Records, drifting: &mut [Drifting]) -> bool {
    let spins: Option<Vec<f64>> = drifting.iter().map(|one| largest_spin(records, one.scene)).collect();
    for (one, spin) in drifting.iter_mut().zip(spins.iter().flatten()) {
        for rung in one.curves.iter_mut().flat_map(|curve| &mut curve.rungs) {
            rung.step += spin.log10();
            rung.error -= spin.log10();
        }
    }
    spins.is_some()
}

fn entries(palette: &Palette, drifting: &[Drifting]) -> Vec<Entry> {
    let drawn =
        |scheme: &str| drifting.iter().flat_map(|one| &one.curves).any(|curve| curve.scheme == scheme);
    let schemes = palette.schemes().iter().filter(|scheme| drawn(scheme));
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
            .filter(|curve| curve.rungs.len() > 1 && drifts(records, scene, curve))
            .collect();
        (!curves.is_empty()).then_some(Drifting { scene, curves })
    };
    survey::scenes(records).into_iter().filter_map(one).collect()
}

/// Whether a curve is a drift: its class says so or, where it has none, its rates have one sign and fall with the step, as roundings do not.
fn drifts(records: &Records, scene: &str, curve: &Curve) -> bool {
    let own = |row: &&Drift| row.scene == scene && row.scheme == curve.scheme && row.quantity == QUANTITY;
    match records.drifts.iter().find(own).map(|row| row.class) {
        Some(DriftClass::Exact | DriftClass::Bounded) => false,
        Some(DriftClass::Secular | DriftClass::Growing) => true,
        Some(DriftClass::Undecided) | None => {
            let Some((finest, coarsest)) = curve.rungs.first().zip(curve.rungs.last()) else { return false };
            let one_sign = curve.rungs.iter().all(|rung| rung.used == finest.used);
            one_sign && finest.error < coarsest.error
        }
    }
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

/// The axes that hold the rates of all scenes.
fn axes(drifting: &[Drifting]) -> (Axis, Axis) {
    let rungs = || drifting.iter().flat_map(|one| &one.curves).flat_map(|curve| &curve.rungs);
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
