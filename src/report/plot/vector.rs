//! From a sketch to an SVG. Neighbours of one colour and width share an element, and places are steps from the last one: a picture of
//! thousands of points takes some tens of kilobytes.

use std::fmt::Write;

use plotters::style::RGBColor;

use super::raster;
use super::render::Fault;
use super::sketch::{Anchor, Dash, Place, Shape, Sketch, Type};

/// From the middle of a capital letter to its baseline [em].
const MIDDLE_EM: f64 = 0.36;

/// The picture as an SVG element that scales with the page. Cells of a map are images between what is drawn before and after.
pub(super) fn svg(sketch: &Sketch) -> Result<String, Fault> {
    let (width, height) = sketch.size;
    let mut text = format!(
        "<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {width} {height}\" fill=\"none\" \
         stroke-linejoin=\"round\" xmlns=\"http://www.w3.org/2000/svg\">\
         <path fill=\"#fff\" d=\"M0 0h{width}v{height}h-{width}z\"/>",
        escaped(&sketch.description)
    );
    for alike in sketch.shapes.chunk_by(|a, b| style(a).is_some_and(|a| Some(a) == style(b))) {
        match style(&alike[0]) {
            Some(style) => text += &path(alike, style),
            None => text += &alone_of_its_kind(&alike[0])?,
        }
    }
    Ok(text + "</svg>")
}

/// An SVG element as a file, which no page gives a typeface.
pub(in crate::report) fn alone(svg: &str) -> String {
    svg.replacen("<svg ", "<svg font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" ", 1)
}

/// How a path is drawn.
#[derive(Clone, Copy, PartialEq)]
enum Style {
    Filled(RGBColor),
    /// Colour, width, dashes.
    Line(RGBColor, f64, Dash),
    /// Colour and radius.
    Dots(RGBColor, f64),
}

/// The style of a shape that is a path; neighbours of one style are one path.
fn style(shape: &Shape) -> Option<Style> {
    match shape {
        Shape::Line { ink, width, dash, .. } => Some(Style::Line(*ink, *width, dash)),
        Shape::Area { ink, .. } => Some(Style::Filled(*ink)),
        Shape::Disc { radius, ink, .. } => Some(Style::Dots(*ink, *radius)),
        Shape::Raster { .. } | Shape::Text { .. } => None,
    }
}

fn path(shapes: &[Shape], style: Style) -> String {
    let mut steps = Steps::default();
    for shape in shapes {
        match shape {
            Shape::Line { places, .. } => steps.through(places),
            Shape::Area { corners, .. } => {
                steps.through(corners);
                steps.text.push('z');
            }
            Shape::Disc { centre, .. } => {
                steps.through(&[*centre]);
                steps.text += "h0";
            }
            Shape::Raster { .. } | Shape::Text { .. } => {}
        }
    }
    let how = match style {
        Style::Filled(ink) => format!("fill=\"{}\"", hex(ink)),
        Style::Line(ink, width, []) => format!("stroke=\"{}\" stroke-width=\"{width}\"", hex(ink)),
        Style::Line(ink, width, dash) => {
            let lengths: Vec<String> = dash.iter().map(f64::to_string).collect();
            let lengths = lengths.join(" ");
            format!("stroke=\"{}\" stroke-width=\"{width}\" stroke-dasharray=\"{lengths}\"", hex(ink))
        }
        Style::Dots(ink, radius) => {
            format!("stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"", hex(ink), 2.0 * radius)
        }
    };
    format!("<path {how} d=\"{}\"/>", steps.text)
}

/// A path's text, in tenths of a unit: the first place of a piece as it is, the others from the one before.
#[derive(Default)]
struct Steps {
    text: String,
}

impl Steps {
    fn through(&mut self, places: &[Place]) {
        let mut last = (0, 0);
        for (index, place) in
            places.iter().filter(|place| place.0.is_finite() && place.1.is_finite()).enumerate()
        {
            let here = ((place.0 * 10.0).round() as i64, (place.1 * 10.0).round() as i64);
            let sign = match index {
                0 => "M",
                1 => "l",
                _ => " ",
            };
            let (x, y) = if index == 0 { here } else { (here.0 - last.0, here.1 - last.1) };
            self.text += sign;
            self.text += &tenths(x);
            if y >= 0 {
                self.text.push(' ');
            }
            self.text += &tenths(y);
            last = here;
        }
    }
}

fn tenths(count: i64) -> String {
    let sign = if count < 0 { "-" } else { "" };
    match (count.abs() / 10, count.abs() % 10) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, part) => format!("{sign}.{part}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn alone_of_its_kind(shape: &Shape) -> Result<String, Fault> {
    match shape {
        Shape::Raster { low, high, columns, colours } => raster::element(*low, *high, *columns, colours),
        Shape::Text { text, place, anchor, face, turned } => Ok(words(text, *place, *anchor, face, *turned)),
        Shape::Line { .. } | Shape::Area { .. } | Shape::Disc { .. } => Ok(String::new()),
    }
}

fn words(text: &str, (x, y): Place, anchor: Anchor, face: &Type, turned: bool) -> String {
    let drop = MIDDLE_EM * face.em;
    let (x, y) = if turned { (x + drop, y) } else { (x, y + drop) };
    let [x, y] = [x, y].map(|place| tenths((place * 10.0).round() as i64));
    let mut element =
        format!("<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" fill=\"{}\"", face.em, hex(face.ink));
    if face.bold {
        element += " font-weight=\"bold\"";
    }
    match anchor {
        Anchor::Start => {}
        Anchor::Middle => element += " text-anchor=\"middle\"",
        Anchor::End => element += " text-anchor=\"end\"",
    }
    if turned {
        // Writing to a text does not fail.
        let _ = write!(element, " transform=\"rotate(-90 {x} {y})\"");
    }
    format!("{element}>{}</text>", escaped(text))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_of_one_style_share_an_element_and_places_are_steps() {
        let mut sketch = Sketch::new(100.0, 50.0, "a < b".into());
        let ink = RGBColor(0, 0, 0);
        sketch.line(vec![(1.0, 2.0), (3.26, 1.0), (3.0, 5.0)], ink, 2.0);
        sketch.line(vec![(7.0, 8.0), (7.5, 7.5)], ink, 2.0);
        sketch.line(vec![(0.0, 0.0), (9.0, 9.0)], ink, 3.0);
        let svg = svg(&sketch).expect("no map is in it");
        assert!(svg.contains("aria-label=\"a &lt; b\""), "{svg}");
        assert!(svg.contains("d=\"M1 2l2.3-1 -.3 4M7 8l.5-.5\""), "{svg}");
        assert_eq!(svg.matches("<path ").count(), 3);
    }

    #[test]
    fn a_turned_text_reads_upwards_about_its_place() {
        let mut sketch = Sketch::new(100.0, 100.0, String::new());
        sketch.upright("h", (50.0, 90.0), Type::plain(10.0, RGBColor(0, 0, 0)));
        let svg = svg(&sketch).expect("no map is in it");
        assert!(svg.contains("rotate(-90 53.6 90)"), "{svg}");
    }
}
