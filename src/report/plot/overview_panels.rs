//! The two panels of the overview.

use std::sync::Arc;

use crate::quantity::Quantity;
use crate::record::{Measurement, Order, OrderStatus, Records};
use crate::report::{number, survey};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::palette::{BAND, GRID, GUIDE, INK, Palette, tint};
use super::panel::{Frame, Panel, TITLE, fitted};
use super::sketch::{Anchor, Place, Sketch, Type};

/// Between a guide and the nearest curve, log₁₀.
const APART: f64 = 0.25;
/// Room for the name of a guide, log₁₀.
const NAME_OF_GUIDE: f64 = 0.4;
/// How far a column of orders reaches to both sides of its claim.
const REACH: f64 = 0.3;
/// Between two columns of orders.
const COLUMN_GAP: f64 = 40.0;
/// Names of scenes beside their rows, and the room for them.
const NAME: Type = Type::plain(28.0, INK);
const NAME_ROOM: f64 = 540.0;

/// Scenes and the quantity that stands for each.
type Shown<'a> = (&'a [&'a str], &'a str);

/// More schemes than this would cover one another: their errors are drawn in one scene instead of all.
const FEW_SCHEMES: usize = 4;

/// Draws the errors against the step, a colour a scheme: thin lines of all scenes where the schemes are few, and
/// otherwise the first scene under forces.
pub(super) fn draw_errors(
    sketch: &mut Sketch,
    records: &Records,
    palette: &Palette,
    shown: Shown,
    frame: Frame,
) {
    let few = palette.schemes().len() <= FEW_SCHEMES;
    let under_forces =
        |scene: &&&str| records.scenes.iter().any(|row| row.name == ***scene && !row.laws.is_empty());
    let typical = shown.0.iter().find(under_forces).or(shown.0.first()).copied().unwrap_or_default();
    let one = [typical];
    let shown: Shown = if few { shown } else { (&one, shown.1) };
    let spins: Option<Vec<f64>> = shown.0.iter().map(|scene| largest_spin(records, scene)).collect();
    let curves = ladders(records, palette, shown, spins.as_deref());
    let rungs = || curves.iter().flat_map(|curve| &curve.rungs);
    let (left, right) = bounds(&rungs().map(|rung| rung.step).collect::<Vec<_>>());
    let errors: Vec<f64> = rungs().map(|rung| rung.error).filter(|error| error.is_finite()).collect();
    let (low, high) = bounds(&errors);
    let (x, y) = (Axis::logarithmic(left - 0.1, right + 0.1, 6), Axis::logarithmic(low - 0.5, high + 0.5, 8));
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
    for (index, order) in whole_orders(records, palette).into_iter().enumerate() {
        draw_guide(sketch, &panel, &curves, (order, index == 0));
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, if spins.is_some() { "step h × largest Ω [rad]" } else { "step h [s]" });
    panel.label_y(sketch);
    let unit = records
        .orders
        .iter()
        .find(|row| row.quantity == survey::base(shown.1))
        .map_or("rad", |row| row.unit.as_str());
    let words = survey::quantity_words(shown.1);
    let which = if few { "a line a scene" } else { typical };
    panel.title(sketch, &format!("Error in {words} at the end [{unit}], {which}"));
}

/// The largest |Ω| of the reference [rad/s]; `None` without evidence, and where nothing turns.
fn largest_spin(records: &Records, scene: &str) -> Option<f64> {
    let own = records.evidence.iter().find(|evidence| evidence.scene == scene)?;
    Some(own.ladder.sizes[Quantity::AngularVelocity]).filter(|spin| *spin > 0.0)
}

/// The ladders of every scheme; with the spins of the scenes their steps are in radians, so that scenes fall on one another.
fn ladders<'a>(
    records: &'a Records,
    palette: &Palette<'a>,
    (scenes, quantity): Shown,
    spins: Option<&[f64]>,
) -> Vec<Curve<'a>> {
    let of_scene = |(index, scene): (usize, &&str)| {
        let here = |row: &&Measurement| row.scene == **scene && row.metric == quantity;
        let rows: Vec<&Measurement> = records.measurements.iter().map(Arc::as_ref).filter(here).collect();
        let fit = |scheme| survey::order(records, scene, scheme, quantity);
        let turned = spins.map_or(0.0, |spins| spins[index].log10());
        let curve = |name| {
            let mut curve = curves::curve(name, &rows, fit(name));
            curve.rungs.iter_mut().for_each(|rung| rung.step += turned);
            curve
        };
        palette.schemes().iter().map(|name| curve(name)).collect::<Vec<Curve>>()
    };
    // A curve at rounding level is flat and says nothing about an order.
    scenes.iter().enumerate().flat_map(of_scene).filter(|curve| !curve.is_exact()).collect()
}

/// The claimed orders, each once.
fn whole_orders(records: &Records, palette: &Palette) -> Vec<u32> {
    let claimed = palette.schemes().iter().filter_map(|scheme| survey::claimed_order(records, scheme));
    let mut orders: Vec<u32> = claimed.collect();
    orders.sort_unstable();
    orders.dedup();
    orders
}

