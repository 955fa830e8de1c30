//! One panel of a convergence picture: one quantity, every scheme.

use crate::record::OrderStatus;
use crate::report::{number, survey};

use super::axis::Axis;
use super::curves::{Curve, Quantity};
use super::labels::{self, Label};
use super::palette::{BAND, GUIDE, Palette};
use super::panel::{Frame, Panel, TICK};
use super::sketch::{Anchor, Place, Sketch};

const RADIUS: f64 = 12.0;
/// A floor so many decades below the smallest error, or nearer, is drawn.
const FLOOR_IN_SIGHT: f64 = 3.0;
/// How far a guide runs below its curve.
const GUIDE_DROP: f64 = 40.0;

/// Draws the panel into a cell, with a column at its right for the labels.
pub(super) fn draw(sketch: &mut Sketch, palette: &Palette, quantity: &Quantity, cell: Frame, column: f64) {
    let frame = cell.inside(128.0, 66.0, column, 110.0);
    let panel = axes(quantity, frame);
    panel.draw_grid(sketch);
    draw_floor(sketch, &panel, quantity);
    for order in quantity.guide_orders() {
        draw_guide(sketch, &panel, quantity, order);
    }
    for curve in &quantity.curves {
        draw_curve(sketch, palette, &panel, curve);
    }
    panel.draw_frame(sketch);
    for (row, curve) in quantity.curves.iter().filter(|curve| !curve.broken.is_empty()).enumerate() {
        draw_broken(sketch, palette, &panel, curve, row);
    }
    panel.label_x(sketch, "step h [s]");
    panel.label_y(sketch);
    panel.title(sketch, &title(quantity));
    let ends = quantity.curves.iter().filter_map(|curve| label(palette, &panel, curve)).collect();
    labels::list(sketch, frame, ends);
}

fn title(quantity: &Quantity) -> String {
    let words = survey::quantity_words(quantity.name);
    let unit = if quantity.unit.is_empty() { "1" } else { quantity.unit };
    format!("{} error [{unit}]", survey::capital(&words))
}

fn axes(quantity: &Quantity, frame: Frame) -> Panel {
    let rungs = || quantity.curves.iter().flat_map(|curve| &curve.rungs);
    let broken = quantity.curves.iter().flat_map(|curve| &curve.broken).copied();
    let steps: Vec<f64> = rungs().map(|rung| rung.step).chain(broken).collect();
    let errors: Vec<f64> = rungs().map(|rung| rung.error).filter(|error| error.is_finite()).collect();
    let (left, right) = bounds(&steps);
    let (mut low, high) = bounds(&errors);
    if let Some(floor) = quantity.floor().filter(|floor| *floor < low) {
        // A floor just below the errors is shown; one far below would squeeze the curves and is told in words.
        low = if low - floor < FLOOR_IN_SIGHT { floor - 0.3 } else { low };
    }
    let broken_schemes = quantity.curves.iter().filter(|curve| !curve.broken.is_empty()).count();
    let head = (0.07 + 0.05 * broken_schemes as f64) * (high - low).max(1.0);
    Panel {
        frame,
        x: Axis::logarithmic(left - 0.12, right + 0.12, 5),
        y: Axis::logarithmic(low - 0.1 * (high - low).max(1.0), high + head, 7),
    }
}

/// The least and the greatest of some numbers; 0 twice where there are none.
pub(super) fn bounds(values: &[f64]) -> (f64, f64) {
    let low = values.iter().copied().reduce(f64::min).unwrap_or(0.0);
    let high = values.iter().copied().reduce(f64::max).unwrap_or(0.0);
    (low, high)
}

fn draw_floor(sketch: &mut Sketch, panel: &Panel, quantity: &Quantity) {
    let Some(floor) = quantity.floor() else { return };
    let Frame { left, right, bottom, .. } = panel.frame;
    if floor > panel.y.low {
        let top = panel.along(floor.min(panel.y.high));
        sketch.area((left, top), (right, bottom), BAND);
    } else {
        let level = number::joined(&number::significant(10f64.powf(floor), 1), quantity.unit);
        let words = format!("↓ floor {level}");
        sketch.text(&words, (right - 16.0, bottom - 36.0), Anchor::End, TICK);
    }
}

