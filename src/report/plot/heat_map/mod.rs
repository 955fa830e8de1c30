//! Maps: a number or a class in every cell of a rectangle, one panel or several under one scale, with curves of theory over them.
//!
//! A map is made from what its caller has measured, and knows nothing of how. Rows stand in mathematical order: the first at the
//! low end of the vertical axis; within a row the horizontal axis runs fastest.

mod draw;
mod scale;

use plotters::style::RGBColor;

use super::palette;
use super::render::{self, Fault};
use super::sketch::Sketch;
use super::vector;
use crate::report::DrawingError;

/// A picture of one map or several under one scale.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMap {
    /// Title of the picture.
    pub title: String,
    /// The line under it.
    pub subtitle: String,
    /// What the picture shows, for those who cannot see it.
    pub description: String,
    /// What the colours mean, the same in every panel.
    pub scale: Scale,
    /// The maps, read as a page is.
    pub panels: Vec<Map>,
}

/// What colours mean.
#[derive(Clone, Debug, PartialEq)]
pub enum Scale {
    /// Numbers, from dark to light.
    Numbers {
        /// Name and unit, written beside the colour bar.
        title: String,
        /// Whether equal distances in colour are equal ratios. Numbers that are not positive then have the colour of the low end.
        logarithmic: bool,
        /// The numbers at the two ends; `None`: the least and the greatest of all cells. Cells beyond an end have its colour,
        /// and the colour bar ends in a point there.
        range: Option<(f64, f64)>,
    },
    /// Classes; a cell's number is an index of this list.
    Classes(Vec<Class>),
}

/// A class of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Class {
    /// Words of the legend.
    pub words: String,
    /// Colour.
    pub hue: Hue,
}

/// A colour of Okabe and Ito's palette, which stay apart for every kind of colour vision, or a shade of grey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hue {
    /// Blue.
    Blue,
    /// Vermilion.
    Vermilion,
    /// Bluish green.
    Green,
    /// Reddish purple.
    Purple,
    /// Orange.
    Orange,
    /// Sky blue.
    Sky,
    /// Yellow.
    Yellow,
    /// Black.
    Black,
    /// Light grey.
    Grey,
    /// White.
    White,
}

impl Hue {
    fn ink(self) -> RGBColor {
        let [blue, vermilion, green, purple, orange, sky, black, yellow] = palette::COLOURS;
        match self {
            Hue::Blue => blue,
            Hue::Vermilion => vermilion,
            Hue::Green => green,
            Hue::Purple => purple,
            Hue::Orange => orange,
            Hue::Sky => sky,
            Hue::Yellow => yellow,
            Hue::Black => black,
            Hue::Grey => palette::BAND,
            Hue::White => RGBColor(255, 255, 255),
        }
    }
}

/// One map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Title over the panel; empty where the picture's title says it.
    pub title: String,
    /// Horizontal axis.
    pub across: Range,
    /// Vertical axis.
    pub up: Range,
    /// Cells in a row.
    pub columns: usize,
    /// The cells, row after row from the lowest; `None` is drawn grey and stands in the legend as "no value".
    pub cells: Vec<Option<f64>>,
    /// Curves over the cells.
    pub curves: Vec<Curve>,
}

/// An axis of a map: it reaches from the outer edge of the first cell to the outer edge of the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// Name and unit.
    pub title: String,
    /// Number at the low end; positive where the axis is logarithmic.
    pub low: f64,
    /// Number at the high end.
    pub high: f64,
    /// Whether equal distances are equal ratios.
    pub logarithmic: bool,
}

impl Range {
    /// The axis on which so many cells are centred on numbers from `first` to `last` in equal steps (equal ratios where
    /// logarithmic): half a cell longer at both ends.
    pub fn centred(title: &str, first: f64, last: f64, count: usize, logarithmic: bool) -> Range {
        let (from, to) = if logarithmic { (first.log10(), last.log10()) } else { (first, last) };
        let half = if count > 1 { (to - from) / (count - 1) as f64 / 2.0 } else { 0.5 };
        let out = |x: f64| if logarithmic { 10f64.powf(x) } else { x };
        Range { title: title.to_owned(), low: out(from - half), high: out(to + half), logarithmic }
    }

