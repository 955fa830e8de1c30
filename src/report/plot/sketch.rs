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

/// Lengths of dashes and gaps, one after the other; empty for a line without gaps.
pub(super) type Dash = &'static [f64];

/// The dashes of a line through places; they run on around its corners.
pub(super) fn dashes(places: &[Place], pattern: Dash) -> Vec<Vec<Place>> {
    let mut lengths = pattern.iter().copied().cycle();
    let Some(mut left) = lengths.next() else { return vec![places.to_vec()] };
    let (mut drawing, mut dashes) = (true, Vec::new());
    let mut dash: Vec<Place> = places.first().copied().into_iter().collect();
    for pair in places.windows(2) {
        let length = (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1);
        let at = |s: f64| {
            let part = s / length;
            (pair[0].0 + part * (pair[1].0 - pair[0].0), pair[0].1 + part * (pair[1].1 - pair[0].1))
        };
        let mut along = 0.0;
        while length - along > left {
            along += left;
            dash.push(at(along));
            if drawing {
                dashes.push(std::mem::take(&mut dash));
            }
            dash = vec![at(along)];
            drawing = !drawing;
            left = lengths.next().unwrap_or(f64::INFINITY);
        }
        left -= length - along;
        dash.push(pair[1]);
    }
    if drawing && dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

/// One thing to draw.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// A line through places, in dashes of these lengths and gaps; none where it is whole.
    Line { places: Vec<Place>, ink: RGBColor, width: f64, dash: Dash },
    /// A filled polygon.
    Area { corners: Vec<Place>, ink: RGBColor },
    /// A filled disc.
    Disc { centre: Place, radius: f64, ink: RGBColor },
    /// A rectangle of equal cells, row after row from the upper left corner.
    Raster { low: Place, high: Place, columns: usize, colours: Vec<RGBColor> },
    /// A text, its middle height at the place; turned, it reads upwards.
    Text { text: String, place: Place, anchor: Anchor, face: Type, turned: bool },
}

impl Shape {
    /// The least and the greatest y that it may reach.
    pub(super) fn heights(&self) -> (f64, f64) {
        let around = |places: &[Place], margin: f64| {
            let ys = || places.iter().map(|place| place.1);
            (ys().fold(f64::INFINITY, f64::min) - margin, ys().fold(f64::NEG_INFINITY, f64::max) + margin)
        };
        match self {
            Shape::Line { places, width, .. } => around(places, *width),
            Shape::Area { corners, .. } => around(corners, 1.0),
            Shape::Disc { centre, radius, .. } => around(&[*centre], radius + 1.0),
            Shape::Raster { low, high, .. } => around(&[*low, *high], 1.0),
            Shape::Text { text, place, face, turned: true, .. } => around(&[*place], face.width(text)),
            // Accents and descenders of a typeface stay within two ems of the middle of a line.
            Shape::Text { place, face, .. } => around(&[*place], 2.0 * face.em),
        }
    }
}

/// A filled polygon as a shape.
pub(super) fn fan(corners: Vec<Place>, ink: RGBColor) -> Shape {
    Shape::Area { corners, ink }
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
        self.stroke(places, ink, width, &[]);
    }

    /// Adds a line in dashes.
    pub(super) fn stroke(&mut self, places: Vec<Place>, ink: RGBColor, width: f64, dash: Dash) {
        self.shapes.push(Shape::Line { places, ink, width, dash });
    }

    /// Adds a straight dashed line.
    pub(super) fn dashes(&mut self, from: Place, to: Place, ink: RGBColor, width: f64) {
        self.dashed(&[from, to], ink, width);
    }

    /// Adds a dashed line through places; the dashes run on around its corners.
    pub(super) fn dashed(&mut self, places: &[Place], ink: RGBColor, width: f64) {
        self.stroke(places.to_vec(), ink, width, &[22.0, 14.0]);
    }

    /// Adds a filled upright rectangle.
    pub(super) fn area(&mut self, low: Place, high: Place, ink: RGBColor) {
        let corners = vec![low, (high.0, low.1), high, (low.0, high.1)];
        self.shapes.push(Shape::Area { corners, ink });
    }

    /// Adds the outline of an upright rectangle. (One line around it would cross itself where it ends, and be empty there.)
    pub(super) fn outline(&mut self, low: Place, high: Place, ink: RGBColor, width: f64) {
        let half = width / 2.0;
        for y in [low.1, high.1] {
            self.line(vec![(low.0 - half, y), (high.0 + half, y)], ink, width);
        }
        for x in [low.0, high.0] {
            self.line(vec![(x, low.1 - half), (x, high.1 + half)], ink, width);
        }
    }

    /// Adds a rectangle of cells.
    pub(super) fn raster(&mut self, low: Place, high: Place, columns: usize, colours: Vec<RGBColor>) {
        self.shapes.push(Shape::Raster { low, high, columns, colours });
    }

    /// Adds a level text, its middle height at the place.
    pub(super) fn text(&mut self, text: &str, place: Place, anchor: Anchor, face: Type) {
        self.shapes.push(Shape::Text { text: text.into(), place, anchor, face, turned: false });
    }

    /// Adds a text that reads upwards from the place.
    pub(super) fn upright(&mut self, text: &str, place: Place, face: Type) {
        let (text, anchor) = (text.into(), Anchor::Start);
        self.shapes.push(Shape::Text { text, place, anchor, face, turned: true });
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

    /// Adds an arrow that points upwards: the sign of an error beyond the chart.
    pub(super) fn arrow(&mut self, centre: Place, radius: f64, ink: RGBColor) {
        let (x, y) = centre;
        self.line(vec![(x, y + radius), (x, y - radius)], ink, 4.0);
        self.line(vec![(x - 0.7 * radius, y), (x, y - radius), (x + 0.7 * radius, y)], ink, 4.0);
    }

    /// Adds a slanting cross: the sign of a run that broke.
    pub(super) fn cross(&mut self, centre: Place, radius: f64, ink: RGBColor) {
        let (x, y) = centre;
        self.line(vec![(x - radius, y - radius), (x + radius, y + radius)], ink, 6.0);
        self.line(vec![(x - radius, y + radius), (x + radius, y - radius)], ink, 6.0);
    }
}