/// A line of slope `order` under the first curve whose measured order rounds to it.
fn draw_guide(sketch: &mut Sketch, panel: &Panel, quantity: &Quantity, order: i32) {
    let rounds =
        |curve: &&Curve| curve.order.and_then(|fit| fit.order).is_some_and(|p| p.round() as i32 == order);
    let Some(curve) = quantity.curves.iter().find(rounds) else { return };
    let used: Vec<_> = curve.rungs.iter().filter(|rung| rung.used && rung.error.is_finite()).collect();
    let (Some(first), Some(last)) = (used.first(), used.last()) else { return };
    let slope = f64::from(order);
    let mean =
        |part: fn(&super::curves::Rung) -> f64| used.iter().map(|r| part(r)).sum::<f64>() / used.len() as f64;
    let (step, error) = (mean(|rung| rung.step), mean(|rung| rung.error));
    let drop = GUIDE_DROP / (panel.frame.bottom - panel.frame.top) * (panel.y.high - panel.y.low);
    let height = |x: f64| error - drop + slope * (x - step);
    // The part of the guide that lies inside the frame.
    let enter = step + (panel.y.low - error + drop) / slope;
    let (from, to) = (first.step.max(enter), last.step);
    if to <= from {
        return;
    }
    let (from, to) = (panel.place(from, height(from)), panel.place(to, height(to)));
    sketch.dashes(from, to, GUIDE, 3.0);
    name_guide(sketch, panel, quantity, (from, to), order);
}

/// Writes the power under the guide's middle where no curve runs.
fn name_guide(
    sketch: &mut Sketch,
    panel: &Panel,
    quantity: &Quantity,
    (from, to): (Place, Place),
    order: i32,
) {
    let words = if order == 1 { "h".to_string() } else { format!("h{}", number::superscript(order)) };
    for part in [0.5, 0.3, 0.7, 0.15] {
        let on = (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1));
        let place = (on.0 + 24.0, on.1 + 22.0);
        let inside = place.1 < panel.frame.bottom - 20.0 && place.0 < panel.frame.right - 30.0;
        if inside && quantity.curves.iter().all(|curve| clear_of(panel, curve, place)) {
            sketch.text(&words, place, Anchor::Middle, TICK);
            return;
        }
    }
}

/// True where no segment of the curve comes near the place.
fn clear_of(panel: &Panel, curve: &Curve, (x, y): Place) -> bool {
    const NEAR: f64 = 34.0;
    places(panel, curve).windows(2).all(|pair| {
        let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
        let length = (x1 - x0).powi(2) + (y1 - y0).powi(2);
        let part = (((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length.max(1e-9)).clamp(0.0, 1.0);
        (x0 + part * (x1 - x0) - x).hypot(y0 + part * (y1 - y0) - y) > NEAR
    })
}

/// The places of a curve's points; an error of zero stands on the lower edge.
fn places(panel: &Panel, curve: &Curve) -> Vec<Place> {
    curve.rungs.iter().map(|rung| panel.place(rung.step, rung.error.max(panel.y.low))).collect()
}

fn draw_curve(sketch: &mut Sketch, palette: &Palette, panel: &Panel, curve: &Curve) {
    let look = palette.look(curve.scheme);
    let places = places(panel, curve);
    sketch.line(places.clone(), look.ink, 5.0);
    for (place, rung) in places.into_iter().zip(&curve.rungs) {
        sketch.marker(look.marker, place, RADIUS, look.ink, rung.used);
    }
}

/// A cross at the upper edge at the step that broke; those of several schemes stand one under another.
fn draw_broken(sketch: &mut Sketch, palette: &Palette, panel: &Panel, curve: &Curve, row: usize) {
    for step in &curve.broken {
        let place = (panel.across(*step), panel.frame.top + 18.0 + 26.0 * row as f64);
        sketch.cross(place, RADIUS - 3.0, palette.look(curve.scheme).ink);
    }
}

fn label(palette: &Palette, panel: &Panel, curve: &Curve) -> Option<Label> {
    let finest = curve.rungs.first()?;
    let end = panel.place(finest.step, finest.error.max(panel.y.low));
    Some(Label { words: label_words(curve), end, look: palette.look(curve.scheme) })
}

/// What stands beside a curve: its order with the bounds, or why it has none.
pub(super) fn label_words(curve: &Curve) -> String {
    match curve.order {
        Some(fit) if fit.status == OrderStatus::Decided => number::order(fit.order, fit.low, fit.high),
        Some(fit) => fit.status.word().replace('-', " "),
        None => "no order".into(),
    }
}
