//! The right panel of the overview: a dot for each measured order, a row a scene and a column a scheme, over the band of its claim.

use crate::record::{Order, OrderStatus, Records};
use crate::report::survey;

use super::axis::Axis;
use super::overview_panels::NAME;
use super::palette::{BAND, GRID, Palette, SOFT, tint};
use super::panel::{AXIS, Frame, Panel, TITLE, fitted};
use super::sketch::{Anchor, Sketch, Type};

/// How far a column of orders reaches to both sides of its claim.
const REACH: f64 = 0.3;
/// Half the width of the band: the bounds of a decided order are inside it.
const BAND_HALF: f64 = 0.15;
/// Between two columns.
const GAP: f64 = 12.0;
/// The word in cells without an order.
const EXACT: Type = Type::plain(24.0, SOFT);
/// What stands there where a column has no room for the word.
const EXACT_SIGN: &str = "=";
/// Room for the names of scenes that holds the title of the panel, too.
pub(super) const NAME_ROOM: f64 = 580.0;

/// Scenes, schemes with their claims, and the quantity that stands for a scene.
type Shown<'a> = (&'a [&'a str], &'a [(&'a str, u32)], &'a str);

/// Draws every measured order with its bounds, and the names of the scenes in a room left of the frame.
pub(super) fn draw(
    sketch: &mut Sketch,
    records: &Records,
    palette: &Palette,
    (scenes, columns, quantity): Shown,
    (frame, names): (Frame, f64),
) {
    let row =
        |index: usize| frame.top + (index as f64 + 0.5) / scenes.len() as f64 * (frame.bottom - frame.top);
    for (index, scene) in scenes.iter().enumerate() {
        sketch.text(&fitted(scene, NAME, names), (frame.left - 20.0, row(index)), Anchor::End, NAME);
    }
    for (index, (scheme, claim)) in columns.iter().enumerate() {
        let claimed = f64::from(*claim);
        let column = frame.cell((columns.len(), 1), index).inside(GAP / 2.0, 0.0, GAP / 2.0, 0.0);
        let x = Axis { low: claimed - REACH, high: claimed + REACH, labels: Vec::new(), ticks: Vec::new() };
        let y = Axis { low: scenes.len() as f64 - 0.5, high: -0.5, labels: Vec::new(), ticks: Vec::new() };
        let panel = Panel { frame: column, x, y };
        let (left, right) = (panel.across(claimed - BAND_HALF), panel.across(claimed + BAND_HALF));
        sketch.area((left, column.top), (right, column.bottom), BAND);
        let middle = panel.across(claimed);
        sketch.line(vec![(middle, column.top), (middle, column.bottom)], GRID, 2.0);
        for (index, scene) in scenes.iter().enumerate() {
            let y = row(index);
            sketch.line(vec![(column.left, y), (column.right, y)], GRID, 2.0);
            draw_cell(sketch, records, palette, (&panel, y), (scene, scheme, quantity));
        }
        sketch.outline(column.low(), column.high(), SOFT, 2.0);
        sketch.upright(scheme, (middle, column.top - 16.0), NAME);
        let claims = claims(records, scenes, scheme, *claim);
        sketch.text(&claims, (middle, column.bottom + 30.0), Anchor::Middle, NAME);
    }
    let middle = (frame.left + frame.right) / 2.0;
    let whole = names >= NAME_ROOM;
    let words =
        if whole { "claimed order; two where it is another one without torque" } else { "claimed order" };
    sketch.text(words, (middle, frame.bottom + 74.0), Anchor::Middle, AXIS);
    if !whole {
        return;
    }
    let place = (frame.left - NAME_ROOM - 20.0, frame.top - 30.0);
    sketch.text("Measured order with its bounds", place, Anchor::Start, TITLE);
}

/// The orders of one scheme in one scene; the quantity that stands for the scene comes last and so lies on top.
fn draw_cell(
    sketch: &mut Sketch,
    records: &Records,
    palette: &Palette,
    (panel, y): (&Panel, f64),
    (scene, scheme, quantity): (&str, &str, &str),
) {
    let here = |order: &&Order| {
        order.scene == scene && order.scheme == scheme && order.status == OrderStatus::Decided
    };
    let is_main = |order: &&Order| order.quantity == survey::base(quantity);
    let mut orders: Vec<&Order> = records.orders.iter().filter(here).collect();
    orders.sort_by_key(is_main);
    let claim =
        claim_in(records, scene, scheme).or(survey::claimed_order(records, scheme)).unwrap_or_default();
    let more = f64::from(claim) - (panel.x.low + panel.x.high) / 2.0;
    if !orders.last().is_some_and(is_main) && is_exact(records, (scene, scheme, quantity)) {
        write_exact(sketch, panel, y);
    }
    for order in orders {
        draw_order(sketch, palette, (panel, y), (order, more), is_main(&order));
    }
}

fn is_exact(records: &Records, (scene, scheme, quantity): (&str, &str, &str)) -> bool {
    survey::order(records, scene, scheme, quantity).is_some_and(|order| order.status == OrderStatus::Exact)
}

/// The word where an error is rounding at every step, or its sign.
fn write_exact(sketch: &mut Sketch, panel: &Panel, y: f64) {
    let Frame { left, right, .. } = panel.frame;
    let words = if EXACT.width("exact") < right - left { "exact" } else { EXACT_SIGN };
    sketch.text(words, ((left + right) / 2.0, y), Anchor::Middle, EXACT);
}

/// The order that a scheme claims in a scene: some claim another one without torque.
fn claim_in(records: &Records, scene: &str, scheme: &str) -> Option<u32> {
    let own = records.evidence.iter().find(|row| row.scene == scene && row.scheme == scheme)?;
    Some(own.order()).filter(|order| *order > 0)
}

/// The claims of a scheme over all scenes: `2`, or `2, 4`.
fn claims(records: &Records, scenes: &[&str], scheme: &str, claim: u32) -> String {
    let mut all: Vec<u32> = scenes.iter().filter_map(|scene| claim_in(records, scene, scheme)).collect();
    all.push(claim);
    all.sort_unstable();
    all.dedup();
    all.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

/// A dot and its whisker; an order outside the panel stands hollow on its edge. `more` is how much more is claimed in the scene than in the column.
fn draw_order(
    sketch: &mut Sketch,
    palette: &Palette,
    (panel, y): (&Panel, f64),
    (order, more): (&Order, f64),
    main: bool,
) {
    let Some(value) = order.order.map(|value| value - more) else { return };
    let look = palette.look(&order.scheme);
    let across = |value: f64| panel.across(value.clamp(panel.x.low, panel.x.high));
    let (radius, width) = if main { (10.0, 6.0) } else { (5.0, 2.0) };
    let ink = if main { look.ink } else { tint(look.ink, 0.55) };
    if let (Some(low), Some(high)) = (order.low, order.high) {
        sketch.line(vec![(across(low - more), y), (across(high - more), y)], ink, width);
    }
    let inside = (panel.x.low..=panel.x.high).contains(&value);
    sketch.marker(look.marker, (across(value), y), radius, ink, inside || !main);
}
