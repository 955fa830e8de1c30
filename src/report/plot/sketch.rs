//! A picture as a list of shapes, laid out once and then drawn by any backend.
//!
//! Lengths are picture units: pixels of the PNG, units of the SVG's view box; x to the right, y downwards.

use plotters::style::{FontStyle, IntoFont, RGBColor};

use super::palette::Marker;

/// A place in a picture.
pub(super) type Place = (f64, f64);

/// Where a text stands relative to its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Anchor {
    /// The text begins there.
    Start,
    /// The text is centred there.
    Middle,
    /// The text ends there.
    End,
}

/// Size, colour and weight of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Type {
    /// Height of the em square.
    pub em: f64,
    /// Colour.
    pub ink: RGBColor,
    /// Heavy strokes.
    pub bold: bool,
}

impl Type {
    /// Regular text.
    pub(super) const fn plain(em: f64, ink: RGBColor) -> Type {
        Type { em, ink, bold: false }
    }

    /// Bold text.
    pub(super) const fn bold(em: f64, ink: RGBColor) -> Type {
        Type { em, ink, bold: true }
    }

    /// Width of a text.
    pub(super) fn width(&self, text: &str) -> f64 {
        let style = if self.bold { FontStyle::Bold } else { FontStyle::Normal };
        let font = ("sans-serif", self.em * super::font::HEIGHT_PER_EM, style).into_font();
        font.layout_box(text).map_or(0.0, |(low, high)| f64::from(high.0 - low.0))
    }
}

/// One thing to draw.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// A line through places.
    Line { places: Vec<Place>, ink: RGBColor, width: f64 },
    /// A filled polygon.
    Area { corners: Vec<Place>, ink: RGBColor },
    /// A filled disc.
    Disc { centre: Place, radius: f64, ink: RGBColor },
    /// A text, its middle height at the place.
    Text { text: String, place: Place, anchor: Anchor, face: Type },
}

/// A picture: its size and its shapes, the hindmost first.
#[derive(Clone, Debug)]
pub(super) struct Sketch {
    /// Width and height.
    pub size: (u32, u32),
    /// What the picture shows, for those who cannot see it.
    pub description: String,
    /// The shapes.
    pub shapes: Vec<Shape>,
}

impl Sketch {
    /// An empty picture.
    pub(super) fn new(width: f64, height: f64, description: String) -> Sketch {
        Sketch { size: (width as u32, height as u32), description, shapes: Vec::new() }
    }

    /// Adds a line.
    pub(super) fn line(&mut self, places: Vec<Place>, ink: RGBColor, width: f64) {
        self.shapes.push(Shape::Line { places, ink, width });
    }

    /// Adds a straight dashed line.
    pub(super) fn dashes(&mut self, from: Place, to: Place, ink: RGBColor, width: f64) {
        const DASH: f64 = 22.0;
        const GAP: f64 = 14.0;
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let at = |s: f64| {
            let part = (s / length).min(1.0);
            (from.0 + part * (to.0 - from.0), from.1 + part * (to.1 - from.1))
        };
        let mut start = 0.0;
        while start < length {
            self.line(vec![at(start), at(start + DASH)], ink, width);
            start += DASH + GAP;
        }
    }

    /// Adds a filled upright rectangle.
    pub(super) fn area(&mut self, low: Place, high: Place, ink: RGBColor) {
        let corners = vec![low, (high.0, low.1), high, (low.0, high.1)];
        self.shapes.push(Shape::Area { corners, ink });
    }

    /// Adds the outline of an upright rectangle.
    pub(super) fn outline(&mut self, low: Place, high: Place, ink: RGBColor, width: f64) {
        self.line(vec![low, (high.0, low.1), high, (low.0, high.1), low, (high.0, low.1)], ink, width);
    }

    /// Adds a level text, its middle height at the place.
    pub(super) fn text(&mut self, text: &str, place: Place, anchor: Anchor, face: Type) {
        self.shapes.push(Shape::Text { text: text.into(), place, anchor, face });
    }

    /// Adds a marker, filled or hollow.
    pub(super) fn marker(&mut self, marker: Marker, centre: Place, radius: f64, ink: RGBColor, filled: bool) {
        self.filled_marker(marker, centre, radius, ink);
        if !filled {
            self.filled_marker(marker, centre, radius - marker.rim(), RGBColor(255, 255, 255));
        }
    }

    fn filled_marker(&mut self, marker: Marker, centre: Place, radius: f64, ink: RGBColor) {
        self.shapes.push(match marker.corners(centre, radius) {
            Some(corners) => Shape::Area { corners, ink },
            None => Shape::Disc { centre, radius, ink },
        });
    }

    /// Adds a slanting cross: the sign of a run that broke.
    pub(super) fn cross(&mut self, centre: Place, radius: f64, ink: RGBColor) {
        let (x, y) = centre;
        self.line(vec![(x - radius, y - radius), (x + radius, y + radius)], ink, 6.0);
        self.line(vec![(x - radius, y + radius), (x + radius, y - radius)], ink, 6.0);
    }
}
