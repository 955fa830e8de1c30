//! Lines: a number against a number, a line for each name.

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame, Panel};
use super::render::{self, Fault};
use super::sketch::{Place, Sketch};
use crate::report::{DrawingError, survey};

/// A picture of lines, in one panel or in several side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct LineChart {
    /// Title.
    pub title: String,
    /// The line under it.
    pub subtitle: String,
    /// What the picture shows, for those who cannot see it.
    pub description: String,
    /// The panels, from left to right. Lines of one name have one look in all of them.
    pub panels: Vec<LinePanel>,
}

/// A panel of lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LinePanel {
    /// Name and unit of the horizontal axis.
    pub across: String,
    /// Whether equal distances on it are equal ratios.
    pub across_logarithmic: bool,
    /// Name and unit of the vertical axis, which is logarithmic.
    pub up: String,
    /// The lines.
    pub lines: Vec<Line>,
}

/// A line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name.
    pub words: String,
    /// Its points, from left to right or from right to left; a point without a value stands at the upper edge as a cross and
    /// breaks the line.
    pub points: Vec<(f64, Option<f64>)>,
}

const WIDTH: f64 = 1800.0;
/// Markers on a piece of a line, at the most.
const MARKERS: usize = 40;
const HEIGHT: f64 = 1240.0;
const MARGIN: f64 = 30.0;

impl LineChart {
    /// The picture as PNG bytes.
    ///
    /// # Errors
    /// A backend that fails.
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        super::font::register().map_err(|why| Fault(why.into()))?;
        Ok(render::png(&self.sketch())?)
    }

    pub(super) fn sketch(&self) -> Sketch {
        let lines = || self.panels.iter().flat_map(|panel| &panel.lines);
        let palette = Palette::new(survey::distinct(lines().map(|line| line.words.as_str())));
        let mut entries: Vec<Entry> = palette
            .schemes()
            .iter()
            .map(|name| Entry::new(Sign::Scheme(palette.look(name)), *name))
            .collect();
        if lines().any(|line| line.points.iter().any(|(_, value)| value.is_none())) {
            entries.push(Entry::new(Sign::Cross, "no value: the run broke"));
        }
        let width = if self.panels.len() > 1 { 2600.0 } else { WIDTH };
        let room = width - 2.0 * MARGIN - 20.0;
        let strip = legend::height(&entries, room);
        let mut sketch = Sketch::new(width, HEIGHT + strip, self.description.clone());
        panel::headline(&mut sketch, &self.title, &self.subtitle);
        let all = Frame { left: MARGIN, top: 150.0, right: width - MARGIN, bottom: HEIGHT - 20.0 };
        for (index, panel) in self.panels.iter().enumerate() {
            panel.draw(&mut sketch, &palette, all.cell((self.panels.len(), 1), index));
        }
        legend::draw(&mut sketch, &entries, MARGIN + 20.0, HEIGHT - MARGIN, room);
        sketch
    }
}

impl LinePanel {
    fn draw(&self, sketch: &mut Sketch, palette: &Palette, cell: Frame) {
        let frame = cell.inside(140.0, 60.0, 30.0, 130.0);
        let panel = self.panel(frame);
        panel.draw_grid(sketch);
        for line in &self.lines {
            self.draw_line(sketch, &panel, palette, line);
        }
        panel.draw_frame(sketch);
        panel.label_x(sketch, &self.across);
        panel.label_y(sketch);
        panel.title(sketch, &self.up);
    }

    fn panel(&self, frame: Frame) -> Panel {
        let points = || self.lines.iter().flat_map(|line| &line.points);
        let across: Vec<f64> = points().map(|(x, _)| self.on(*x)).filter(|x| x.is_finite()).collect();
        let up: Vec<f64> =
            points().filter_map(|(_, y)| y.map(f64::log10)).filter(|y| y.is_finite()).collect();
        let ((left, right), (low, high)) = (bounds(&across), bounds(&up));
        let margin = 0.03 * (right - left).max(1e-12);
        let x = if self.across_logarithmic {
            Axis::logarithmic(left - margin, right + margin, 8)
        } else {
            Axis::linear(left - margin, right + margin, 8)
        };
        Panel { frame, x, y: Axis::logarithmic(low - 0.15, high + 0.3, 9) }
    }

    fn on(&self, x: f64) -> f64 {
        if self.across_logarithmic { x.log10() } else { x }
    }

    fn place(&self, panel: &Panel, (x, y): (f64, Option<f64>)) -> Option<Place> {
        let y = y.filter(|y| *y > 0.0)?;
        Some(panel.place(self.on(x), y.log10()))
    }

    fn draw_line(&self, sketch: &mut Sketch, panel: &Panel, palette: &Palette, line: &Line) {
        let look = palette.look(&line.words);
        let gap = |point: &(f64, Option<f64>)| self.place(panel, *point).is_none();
        for piece in line.points.split(gap) {
            let places: Vec<Place> = piece.iter().filter_map(|point| self.place(panel, *point)).collect();
            if places.len() > 1 {
                sketch.stroke(places.clone(), look.ink, 4.0, look.dash);
            }
            // More would cover the line.
            for place in places.iter().step_by(places.len().div_ceil(MARKERS).max(1)) {
                sketch.marker(look.marker, *place, 8.0, look.ink, true);
            }
        }
        for (x, _) in line.points.iter().filter(|(_, value)| value.is_none()) {
            sketch.cross((panel.across(self.on(*x)), panel.frame.top + 22.0), 8.0, look.ink);
        }
    }
}
