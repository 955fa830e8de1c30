//! From a cell to its colour, and the strip under the panels that says what colours mean.

use plotters::style::RGBColor;

use super::{HeatMap, Scale};
use crate::report::plot::axis::Axis;
use crate::report::plot::colour_map::{diverging, viridis};
use crate::report::plot::legend::{self, Entry, Sign};
use crate::report::plot::palette::{BAND, SOFT};
use crate::report::plot::panel::{AXIS, TICK};
use crate::report::plot::sketch::{Anchor, Place, Sketch, fan};
use crate::report::survey;

/// Cells without a value.
const NOTHING: RGBColor = BAND;
/// Decades of a logarithmic scale that takes its ends from the cells.
const MOST_DECADES: f64 = 18.0;
const BAR: (f64, f64) = (900.0, 40.0);
/// Height of the colour bar with its labels.
const BAR_ROOM: f64 = 120.0;

/// The colour of a part of the range.
type Colours = fn(f64) -> RGBColor;

/// The scale of a picture, its ends known. Where zero lies inside a linear scale it is the middle, and white.
pub(super) enum Key<'a> {
    /// Numbers; the axis holds log₁₀ where the scale is logarithmic.
    Numbers { title: &'a str, logarithmic: bool, axis: Axis, below: bool, above: bool, colours: Colours },
    /// Classes.
    Classes(&'a [super::Class]),
}

impl<'a> Key<'a> {
    /// The scale of a picture.
    pub(super) fn of(picture: &'a HeatMap) -> Key<'a> {
        let (title, logarithmic, range) = match &picture.scale {
            Scale::Classes(classes) => return Key::Classes(classes),
            Scale::Numbers { title, logarithmic, range } => (title, *logarithmic, *range),
        };
        let cells = || picture.panels.iter().flat_map(|map| map.cells.iter().flatten().copied());
        let values: Vec<f64> =
            cells().map(|value| on(value, logarithmic)).filter(|value| value.is_finite()).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (low, high) = match range {
            Some((low, high)) => (on(low, logarithmic), on(high, logarithmic)),
            None if logarithmic => (least.max(most - MOST_DECADES), most),
            None => (least, most),
        };
        let signed = !logarithmic && low < 0.0 && high > 0.0;
        let (low, high) = if signed { (low.min(-high), high.max(-low)) } else { (low, high) };
        let colours: Colours = if signed { diverging } else { viridis };
        let axis = if logarithmic { Axis::logarithmic(low, high, 10) } else { Axis::linear(low, high, 8) };
        let zero = logarithmic && cells().any(|value| value <= 0.0);
        let (below, above) = (zero || least < axis.low - 1e-12, most > axis.high + 1e-12);
        Key::Numbers { title, logarithmic, axis, below, above, colours }
    }

    /// The colour of a cell.
    pub(super) fn colour(&self, cell: Option<f64>) -> RGBColor {
        let Some(value) = cell.filter(|value| !value.is_nan()) else { return NOTHING };
        match self {
            Key::Classes(classes) => classes.get(value as usize).map_or(NOTHING, |class| class.hue.ink()),
            Key::Numbers { logarithmic: true, colours, .. } if value <= 0.0 => colours(0.0),
            Key::Numbers { logarithmic, axis, colours, .. } => colours(axis.part(on(value, *logarithmic))),
        }
    }

    /// Height of the strip that says what colours mean.
    pub(super) fn height(&self, picture: &HeatMap, room: f64) -> f64 {
        let bar = if matches!(self, Key::Numbers { .. }) { BAR_ROOM } else { 0.0 };
        bar + legend::height(&self.entries(picture), room)
    }

    /// Draws the strip.
    pub(super) fn draw(&self, sketch: &mut Sketch, picture: &HeatMap, (left, top): Place, room: f64) {
        let mut entries_top = top;
        if let Key::Numbers { title, axis, below, above, colours, .. } = self {
            draw_bar(sketch, title, (axis, *colours), (*below, *above), (left, top));
            entries_top += BAR_ROOM;
        }
        legend::draw(sketch, &self.entries(picture), left, entries_top, room);
    }

    fn entries(&self, picture: &HeatMap) -> Vec<Entry> {
        let mut entries = Vec::new();
        if let Key::Classes(classes) = self {
            let swatch = |class: &super::Class| Entry::new(Sign::Swatch(class.hue.ink()), &*class.words);
            entries.extend(classes.iter().map(swatch));
        }
        let curves = || picture.panels.iter().flat_map(|map| &map.curves);
        for words in survey::distinct(curves().map(|curve| curve.words.as_str())) {
            let dashed = curves().any(|curve| curve.words == words && curve.dashed);
            entries.push(Entry::new(Sign::Over { dashed }, words));
        }
        if picture.panels.iter().any(|map| map.cells.iter().any(Option::is_none)) {
            entries.push(Entry::new(Sign::Swatch(NOTHING), "no value"));
        }
        entries
    }
}

fn on(value: f64, logarithmic: bool) -> f64 {
    if logarithmic { value.log10() } else { value }
}

/// The colour bar, its title at its left; an end that cells lie beyond is a point.
fn draw_bar(
    sketch: &mut Sketch,
    title: &str,
    (axis, colours): (&Axis, Colours),
    (below, above): (bool, bool),
    (left, top): Place,
) {
    const STEPS: usize = 180;
    const TIP: f64 = 30.0;
    let start = left + AXIS.width(title) + 30.0 + TIP;
    let (low, high) = (top + 8.0, top + 8.0 + BAR.1);
    sketch.text(title, (left, (low + high) / 2.0), Anchor::Start, AXIS);
    let width = BAR.0 / STEPS as f64;
    for step in 0..STEPS {
        let x = start + step as f64 * width;
        sketch.area((x, low), (x + width + 1.0, high), colours((step as f64 + 0.5) / STEPS as f64));
    }
    let (end, middle) = (start + BAR.0, (low + high) / 2.0);
    if below {
        sketch.shapes.push(fan(vec![(start, low), (start - TIP, middle), (start, high)], colours(0.0)));
    }
    if above {
        sketch.shapes.push(fan(vec![(end, low), (end + TIP, middle), (end, high)], colours(1.0)));
    }
    for (value, label) in &axis.labels {
        let x = start + axis.part(*value) * BAR.0;
        sketch.line(vec![(x, high), (x, high + 10.0)], SOFT, 2.0);
        sketch.text(label, (x, high + 34.0), Anchor::Middle, TICK);
    }
}
