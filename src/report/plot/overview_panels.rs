//! The left panel of the overview: errors against the step.

use std::sync::Arc;

use crate::record::{Measurement, Records};
use crate::report::html::largest_spin;
use crate::report::survey;

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::curves::{self, Curve};
use super::palette::{INK, Palette};
use super::panel::{Frame, Panel};
use super::sketch::{Place, Sketch, Type};
use super::slopes;

/// Names of scenes and schemes.
pub(super) const NAME: Type = Type::plain(28.0, INK);

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
    let panel = axes(&curves, frame);
    panel.draw_grid(sketch);
    let places = |curve: &Curve| {
        let whole = curve.rungs.iter().filter(|rung| rung.error.is_finite());
        whole.map(|rung| panel.place(rung.step, rung.error)).collect::<Vec<Place>>()
    };
    let lines: Vec<Vec<Place>> = curves.iter().map(places).collect();
    slopes::draw(sketch, &panel, &lines, &whole_orders(records, palette));
    for (curve, line) in curves.iter().zip(lines) {
        let look = palette.look(curve.scheme);
        sketch.stroke(line.clone(), look.ink, 4.0, look.dash);
        for place in line {
            sketch.marker(look.marker, place, 7.0, look.ink, true);
        }
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, if spins.is_some() { "radians per step" } else { "step h [s]" });
    panel.label_y(sketch);
    panel.title(sketch, &title(records, shown.1, if few { "a line a scene" } else { typical }));
}

fn title(records: &Records, quantity: &str, which: &str) -> String {
    let own = records.orders.iter().find(|row| row.quantity == survey::base(quantity));
    let unit = own.map_or("rad", |row| row.unit.as_str());
    format!("Error in {} at the end [{unit}], {which}", survey::quantity_words(quantity))
}

/// The axes that hold all errors.
fn axes(curves: &[Curve], frame: Frame) -> Panel {
    let rungs = || curves.iter().flat_map(|curve| &curve.rungs);
    let (left, right) = bounds(&rungs().map(|rung| rung.step).collect::<Vec<_>>());
    let errors: Vec<f64> = rungs().map(|rung| rung.error).filter(|error| error.is_finite()).collect();
    let (low, high) = bounds(&errors);
    let (x, y) = (Axis::logarithmic(left - 0.1, right + 0.1, 6), Axis::logarithmic(low - 0.5, high + 0.5, 8));
    Panel { frame, x, y }
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
