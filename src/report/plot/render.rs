//! From a sketch to a PNG.

use plotters::coord::Shift;
use plotters::element::{Circle, PathElement, Polygon, Rectangle, Text};
use plotters::prelude::{BitMapBackend, Color, DrawingArea, DrawingBackend, IntoDrawingArea};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, FontTransform, IntoFont, TextStyle};

use super::sketch::{Anchor, Place, Shape, Sketch, Type, dashes};
use super::strip::Strip;
use super::{colours, font};

/// A picture that could not be drawn, in the words of the backend.
#[derive(Clone, Debug)]
pub(in crate::report) struct Fault(pub String);

/// The keyword of PNG for the program that made a picture, and this program.
const SOFTWARE: (&str, &str) = ("Software", "Polhode");

/// Whether a file that begins like this is a picture of this program.
pub fn is_own_picture(head: &str) -> bool {
    head.contains(&format!("{}\0{}", SOFTWARE.0, SOFTWARE.1))
}

fn fault(error: impl std::fmt::Display) -> Fault {
    Fault(error.to_string())
}

/// The PNG is drawn so many times larger and then averaged: the backend does not smooth thick lines itself.
const OVERSAMPLING: usize = 2;

/// Pixels of the PNG a picture unit: 2600 units are 1300 pixels, 190 an inch over the width of a page of paper; small letters are 14 high.
const SCALE: f64 = 0.5;

/// Backend pixels a picture unit.
const ZOOM: f64 = OVERSAMPLING as f64 * SCALE;

/// From the middle of a capital letter to where the backend wants the centre of a text [em]: it sets the baseline 0.097 font sizes
/// below the centre, and a capital's middle is 0.36 em above it.
const DROP_EM: f64 = 0.247;

/// Rows of the PNG that are drawn at a time: a few megabytes where the whole at twice its size would take forty.
const STRIP: u32 = 180;

/// The picture as PNG bytes.
pub(super) fn png(sketch: &Sketch) -> Result<Vec<u8>, Fault> {
    let [width, height] = [sketch.size.0, sketch.size.1].map(|size| (f64::from(size) * SCALE).round() as u32);
    let mut pixels = Vec::with_capacity(3 * width as usize * height as usize);
    for first in (0..height).step_by(STRIP as usize) {
        pixels.extend(strip(sketch, (width, height), first, STRIP.min(height - first))?);
    }
    encode(width, height, &pixels)
}

/// The pixels of `rows` rows from `first` on, of a PNG of this size.
fn strip(sketch: &Sketch, (width, height): (u32, u32), first: u32, rows: u32) -> Result<Vec<u8>, Fault> {
    let times = OVERSAMPLING as u32;
    let large = (width * times, rows * times);
    let mut pixels = vec![255; large.0 as usize * large.1 as usize * 3];
    let backend = BitMapBackend::with_buffer(&mut pixels, large);
    let area = Strip::new(backend, (large.0, height * times), first * times).into_drawing_area();
    let (top, bottom) = (f64::from(first) / SCALE, f64::from(first + rows) / SCALE);
    let inside = |shape: &&Shape| {
        let (least, greatest) = shape.heights();
        least <= bottom && greatest >= top
    };
    paint(sketch.shapes.iter().filter(inside), area)?;
    Ok(average(&pixels, width as usize, rows as usize))
}

/// A PNG from its pixels, red, green and blue. Where 16 colours give it to the eye, it names them once and has two pixels in a byte. Without a
/// filter: lines and flat areas repeat to the letter, which the compression itself finds best.
pub(super) fn encode(width: u32, height: u32, pixels: &[u8]) -> Result<Vec<u8>, Fault> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::NoFilter);
    encoder.add_text_chunk(SOFTWARE.0.into(), SOFTWARE.1.into()).map_err(fault)?;
    let named = colours::named(pixels);
    let few = named.as_ref().is_some_and(|named| named.palette.len() <= 3 * colours::FEW);
    match &named {
        Some(colours::Named { palette, .. }) => {
            encoder.set_color(png::ColorType::Indexed);
            encoder.set_depth(if few { png::BitDepth::Four } else { png::BitDepth::Eight });
            encoder.set_palette(palette.as_slice());
        }
        None => encoder.set_color(png::ColorType::Rgb),
    }
    let mut writer = encoder.write_header().map_err(fault)?;
    match &named {
        Some(named) if few => writer.write_image_data(&packed(&named.pixels, width as usize)),
        Some(named) => writer.write_image_data(&named.pixels),
        None => writer.write_image_data(pixels),
    }
    .map_err(fault)?;
    writer.finish().map_err(fault)?;
    Ok(bytes)
}

/// Numbers below 16, two in a byte, the left one in its upper half; a row begins with a byte.
fn packed(numbers: &[u8], width: usize) -> Vec<u8> {
    let byte = |pair: &[u8]| pair[0] << 4 | pair.get(1).copied().unwrap_or_default();
    numbers.chunks(width).flat_map(|row| row.chunks(2).map(byte)).collect()
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

fn paint<'a, B: DrawingBackend>(
    shapes: impl IntoIterator<Item = &'a Shape>,
    area: DrawingArea<B, Shift>,
) -> Result<(), Fault> {
    for shape in shapes {
        draw(shape, &area)?;
    }
    area.present().map_err(fault)
}

fn draw<B: DrawingBackend>(shape: &Shape, area: &DrawingArea<B, Shift>) -> Result<(), Fault> {
    let at = |(x, y): Place| ((x * ZOOM).round() as i32, (y * ZOOM).round() as i32);
    match shape {
        Shape::Line { places, ink, width, dash } => {
            let style = ink.stroke_width((width * ZOOM).round().max(1.0) as u32);
            dashes(places, dash).into_iter().try_for_each(|places| {
                let places: Vec<_> = places.into_iter().map(at).collect();
                area.draw(&PathElement::new(places, style)).map_err(fault)
            })
        }
        Shape::Area { corners, ink } => {
            let corners: Vec<_> = corners.iter().map(|place| at(*place)).collect();
            area.draw(&Polygon::new(corners, ink.filled())).map_err(fault)
        }
        Shape::Disc { centre, radius, ink } => {
            area.draw(&Circle::new(at(*centre), (radius * ZOOM).round() as i32, ink.filled())).map_err(fault)
        }
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
        Shape::Text { text, place, anchor, face, turned } => {
            let drop = face.em * DROP_EM;
            let place = if *turned { (place.0 + drop, place.1) } else { (place.0, place.1 + drop) };
            area.draw(&Text::new(text.as_str(), at(place), text_style(face, *anchor, *turned))).map_err(fault)
        }
    }
}

fn text_style<'a>(face: &'a Type, anchor: Anchor, turned: bool) -> TextStyle<'a> {
    let weight = if face.bold { FontStyle::Bold } else { FontStyle::Normal };
    let font = ("sans-serif", face.em * font::HEIGHT_PER_EM * ZOOM, weight).into_font();
    let side = match anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let font = if turned { font.transform(FontTransform::Rotate270) } else { font };
    TextStyle::from(font).color(&face.ink).pos(Pos::new(side, VPos::Center))
}
