//! The legend: a strip of its own under the panels, so that it never covers a curve.

use plotters::style::RGBColor;

use super::palette::{BAND, GUIDE, INK, Look, Marker, OVER, PALE, SOFT, tint};
use super::sketch::{Anchor, Place, Sketch, Type};

const FACE: Type = Type::plain(30.0, INK);
/// Width of the sign before an entry's words.
pub(super) const SIGN: f64 = 104.0;
/// Between an entry and the next.
const GAP: f64 = 52.0;
/// Height of a row.
const ROW: f64 = 50.0;

/// The sign of an entry.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sign {
    /// A scheme's line with its marker.
    Scheme(Look),
    /// Lines of the schemes that are not named.
    Others,
    /// A hollow marker.
    Hollow,
    /// A filled marker.
    Filled,
    /// A grey band.
    Band,
    /// A dashed line.
    Guide,
    /// The cross of a broken run.
    Cross,
    /// The line of a front.
    Front,
    /// A place on a front, by its number.
    Number(usize),
    /// What stands beyond the chart.
    Arrow,
    /// A cell of a map.
    Swatch(RGBColor),
    /// A curve over a map.
    Over { dashed: bool },
}

/// An entry: its sign and its words.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// The sign.
    pub sign: Sign,
    /// The words.
    pub words: String,
}

impl Entry {
    /// An entry.
    pub(super) fn new(sign: Sign, words: impl Into<String>) -> Entry {
        Entry { sign, words: words.into() }
    }

    fn width(&self) -> f64 {
        SIGN + FACE.width(&self.words) + GAP
    }
}

/// The entries broken into rows that are no wider than the room.
fn rows(entries: &[Entry], room: f64) -> Vec<Vec<&Entry>> {
    let mut rows: Vec<Vec<&Entry>> = Vec::new();
    let mut used = f64::INFINITY;
    for entry in entries {
        if used + entry.width() > room + GAP {
            rows.push(Vec::new());
            used = 0.0;
        }
        used += entry.width();
        if let Some(row) = rows.last_mut() {
            row.push(entry);
        }
    }
    rows
}

/// Height of the strip that the entries need.
pub(super) fn height(entries: &[Entry], room: f64) -> f64 {
    rows(entries, room).len() as f64 * ROW
}

/// Draws the entries in rows, the first at this height.
pub(super) fn draw(sketch: &mut Sketch, entries: &[Entry], left: f64, top: f64, room: f64) {
    for (index, row) in rows(entries, room).into_iter().enumerate() {
        let y = top + ROW * (index as f64 + 0.5);
        let mut x = left;
        for entry in row {
            draw_sign(sketch, entry.sign, (x, y));
            sketch.text(&entry.words, (x + SIGN, y), Anchor::Start, FACE);
            x += entry.width();
        }
    }
}

pub(super) fn draw_sign(sketch: &mut Sketch, sign: Sign, (x, y): Place) {
    const LENGTH: f64 = 86.0;
    let middle = (x + LENGTH / 2.0, y);
    let (from, to) = ((x, y), (x + LENGTH, y));
    match sign {
        Sign::Scheme(look) => {
            sketch.stroke(vec![from, to], look.ink, 5.0, look.dash);
            sketch.marker(look.marker, middle, 11.0, look.ink, true);
        }
        Sign::Others => {
            sketch.line(vec![from, to], PALE, 3.0);
            sketch.marker(Marker::Disc, middle, 6.0, GUIDE, true);
        }
        Sign::Hollow => sketch.marker(Marker::Disc, middle, 11.0, SOFT, false),
        Sign::Filled => sketch.marker(Marker::Disc, middle, 11.0, SOFT, true),
        Sign::Band => sketch.area((x, y - 14.0), (x + LENGTH, y + 14.0), tint(BAND, 1.0)),
        Sign::Guide => sketch.dashes(from, to, GUIDE, 3.0),
        Sign::Cross => sketch.cross(middle, 10.0, SOFT),
        Sign::Front => sketch.line(vec![from, to], INK, 4.0),
        Sign::Number(number) => numbered(sketch, middle, number),
        Sign::Arrow => sketch.arrow(middle, 11.0, SOFT),
        Sign::Swatch(ink) => {
            sketch.area((x, y - 16.0), (x + LENGTH, y + 16.0), ink);
            sketch.outline((x, y - 16.0), (x + LENGTH, y + 16.0), SOFT, 2.0);
        }
        Sign::Over { dashed: false } => {
            sketch.line(vec![from, to], INK, 9.0);
            sketch.line(vec![from, to], OVER, 5.0);
        }
        Sign::Over { dashed: true } => {
            sketch.dashes(from, to, INK, 9.0);
            sketch.dashes(from, to, OVER, 5.0);
        }
    }
}

/// A number in a circle.
pub(super) fn numbered(sketch: &mut Sketch, centre: Place, number: usize) {
    const RADIUS: f64 = 17.0;
    sketch.marker(Marker::Disc, centre, RADIUS, INK, false);
    sketch.text(&number.to_string(), centre, Anchor::Middle, Type::bold(22.0, INK));
}
