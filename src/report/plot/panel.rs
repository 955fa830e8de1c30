//! A panel: a frame in a picture with two axes.

use super::axis::Axis;
use super::palette::{GRID, INK, NOTE, SOFT};
use super::sketch::{Anchor, Place, Sketch, Type};

/// Titles of pictures.
pub(super) const HEADLINE: Type = Type::bold(46.0, INK);
/// What stands under a title.
pub(super) const SUBTITLE: Type = Type::plain(32.0, SOFT);
/// Titles of panels.
pub(super) const TITLE: Type = Type::bold(32.0, INK);
/// Titles of axes.
pub(super) const AXIS: Type = Type::plain(30.0, INK);
/// Labels at ticks.
pub(super) const TICK: Type = Type::plain(28.0, SOFT);

/// An upright rectangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Frame {
    /// The upper left corner.
    pub(super) fn low(&self) -> Place {
        (self.left, self.top)
    }

    /// The lower right corner.
    pub(super) fn high(&self) -> Place {
        (self.right, self.bottom)
    }

    /// The middle.
    pub(super) fn centre(&self) -> Place {
        ((self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0)
    }

    /// The rectangle without margins at its four sides: left, top, right, bottom.
    pub(super) fn inside(&self, left: f64, top: f64, right: f64, bottom: f64) -> Frame {
        Frame {
            left: self.left + left,
            top: self.top + top,
            right: self.right - right,
            bottom: self.bottom - bottom,
        }
    }

    /// The cell of a grid of equal columns and rows.
    pub(super) fn cell(&self, (columns, rows): (usize, usize), index: usize) -> Frame {
        let width = (self.right - self.left) / columns as f64;
        let height = (self.bottom - self.top) / rows as f64;
        let (column, row) = ((index % columns) as f64, (index / columns) as f64);
        let (left, top) = (self.left + column * width, self.top + row * height);
        Frame { left, top, right: left + width, bottom: top + height }
    }
}

/// A frame with its axes.
pub(super) struct Panel {
    /// Where curves are drawn.
    pub frame: Frame,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
}

impl Panel {
    /// Where a point of the axes falls in the picture.
    pub(super) fn place(&self, x: f64, y: f64) -> Place {
        (self.across(x), self.along(y))
    }

    /// Where a number of the horizontal axis falls.
    pub(super) fn across(&self, x: f64) -> f64 {
        self.frame.left + self.x.part(x) * (self.frame.right - self.frame.left)
    }

    /// Where a number of the vertical axis falls.
    pub(super) fn along(&self, y: f64) -> f64 {
        self.frame.bottom - self.y.part(y) * (self.frame.bottom - self.frame.top)
    }

    /// Draws the grid, to be hidden by what is drawn next.
    pub(super) fn draw_grid(&self, sketch: &mut Sketch) {
        let Frame { left, top, right, bottom } = self.frame;
        for (value, _) in &self.x.labels {
            let x = self.across(*value);
            sketch.line(vec![(x, top), (x, bottom)], GRID, 2.0);
        }
        for (value, _) in &self.y.labels {
            let y = self.along(*value);
            sketch.line(vec![(left, y), (right, y)], GRID, 2.0);
        }
    }

    /// Draws frame and ticks over the curves.
    pub(super) fn draw_frame(&self, sketch: &mut Sketch) {
        let Frame { left, bottom, .. } = self.frame;
        sketch.outline(self.frame.low(), self.frame.high(), SOFT, 2.0);
        let labelled = |labels: &[(f64, String)]| labels.iter().map(|(value, _)| *value).collect::<Vec<_>>();
        for (values, length) in [(labelled(&self.x.labels), 12.0), (self.x.ticks.clone(), 6.0)] {
            for x in values.into_iter().map(|value| self.across(value)) {
                sketch.line(vec![(x, bottom), (x, bottom - length)], SOFT, 2.0);
            }
        }
        for (values, length) in [(labelled(&self.y.labels), 12.0), (self.y.ticks.clone(), 6.0)] {
            for y in values.into_iter().map(|value| self.along(value)) {
                sketch.line(vec![(left, y), (left + length, y)], SOFT, 2.0);
            }
        }
    }

    /// Writes the numbers below the frame, and the title of the horizontal axis below them.
    pub(super) fn label_x(&self, sketch: &mut Sketch, title: &str) {
        let Frame { left, right, bottom, .. } = self.frame;
        for (value, label) in &self.x.labels {
            sketch.text(label, (self.across(*value), bottom + 28.0), Anchor::Middle, TICK);
        }
        sketch.text(title, ((left + right) / 2.0, bottom + 72.0), Anchor::Middle, AXIS);
    }

    /// Writes the numbers left of the frame.
    pub(super) fn label_y(&self, sketch: &mut Sketch) {
        for (value, label) in &self.y.labels {
            sketch.text(label, (self.frame.left - 14.0, self.along(*value)), Anchor::End, TICK);
        }
    }

    /// Writes a title over the frame, at its left edge.
    pub(super) fn title(&self, sketch: &mut Sketch, title: &str) {
        sketch.text(title, (self.frame.left, self.frame.top - 30.0), Anchor::Start, TITLE);
    }
}

/// Writes a picture's title and the line under it.
pub(super) fn headline(sketch: &mut Sketch, title: &str, subtitle: &str) {
    const LEFT: f64 = 40.0;
    let room = f64::from(sketch.size.0) - 2.0 * LEFT;
    let title = fitted(title, HEADLINE, room);
    let subtitle = fitted(subtitle, SUBTITLE, room);
    sketch.text(&title, (LEFT, 52.0), Anchor::Start, HEADLINE);
    sketch.text(&subtitle, (LEFT, 106.0), Anchor::Start, SUBTITLE);
}

/// A text cut to a width, with an ellipsis where something was cut.
pub(super) fn fitted(text: &str, face: Type, room: f64) -> String {
    if face.width(text) <= room {
        return text.into();
    }
    let mut kept: String = text.into();
    while !kept.is_empty() && face.width(&kept) + face.width("…") > room {
        kept.pop();
    }
    format!("{}…", kept.trim_end())
}

/// A panel of words alone: a heading and lines under it.
pub(super) fn words(sketch: &mut Sketch, frame: Frame, heading: &str, lines: &[String]) {
    const LEADING: f64 = 52.0;
    sketch.area(frame.low(), frame.high(), NOTE);
    sketch.outline(frame.low(), frame.high(), GRID, 2.0);
    let room = frame.right - frame.left - 40.0;
    let (x, middle) = frame.centre();
    let first = middle - LEADING * lines.len() as f64 / 2.0;
    sketch.text(&fitted(heading, TITLE, room), (x, first), Anchor::Middle, TITLE);
    for (row, line) in lines.iter().enumerate() {
        let y = first + LEADING * (row + 1) as f64 + 8.0;
        sketch.text(&fitted(line, AXIS, room), (x, y), Anchor::Middle, AXIS);
    }
}
