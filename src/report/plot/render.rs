//! From a sketch to a PNG or an SVG: the same shapes on either backend of plotters.

use std::io::Write;

use plotters::coord::Shift;
use plotters::element::{Circle, PathElement, Polygon, Rectangle, Text};
use plotters::prelude::{BitMapBackend, Color, DrawingArea, DrawingBackend, IntoDrawingArea, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, IntoFont, TextStyle};

use super::sketch::{Anchor, Place, Shape, Sketch, Type};
use super::strip::Strip;
use super::{font, raster};

/// A picture that could not be drawn, in the words of the backend.
#[derive(Clone, Debug)]
pub(in crate::report) struct Fault(pub String);

fn fault(error: impl std::fmt::Display) -> Fault {
    Fault(error.to_string())
}

/// The PNG is drawn so many times larger and then averaged: the backend does not smooth thick lines itself.
const OVERSAMPLING: usize = 2;

/// What differs between the backends.
struct Pen {
    /// Backend pixels a picture unit.
    zoom: f64,
    /// The backend's font size for an em of 1.
    size_per_em: f64,
    /// From the middle of a capital letter to where the backend wants the centre of a text [em].
    drop_em: f64,
}

/// The bitmap backend sets the baseline 0.097 font sizes below the centre; a capital's middle is 0.36 em above it.
const BITMAP: Pen = Pen { zoom: OVERSAMPLING as f64, size_per_em: font::HEIGHT_PER_EM, drop_em: 0.247 };

/// The SVG backend divides font sizes by 1.24 and sets the baseline 0.5 ex (about 0.26 em) below the centre.
const VECTOR: Pen = Pen { zoom: 1.0, size_per_em: 1.24, drop_em: 0.10 };

/// The picture as PNG bytes.
pub(super) fn png(sketch: &Sketch) -> Result<Vec<u8>, Fault> {
    let (width, height) = sketch.size;
    let strips = (0..height).step_by(STRIP as usize);
    encode(width, height, strips.map(|first| strip(sketch, first, STRIP.min(height - first))))
}

/// Rows of a picture that are drawn at a time: a few megabytes where the whole at twice its size would take seventy.
const STRIP: u32 = 240;

/// The pixels of `rows` rows from `first` on.
fn strip(sketch: &Sketch, first: u32, rows: u32) -> Result<Vec<u8>, Fault> {
    let (width, height) = sketch.size;
    let zoom = OVERSAMPLING as u32;
    let large = (width * zoom, rows * zoom);
    let mut pixels = vec![255; large.0 as usize * large.1 as usize * 3];
    let backend = BitMapBackend::with_buffer(&mut pixels, large);
    let area = Strip::new(backend, (large.0, height * zoom), first * zoom).into_drawing_area();
    let (top, bottom) = (f64::from(first), f64::from(first + rows));
    let inside = |shape: &&Shape| {
        let (least, greatest) = shape.heights();
        least <= bottom && greatest >= top
    };
    paint(sketch.shapes.iter().filter(inside), area, &BITMAP)?;
    Ok(average(&pixels, width as usize, rows as usize))
}

/// A PNG from its pixels, some rows after the other. Without a filter: lines and flat areas repeat to the letter, which the
/// compression itself finds best.
pub(super) fn encode(
    width: u32,
    height: u32,
    parts: impl Iterator<Item = Result<Vec<u8>, Fault>>,
) -> Result<Vec<u8>, Fault> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Balanced);
    encoder.set_filter(png::Filter::NoFilter);
    let mut header = encoder.write_header().map_err(fault)?;
    let mut writer = header.stream_writer().map_err(fault)?;
    for pixels in parts {
        writer.write_all(&pixels?).map_err(fault)?;
    }
    writer.finish().map_err(fault)?;
    header.finish().map_err(fault)?;
    Ok(bytes)
}

/// Every pixel the mean of the four that it was drawn with.
fn average(pixels: &[u8], width: usize, height: usize) -> Vec<u8> {
    let row_bytes = width * OVERSAMPLING * 3;
    let mut averaged = Vec::with_capacity(width * height * 3);
    for rows in pixels.chunks_exact(row_bytes * OVERSAMPLING) {
        let (upper, lower) = rows.split_at(row_bytes);
        for (above, below) in upper.chunks_exact(6).zip(lower.chunks_exact(6)) {
            for channel in 0..3 {
                let sum = [above[channel], above[channel + 3], below[channel], below[channel + 3]];
                averaged.push((sum.iter().map(|&part| u16::from(part)).sum::<u16>() / 4) as u8);
            }
        }
    }
    averaged
}