/// A guide of one order: over the fitted points of the lowest order, under those of the others, so that it crosses
/// as few curves as it can.
fn draw_guide(sketch: &mut Sketch, panel: &Panel, curves: &[Curve], (order, above): (u32, bool)) {
    let slope = f64::from(order);
    let rounds = |measured: f64| measured.round() as u32 == order;
    let of_order = |curve: &&Curve| curve.order.and_then(|fit| fit.order).is_some_and(rounds);
    let used = curves.iter().filter(of_order).flat_map(|curve| curve.rungs.iter().filter(|rung| rung.used));
    let used: Vec<_> = used.filter(|rung| rung.error.is_finite()).collect();
    let heights: Vec<f64> = used.iter().map(|rung| rung.error - slope * rung.step).collect();
    let (lowest, highest) = bounds(&heights);
    let (from, to) = bounds(&used.iter().map(|rung| rung.step).collect::<Vec<_>>());
    // A third of its length stays in the panel with its name, though it crosses what lies apart from the other curves.
    let most = panel.y.high - NAME_OF_GUIDE - slope * (from + (to - from) / 3.0);
    let offset = if above { (highest + APART).min(most) } else { lowest - APART };
    let from = from.max((panel.y.low - offset) / slope);
    let to = to.min((panel.y.high - NAME_OF_GUIDE - offset) / slope);
    if used.is_empty() || to <= from {
        return;
    }
    let at = |step: f64| panel.place(step, offset + slope * step);
    sketch.dashes(at(from), at(to), GUIDE, 4.0);
    let words = if order == 1 { "h".to_string() } else { format!("h{}", number::superscript(order as i32)) };
    let (x, y) = at((from + to) / 2.0);
    let place = if above { (x - 24.0, y - 30.0) } else { (x + 30.0, y + 30.0) };
    sketch.text(&words, place, Anchor::Middle, Type::bold(32.0, INK));
}

/// Draws every measured order with its interval: a row a scene, a column and a band a claimed order.
pub(super) fn draw_orders(
    sketch: &mut Sketch,
    records: &Records,
    palette: &Palette,
    shown: Shown,
    frame: Frame,
) {
    let (scenes, _) = shown;
    let claims = whole_orders(records, palette);
    let rows = Axis { low: scenes.len() as f64 - 0.5, high: -0.5, labels: Vec::new(), ticks: Vec::new() };
    for (column, claim) in claims.iter().enumerate() {
        let claimed = f64::from(*claim);
        let cell = frame.cell((claims.len(), 1), column);
        let frame = cell.inside(if column == 0 { 0.0 } else { COLUMN_GAP }, 0.0, 0.0, 0.0);
        let x = Axis::linear(claimed - REACH, claimed + REACH, 4);
        let panel = Panel { frame, x, y: rows.clone() };
        let (left, right) = (panel.across(claimed - 0.15), panel.across(claimed + 0.15));
        sketch.area((left, frame.top), (right, frame.bottom), BAND);
        panel.draw_grid(sketch);
        draw_column(sketch, records, palette, shown, (&panel, *claim));
        panel.draw_frame(sketch);
        panel.label_x(sketch, "order");
    }
    for (row, scene) in scenes.iter().enumerate() {
        let part = (row as f64 + 0.5) / scenes.len() as f64;
        let place = (frame.left - 20.0, frame.top + part * (frame.bottom - frame.top));
        sketch.text(&fitted(scene, NAME, NAME_ROOM), place, Anchor::End, NAME);
    }
    let place = (frame.left, frame.top - 30.0);
    sketch.text("Measured order with its bounds, a row a scene", place, Anchor::Start, TITLE);
}

/// Draws the orders of the schemes that make one claim.
fn draw_column(
    sketch: &mut Sketch,
    records: &Records,
    palette: &Palette,
    shown: Shown,
    column: (&Panel, u32),
) {
    let ((scenes, quantity), (panel, claim)) = (shown, column);
    for (row, scene) in scenes.iter().enumerate() {
        let y = panel.along(row as f64);
        sketch.line(vec![(panel.frame.left, y), (panel.frame.right, y)], GRID, 2.0);
        let here = |order: &&Order| {
            let claimed = survey::claimed_order(records, &order.scheme) == Some(claim);
            claimed && order.scene == *scene && order.status == OrderStatus::Decided
        };
        // The quantity that stands for the scene comes last and so lies on top.
        let mut orders: Vec<&Order> = records.orders.iter().filter(here).collect();
        orders.sort_by_key(|order| order.quantity == survey::base(quantity));
        for order in orders {
            draw_order(sketch, palette, panel, (order, row), order.quantity == survey::base(quantity));
        }
    }
}

/// A dot and its whisker; an order outside the panel stands hollow on its edge.
fn draw_order(
    sketch: &mut Sketch,
    palette: &Palette,
    panel: &Panel,
    (order, row): (&Order, usize),
    main: bool,
) {
    let Some(value) = order.order else { return };
    let look = palette.look(&order.scheme);
    let across = |value: f64| panel.across(value.clamp(panel.x.low, panel.x.high));
    let y = panel.along(row as f64);
    let (radius, width) = if main { (11.0, 6.0) } else { (5.0, 2.0) };
    let ink = if main { look.ink } else { tint(look.ink, 0.55) };
    if let (Some(low), Some(high)) = (order.low, order.high) {
        sketch.line(vec![(across(low), y), (across(high), y)], ink, width);
    }
    let inside = (panel.x.low..=panel.x.high).contains(&value);
    sketch.marker(look.marker, (across(value), y), radius, ink, inside || !main);
}