    /// Where a number stands on the drawn axis: its logarithm where it is logarithmic.
    fn on(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }
}

/// A curve over a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Words of the legend; curves of the same words in several panels share an entry.
    pub words: String,
    /// Its places, in the numbers of the axes; what leaves the panel is cut off.
    pub places: Vec<(f64, f64)>,
    /// Whether it is dashed.
    pub dashed: bool,
}

impl HeatMap {
    /// The picture as PNG bytes.
    ///
    /// # Errors
    /// A panel whose cells do not fill its rows, or whose axis is no range; a backend that fails.
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        Ok(render::png(&self.checked()?)?)
    }

    /// The picture as an SVG element that scales with a page.
    ///
    /// # Errors
    /// A panel whose cells do not fill its rows, or whose axis is no range; a backend that fails.
    pub fn svg(&self) -> Result<String, DrawingError> {
        Ok(vector::svg(&self.checked()?)?)
    }

    /// The picture, laid out.
    pub(in crate::report::plot) fn checked(&self) -> Result<Sketch, Fault> {
        super::font::register().map_err(|why| Fault(why.into()))?;
        self.panels.iter().try_for_each(Map::check).map_err(Fault)?;
        Ok(draw::sketch(self))
    }
}

impl Map {
    fn check(&self) -> Result<(), String> {
        if self.columns == 0 || self.cells.is_empty() || !self.cells.len().is_multiple_of(self.columns) {
            return Err(format!(
                "{} cells do not fill rows of {} in map '{}'",
                self.cells.len(),
                self.columns,
                self.title
            ));
        }
        for range in [&self.across, &self.up] {
            let (low, high) = (range.on(range.low), range.on(range.high));
            if !(low.is_finite() && high.is_finite() && low < high) {
                return Err(format!(
                    "axis '{}' cannot run from {} to {}",
                    range.title, range.low, range.high
                ));
            }
        }
        Ok(())
    }

    fn rows(&self) -> usize {
        self.cells.len() / self.columns
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(cells: Vec<Option<f64>>, columns: usize) -> HeatMap {
        let range = |title: &str| Range::centred(title, 1e-3, 1e-1, 2, true);
        let panel = Map {
            title: String::new(),
            across: range("step h [s]"),
            up: range("stiffness k [N/m]"),
            columns,
            cells,
            curves: vec![Curve {
                words: "theory".into(),
                places: vec![(1e-9, 1e-9), (1.0, 1.0)],
                dashed: false,
            }],
        };
        let scale = Scale::Numbers { title: "error [rad]".into(), logarithmic: true, range: None };
        HeatMap {
            title: "A map".into(),
            subtitle: "of four cells".into(),
            description: "a map".into(),
            scale,
            panels: vec![panel],
        }
    }

    #[test]
    fn cells_become_pixels_of_an_image_and_curves_stay_lines() {
        let svg = map(vec![Some(1e-8), Some(1e-4), None, Some(0.0)], 2).svg().expect("a picture");
        assert!(svg.contains("<image ") && svg.contains("data:image/png;base64,"));
        assert!(svg.contains("no value") && svg.contains("theory") && svg.contains("error [rad]"));
        let png = map(vec![Some(1e-8), Some(1e-4), None, Some(0.0)], 2).png().expect("a picture");
        assert_eq!(&png[1..4], b"PNG");
    }

    #[test]
    fn cells_that_do_not_fill_their_rows_are_refused_with_the_numbers() {
        let error = map(vec![Some(1.0); 3], 2).png().expect_err("three cells in rows of two");
        assert!(error.to_string().contains("3 cells do not fill rows of 2"), "{error}");
    }

    #[test]
    fn an_axis_reaches_half_a_cell_beyond_the_outer_centres() {
        let range = Range::centred("h", 1e-4, 1e-1, 4, true);
        // Half a cell is half a decade: a factor √10 on each side.
        assert!((range.low / (1e-4 / 10f64.sqrt()) - 1.0).abs() < 1e-12);
        assert!((range.high / (1e-1 * 10f64.sqrt()) - 1.0).abs() < 1e-12);
        let range = Range::centred("h", 1.0, 3.0, 3, false);
        assert_eq!((range.low, range.high), (0.5, 3.5));
    }
}
