//! The slopes of whole orders as a fan in a corner of a panel that no curve enters.

use crate::report::number;

use super::palette::{GUIDE, INK};
use super::panel::{Frame, Panel};
use super::sketch::{Anchor, Place, Sketch, Type};

/// Width and height of the corner, as parts of the frame, the largest that is free, …
const PARTS: [(f64, f64); 3] = [(0.36, 0.5), (0.36, 0.3), (0.3, 0.18)];
/// … and its distance from the frame.
const MARGIN: f64 = 26.0;
const NAME: Type = Type::plain(26.0, INK);
/// Room for a name at the end of a line; names nearer to one another are left out.
const ROOM: f64 = 30.0;

/// Draws lines of these slopes in the first corner without curves: where steps are long and errors small, or the opposite one.
pub(super) fn draw(sketch: &mut Sketch, panel: &Panel, curves: &[Vec<Place>], orders: &[u32]) {
    let Frame { left, top, right, bottom } = panel.frame;
    let corners = PARTS.iter().flat_map(|(across, along)| {
        let (width, height) = (across * (right - left), along * (bottom - top));
        let lower = Frame { left: right - width, top: bottom - height, right, bottom };
        [lower, Frame { left, top, right: left + width, bottom: top + height }]
    });
    let free = |corner: &Frame| curves.iter().all(|curve| !enters(curve, corner));
    if let Some(corner) = corners.into_iter().find(free) {
        fan(sketch, panel, corner.inside(MARGIN, MARGIN + ROOM, MARGIN + 1.5 * ROOM, MARGIN), orders);
    }
}

/// Whether a line through places enters a rectangle.
fn enters(curve: &[Place], corner: &Frame) -> bool {
    const PARTS: usize = 16;
    let inside = |(x, y): Place| {
        (corner.left..=corner.right).contains(&x) && (corner.top..=corner.bottom).contains(&y)
    };
    let between = |pair: &[Place]| {
        (0..=PARTS).any(|part| {
            let part = part as f64 / PARTS as f64;
            inside((pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1)))
        })
    };
    curve.iter().any(|place| inside(*place)) || curve.windows(2).any(between)
}

fn fan(sketch: &mut Sketch, panel: &Panel, corner: Frame, orders: &[u32]) {
    let decade = ((panel.across(1.0) - panel.across(0.0)), (panel.along(0.0) - panel.along(1.0)));
    let apex = (corner.left, corner.bottom);
    let mut last: Option<Place> = None;
    for order in orders {
        let slope = f64::from(*order) * decade.1 / decade.0;
        let run = (corner.right - apex.0).min((apex.1 - corner.top) / slope);
        let end = (apex.0 + run, apex.1 - run * slope);
        if last.is_some_and(|last| (last.0 - end.0).hypot(last.1 - end.1) < ROOM) {
            continue;
        }
        last = Some(end);
        sketch.dashes(apex, end, GUIDE, 3.0);
        let words =
            if *order == 1 { "h".to_string() } else { format!("h{}", number::superscript(*order as i32)) };
        if end.0 < corner.right - 1.0 {
            sketch.text(&words, (end.0, end.1 - 20.0), Anchor::Middle, NAME);
        } else {
            sketch.text(&words, (end.0 + 8.0, end.1), Anchor::Start, NAME);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::plot::axis::Axis;

    #[test]
    fn slopes_stand_in_a_free_corner_or_nowhere() {
        let frame = Frame { left: 0.0, top: 0.0, right: 900.0, bottom: 900.0 };
        let panel = Panel { frame, x: Axis::logarithmic(-3.0, 0.0, 5), y: Axis::logarithmic(-9.0, 0.0, 5) };
        let ends = |curves: &[Vec<Place>]| {
            let mut sketch = Sketch::new(900.0, 900.0, String::new());
            draw(&mut sketch, &panel, curves, &[1, 2, 4]);
            sketch.shapes.len()
        };
        let falling = vec![(0.0, 900.0), (900.0, 0.0)];
        let (low, high) = (vec![(0.0, 890.0), (900.0, 890.0)], vec![(0.0, 10.0), (900.0, 10.0)]);
        assert_eq!(ends(std::slice::from_ref(&falling)), 6);
        assert_eq!(ends(&[falling.clone(), low.clone()]), 6);
        assert_eq!(ends(&[falling, low, high]), 0);
    }
}
