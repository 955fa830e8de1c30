//! One panel of a convergence picture: one quantity, every scheme.

use crate::record::OrderStatus;
use crate::report::{number, survey};

use super::axis::Axis;
use super::curves::{Curve, Quantity};
use super::palette::{BAND, Palette};
use super::panel::{Frame, Panel, TICK};
use super::sketch::{Anchor, Place, Sketch};
use super::slopes;

const RADIUS: f64 = 11.0;
/// A floor so many decades below the smallest error, or nearer, is drawn.
const FLOOR_IN_SIGHT: f64 = 3.0;

/// Draws the panel into a cell.
pub(super) fn draw(sketch: &mut Sketch, palette: &Palette, quantity: &Quantity, cell: Frame) {
    let panel = axes(quantity, cell.inside(128.0, 66.0, 26.0, 110.0));
    panel.draw_grid(sketch);
    draw_floor(sketch, &panel, quantity);
    let lines: Vec<Vec<Place>> = quantity.curves.iter().map(|curve| places(&panel, curve)).collect();
    slopes::draw(sketch, &panel, &lines, &quantity.guide_orders());
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
        // Without its unit, which stands above the frame, it leaves the middle to the name of the step; inside the frame stand curves and slopes.
        let words = format!("↓ floor {}", number::significant(10f64.powf(floor), 1));
        sketch.text(&words, (right, bottom + 72.0), Anchor::End, TICK);
    }
}

/// The places of a curve's points; an error of zero stands on the lower edge.
fn places(panel: &Panel, curve: &Curve) -> Vec<Place> {
    curve.rungs.iter().map(|rung| panel.place(rung.step, rung.error.max(panel.y.low))).collect()
}

fn draw_curve(sketch: &mut Sketch, palette: &Palette, panel: &Panel, curve: &Curve) {
    let look = palette.look(curve.scheme);
    let places = places(panel, curve);
    sketch.stroke(places.clone(), look.ink, 4.0, look.dash);
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

/// What stands beside the name of a scheme: its order with the bounds, or why it has none.
pub(super) fn label_words(curve: &Curve) -> String {
    match curve.order {
        Some(fit) if fit.status == OrderStatus::Decided => number::order(fit.order, fit.low, fit.high),
        Some(fit) => fit.status.word().replace('-', " "),
        None => "no order".into(),
    }
}
