//! The two panels of the overview.

use crate::record::{Measurement, Order, Records};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::palette::{BAND, GRID, GUIDE, INK, Palette, tint};
use super::panel::{Frame, Panel, TICK, fitted};
use super::sketch::{Anchor, Place, Sketch, Type};

/// Scenes and the quantity that stands for each.
type Shown<'a> = (&'a [&'a str], &'a str);

/// Draws the errors of all scenes against the step: thin lines, a colour a scheme.
pub(super) fn draw_errors(sketch: &mut Sketch, records: &Records, palette: &Palette, shown: Shown, frame: Frame) {
    let curves = ladders(records, palette, shown);
    let rungs = || curves.iter().flat_map(|curve| &curve.rungs);
    let (left, right) = bounds(&rungs().map(|rung| rung.step).collect::<Vec<_>>());
    let errors: Vec<f64> = rungs().map(|rung| rung.error).filter(|error| error.is_finite()).collect();
    let (low, high) = bounds(&errors);
    let (x, y) = (Axis::logarithmic(left - 0.1, right + 0.1, 6), Axis::logarithmic(low - 0.4, high + 0.4, 8));
    let panel = Panel { frame, x, y };
    panel.draw_grid(sketch);
    for curve in &curves {
        let look = palette.look(curve.scheme);
        let places: Vec<Place> = curve
            .rungs
            .iter()
            .filter(|rung| rung.error.is_finite())
            .map(|rung| panel.place(rung.step, rung.error))
            .collect();
        sketch.line(places.clone(), tint(look.ink, 0.75), 3.0);
        for place in places {
            sketch.marker(look.marker, place, 6.0, look.ink, true);
        }
    }
    for order in whole_orders(records, palette) {
        draw_guide(sketch, &panel, &curves, order);
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, "step h [s]");
    panel.label_y(sketch);
    let unit = records.orders.iter().find(|row| row.quantity == shown.1).map_or("rad", |row| row.unit.as_str());
    let words = survey::quantity_words(shown.1);
    panel.title(sketch, &format!("Error in {words} at the end [{unit}], a line a scene"));
}

fn ladders<'a>(records: &'a Records, palette: &Palette<'a>, (scenes, quantity): Shown) -> Vec<Curve<'a>> {
    let of_scene = |scene: &&str| {
        let here = |row: &&Measurement| row.scene == **scene && row.metric == quantity;
        let rows: Vec<&Measurement> = records.measurements.iter().filter(here).collect();
        let fit = |scheme| survey::order(records, scene, scheme, quantity);
        let all: Vec<Curve> = palette.schemes().iter().map(|name| curves::curve(name, &rows, fit(name))).collect();
        all
    };
    // A curve at rounding level is flat and says nothing about an order.
    scenes.iter().flat_map(of_scene).filter(|curve| !curve.is_exact()).collect()
}

/// The claimed orders, each once.
fn whole_orders(records: &Records, palette: &Palette) -> Vec<u32> {
    let claimed = palette.schemes().iter().filter_map(|scheme| survey::claimed_order(records, scheme));
    let mut orders: Vec<u32> = claimed.collect();
    orders.sort_unstable();
    orders.dedup();
    orders
}

/// A guide under all fitted points of the curves of one order.
fn draw_guide(sketch: &mut Sketch, panel: &Panel, curves: &[Curve], order: u32) {
    let slope = f64::from(order);
    let of_order = |curve: &&Curve| {
        curve.order.and_then(|fit| fit.order).is_some_and(|measured| measured.round() as u32 == order)
    };
    let used = curves.iter().filter(of_order).flat_map(|curve| curve.rungs.iter().filter(|rung| rung.used));
    let used: Vec<_> = used.filter(|rung| rung.error.is_finite()).collect();
    let heights = used.iter().map(|rung| rung.error - slope * rung.step);
    let Some(lowest) = heights.reduce(f64::min) else { return };
    let height = |x: f64| lowest - 0.25 + slope * x;
    let (from, to) = bounds(&used.iter().map(|rung| rung.step).collect::<Vec<_>>());
    let enter = from.max((panel.y.low - lowest + 0.25) / slope);
    if to <= enter {
        return;
    }
    sketch.dashes(panel.place(enter, height(enter)), panel.place(to, height(to)), GUIDE, 4.0);
    let words = if order == 1 { "h".to_string() } else { format!("h{}", number::superscript(order as i32)) };
    let (x, y) = panel.place(to, height(to));
    let face = Type::bold(32.0, INK);
    let place = (x - 14.0, (y + 34.0).min(panel.frame.bottom - 24.0));
    sketch.text(&words, place, Anchor::Middle, face);
}

/// Draws every measured order with its interval: a row a scene, a band a claim.
pub(super) fn draw_orders(sketch: &mut Sketch, records: &Records, palette: &Palette, shown: Shown, frame: Frame) {
    let (scenes, quantity) = shown;
    let claims = whole_orders(records, palette);
    let least = claims.first().map_or(0.5, |order| f64::from(*order) - 0.5);
    let most = claims.last().map_or(2.5, |order| f64::from(*order) + 0.5);
    let y = Axis { low: scenes.len() as f64 - 0.5, high: -0.5, labels: Vec::new(), ticks: Vec::new() };
    let panel = Panel { frame, x: Axis::linear(least, most, 5), y };
    for claim in &claims {
        let (left, right) = (panel.across(f64::from(*claim) - 0.15), panel.across(f64::from(*claim) + 0.15));
        sketch.area((left, frame.top), (right, frame.bottom), BAND);
    }
    panel.draw_grid(sketch);
    for (row, scene) in scenes.iter().enumerate() {
        let y = panel.along(row as f64);
        sketch.line(vec![(frame.left, y), (frame.right, y)], GRID, 2.0);
        let name = fitted(scene, TICK, 460.0);
        sketch.text(&name, (frame.left - 20.0, y), Anchor::End, Type::plain(28.0, INK));
        for order in records.orders.iter().filter(|order| order.scene == *scene && order.status == "fitted") {
            draw_order(sketch, palette, &panel, (order, row), order.quantity == quantity);
        }
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, "order of convergence (95 % interval)");
    panel.title(sketch, "Measured order, a row a scene");
}

/// A dot and its whisker; schemes stand one above another within the row.
fn draw_order(sketch: &mut Sketch, palette: &Palette, panel: &Panel, (order, row): (&Order, usize), main: bool) {
    let Some(value) = order.order else { return };
    let look = palette.look(&order.scheme);
    let inside = |value: f64| panel.across(value.clamp(panel.x.low, panel.x.high));
    let y = panel.along(row as f64);
    let (radius, width) = if main { (11.0, 5.0) } else { (4.5, 2.0) };
    let ink = if main { look.ink } else { tint(look.ink, 0.6) };
    if let (Some(low), Some(high)) = (order.low, order.high) {
        sketch.line(vec![(inside(low), y), (inside(high), y)], ink, width);
    }
    sketch.marker(look.marker, (inside(value), y), radius, ink, true);
}
