//! The layout of a picture of maps.

use super::scale::Key;
use super::{Curve, HeatMap, Map, Range};
use crate::report::plot::axis::Axis;
use crate::report::plot::palette::{INK, OVER};
use crate::report::plot::panel::{self, Frame, Panel};
use crate::report::plot::sketch::{Anchor, Place, Sketch, Type};

const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;

/// Width of the picture, and columns and rows of panels in it.
fn layout(panels: usize) -> (f64, (usize, usize)) {
    let columns = match panels {
        0 | 1 => 1,
        2 | 4 => 2,
        3 | 5..=9 => 3,
        _ => 4,
    };
    let width = [1700.0, 2300.0, 2600.0, 2900.0][columns - 1];
    (width, (columns, panels.div_ceil(columns).max(1)))
}

/// Lays the picture out.
pub(super) fn sketch(picture: &HeatMap) -> Sketch {
    let key = Key::of(picture);
    let (width, grid) = layout(picture.panels.len());
    let room = width - 2.0 * MARGIN - 20.0;
    let strip = key.height(picture, room);
    let row = 0.78 * (width - 2.0 * MARGIN) / grid.0 as f64 + 60.0;
    let height = TOP + row * grid.1 as f64 + strip + 3.0 * MARGIN;
    let mut sketch = Sketch::new(width, height, picture.description.clone());
    panel::headline(&mut sketch, &picture.title, &picture.subtitle);
    let all = Frame { left: MARGIN, top: TOP, right: width - MARGIN, bottom: TOP + row * grid.1 as f64 };
    for (index, map) in picture.panels.iter().enumerate() {
        draw_map(&mut sketch, &key, map, all.cell(grid, index));
    }
    key.draw(&mut sketch, picture, (MARGIN + 20.0, all.bottom + MARGIN), room);
    sketch
}

fn axis(range: &Range, most: usize) -> Axis {
    let (low, high) = (range.on(range.low), range.on(range.high));
    let mut axis =
        if range.logarithmic { Axis::logarithmic(low, high, most) } else { Axis::linear(low, high, most) };
    // Cells end where their range does, even where an axis would like to be longer.
    (axis.low, axis.high) = (low, high);
    axis.labels.retain(|(value, _)| (low..=high).contains(value));
    axis.ticks.retain(|value| (low..=high).contains(value));
    axis
}

fn draw_map(sketch: &mut Sketch, key: &Key, map: &Map, cell: Frame) {
    // The title of the vertical axis stands over the panel: level words are read without turning the head.
    let frame = cell.inside(150.0, if map.title.is_empty() { 60.0 } else { 110.0 }, 40.0, 110.0);
    let panel = Panel { frame, x: axis(&map.across, 6), y: axis(&map.up, 8) };
    let colours = map.cells.iter().map(|cell| key.colour(*cell)).collect();
    sketch.raster(frame.low(), frame.high(), map.columns, turned(colours, map.columns, map.rows()));
    for curve in &map.curves {
        draw_curve(sketch, &panel, map, curve);
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, &map.across.title);
    panel.label_y(sketch);
    let up = panel::fitted(&map.up.title, panel::AXIS, frame.right - frame.left);
    sketch.text(&up, (frame.left, frame.top - 28.0), Anchor::Start, panel::AXIS);
    if !map.title.is_empty() {
        let smaller = ((frame.right - frame.left) / panel::TITLE.width(&map.title)).min(1.0);
        let face = Type::bold(panel::TITLE.em * smaller, panel::TITLE.ink);
        sketch.text(&map.title, (frame.left, frame.top - 76.0), Anchor::Start, face);
    }
}

/// Rows from the highest, as an image has them.
fn turned<T: Copy>(cells: Vec<T>, columns: usize, rows: usize) -> Vec<T> {
    (0..rows).rev().flat_map(|row| cells[row * columns..(row + 1) * columns].iter().copied()).collect()
}

fn draw_curve(sketch: &mut Sketch, panel: &Panel, map: &Map, curve: &Curve) {
    let place = |(x, y): &(f64, f64)| panel.place(map.across.on(*x), map.up.on(*y));
    let places: Vec<Place> = curve.places.iter().map(place).collect();
    // A dark rim under a white line is seen on dark and on light cells.
    for (ink, width) in [(INK, 9.0), (OVER, 5.0)] {
        for piece in pieces(panel.frame, &places) {
            if curve.dashed {
                sketch.dashed(&piece, ink, width);
            } else {
                sketch.line(piece, ink, width);
            }
        }
    }
}

/// The pieces of a line through places that lie inside a frame.
fn pieces(frame: Frame, places: &[Place]) -> Vec<Vec<Place>> {
    let mut pieces: Vec<Vec<Place>> = Vec::new();
    for pair in places.windows(2) {
        let Some((from, to)) = inside(frame, pair[0], pair[1]) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// The part of a straight line inside a frame, by Liang and Barsky's parametric clipping.
fn inside(frame: Frame, from: Place, to: Place) -> Option<(Place, Place)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    if ![from.0, from.1, to.0, to.1].iter().all(|number| number.is_finite()) {
        return None;
    }
    let sides = [
        (-dx, from.0 - frame.left),
        (dx, frame.right - from.0),
        (-dy, from.1 - frame.top),
        (dy, frame.bottom - from.1),
    ];
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for (speed, room) in sides {
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            enter = enter.max(room / speed);
        } else {
            leave = leave.min(room / speed);
        }
    }
    let at = |s: f64| (from.0 + s * dx, from.1 + s * dy);
    (enter < leave).then(|| (at(enter), at(leave)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_at_the_frame() {
        let frame = Frame { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 };
        assert_eq!(inside(frame, (-5.0, 5.0), (15.0, 5.0)), Some(((0.0, 5.0), (10.0, 5.0))));
        assert_eq!(inside(frame, (2.0, 2.0), (3.0, 4.0)), Some(((2.0, 2.0), (3.0, 4.0))));
        assert_eq!(inside(frame, (-5.0, -5.0), (15.0, -1.0)), None);
        let path = [(2.0, 2.0), (8.0, 2.0), (8.0, 20.0), (5.0, 20.0), (5.0, 5.0)];
        let expected = [vec![(2.0, 2.0), (8.0, 2.0), (8.0, 10.0)], vec![(5.0, 10.0), (5.0, 5.0)]];
        assert_eq!(pieces(frame, &path), expected);
        assert_eq!(inside(frame, (f64::NAN, 5.0), (5.0, 5.0)), None);
    }

    #[test]
    fn the_lowest_row_is_drawn_at_the_bottom() {
        assert_eq!(turned(vec![1, 2, 3, 4, 5, 6], 2, 3), [5, 6, 3, 4, 1, 2]);
    }
}