/// The picture as an SVG element that scales with the page. Cells of a map are images between what is drawn before and after.
pub(super) fn svg(sketch: &Sketch) -> Result<String, Fault> {
    let (width, height) = sketch.size;
    let is_raster = |shape: &Shape| matches!(shape, Shape::Raster { .. });
    let mut rasters = sketch.shapes.iter().filter(|shape| is_raster(shape));
    let label = sketch.description.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let mut text = format!(
        "<svg role=\"img\" aria-label=\"{label}\" viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\">"
    );
    text += "<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>";
    for shapes in sketch.shapes.split(is_raster) {
        text += &layer(sketch.size, shapes)?;
        if let Some(Shape::Raster { low, high, columns, colours }) = rasters.next() {
            text += &raster::element(*low, *high, *columns, colours)?;
        }
    }
    Ok(text + "</svg>")
}

/// The elements of some shapes, without the SVG around them.
fn layer(size: (u32, u32), shapes: &[Shape]) -> Result<String, Fault> {
    let mut text = String::new();
    paint(shapes, SVGBackend::with_string(&mut text, size).into_drawing_area(), &VECTOR)?;
    let start = text.find(">\n").map_or(0, |end| end + 2);
    let body = text[start..].trim_end().trim_end_matches("</svg>");
    Ok(body.replace(" opacity=\"1\"", "").replace(" font-family=\"sans-serif\"", "").replace(">\n", ">"))
}

/// An SVG element as a file of its own, which no page gives a typeface.
pub(in crate::report) fn alone(svg: &str) -> String {
    svg.replacen("<svg ", "<svg font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" ", 1)
}

fn paint<'a, B: DrawingBackend>(
    shapes: impl IntoIterator<Item = &'a Shape>,
    area: DrawingArea<B, Shift>,
    pen: &Pen,
) -> Result<(), Fault> {
    for shape in shapes {
        draw(shape, &area, pen)?;
    }
    area.present().map_err(fault)
}

fn draw<B: DrawingBackend>(shape: &Shape, area: &DrawingArea<B, Shift>, pen: &Pen) -> Result<(), Fault> {
    let at = |(x, y): Place| ((x * pen.zoom).round() as i32, (y * pen.zoom).round() as i32);
    match shape {
        Shape::Line { places, ink, width } => {
            let stroke = (width * pen.zoom).round().max(1.0) as u32;
            let places: Vec<_> = places.iter().map(|place| at(*place)).collect();
            area.draw(&PathElement::new(places, ink.stroke_width(stroke))).map_err(fault)
        }
        Shape::Area { corners, ink } => {
            let corners: Vec<_> = corners.iter().map(|place| at(*place)).collect();
            area.draw(&Polygon::new(corners, ink.filled())).map_err(fault)
        }
        Shape::Disc { centre, radius, ink } => area
            .draw(&Circle::new(at(*centre), (radius * pen.zoom).round() as i32, ink.filled()))
            .map_err(fault),
        Shape::Raster { low, high, columns, colours } => {
            let rows = colours.len() / columns.max(&1);
            let edge = |column: usize, row: usize| {
                let x = low.0 + (high.0 - low.0) * column as f64 / *columns as f64;
                at((x, low.1 + (high.1 - low.1) * row as f64 / rows as f64))
            };
            for (index, ink) in colours.iter().enumerate() {
                let (column, row) = (index % columns, index / columns);
                let corners = [edge(column, row), edge(column + 1, row + 1)];
                area.draw(&Rectangle::new(corners, ink.filled())).map_err(fault)?;
            }
            Ok(())
        }
        Shape::Text { text, place, anchor, face } => {
            let place = (place.0, place.1 + face.em * pen.drop_em);
            area.draw(&Text::new(text.as_str(), at(place), text_style(face, *anchor, pen))).map_err(fault)
        }
    }
}

fn text_style<'a>(face: &'a Type, anchor: Anchor, pen: &Pen) -> TextStyle<'a> {
    let weight = if face.bold { FontStyle::Bold } else { FontStyle::Normal };
    let font = ("sans-serif", face.em * pen.size_per_em * pen.zoom, weight).into_font();
    let side = match anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    TextStyle::from(font).color(&face.ink).pos(Pos::new(side, VPos::Center))
}
