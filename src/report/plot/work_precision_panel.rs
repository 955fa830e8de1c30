//! One panel of a work-precision picture: one quantity against one kind of work.

use crate::report::ranking::{self, Ladder};
use crate::report::survey;

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::labels::{self, Label};
use super::palette::{BAND, INK, Look, Palette, tint};
use super::panel::{self, Frame, Panel};
use super::sketch::{Anchor, Place, Sketch};
use super::work_precision::Cast;

/// Errors above this, log₁₀, are those of runs that have left the motion: they stand at the upper edge.
pub(super) const HIGHEST: f64 = 2.0;
/// A floor so many decades below the smallest error is told in words.
pub(super) const FLOOR_IN_SIGHT: f64 = 2.0;

/// Which names stand beside a panel.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Names {
    /// None.
    None,
    /// The schemes that hold a place on the front.
    Front,
    /// Every scheme, at its line's right end.
    Ends,
}

/// What one panel shows.
pub(super) struct View<'a> {
    pub ladders: &'a [Ladder<'a>],
    /// The ladders by step, which every scheme has.
    pub all: &'a [Ladder<'a>],
    pub floor: Option<f64>,
    pub front: bool,
    pub names: Names,
    pub cast: Cast,
}

/// The name that a ladder has its look by.
pub(super) fn name<'a>(ladder: &Ladder<'a>, cast: Cast) -> &'a str {
    if cast == Cast::Main { ladder.scheme } else { ladder.family }
}

/// A front as stairs: between two of its points the error of the first is the best there is.
fn stairs(front: &[(&str, f64, f64)], panel: &Panel) -> Vec<Place> {
    let mut places: Vec<Place> = Vec::new();
    for (_, work, error) in front {
        let (x, y) = panel.place(*work, error.min(HIGHEST));
        if let Some((_, before)) = places.last() {
            places.push((x, *before));
        }
        places.push((x, y));
    }
    places
}

/// The names that stand beside a panel.
pub(super) fn names<'a>(ladders: &[Ladder<'a>], names: Names) -> Vec<&'a str> {
    match names {
        Names::None => Vec::new(),
        Names::Front => survey::distinct(ranking::front(ladders).into_iter().map(|(scheme, ..)| scheme)),
        Names::Ends => ladders.iter().map(|ladder| ladder.scheme).collect(),
    }
}

impl View<'_> {
    /// Draws the panel.
    pub(super) fn draw(
        &self,
        sketch: &mut Sketch,
        palette: &Palette,
        frame: Frame,
        title: &str,
        words: &str,
    ) {
        if self.ladders.is_empty() {
            panel::words(sketch, frame, "Not timed", &["report --full times every scheme".to_owned()]);
            sketch.text(title, (frame.left, frame.top - 30.0), Anchor::Start, panel::TITLE);
            return;
        }
        let panel = self.panel(frame);
        panel.draw_grid(sketch);
        self.draw_floor(sketch, &panel);
        for ladder in self.ladders {
            let look = self.look(palette, ladder);
            let thin = if self.cast == Cast::Main { 4.0 } else { 2.5 };
            let ink = if self.cast == Cast::Main { look.ink } else { tint(look.ink, 0.7) };
            sketch.line(self.places(&panel, ladder), ink, thin);
        }
        if self.front {
            let front = ranking::front(self.ladders);
            sketch.line(stairs(&front, &panel), INK, 4.0);
        }
        for ladder in self.ladders {
            self.draw_markers(sketch, &panel, self.look(palette, ladder), ladder);
        }
        panel.draw_frame(sketch);
        self.draw_broken(sketch, palette, &panel);
        panel.label_x(sketch, words);
        panel.label_y(sketch);
        panel.title(sketch, title);
        labels::draw(sketch, frame, self.labels(palette, &panel));
    }

    fn look(&self, palette: &Palette, ladder: &Ladder) -> Look {
        palette.look(name(ladder, self.cast))
    }

    fn panel(&self, frame: Frame) -> Panel {
        let points = || self.ladders.iter().flat_map(|ladder| &ladder.points);
        let broken = self.ladders.iter().flat_map(|ladder| &ladder.broken).copied();
        let works: Vec<f64> = points().map(|point| point.work).chain(broken).collect();
        // All columns of a row have the same errors, whatever was timed.
        let errors: Vec<f64> =
            self.all.iter().flat_map(|ladder| &ladder.points).map(|point| point.error.min(HIGHEST)).collect();
        let ((left, right), (mut low, high)) = (bounds(&works), bounds(&errors));
        if let Some(floor) = self.floor.filter(|floor| *floor < low && low - floor < FLOOR_IN_SIGHT) {
            low = floor;
        }
        let head = (0.05 + 0.05 * self.broken_names().len().min(4) as f64) * (high - low).max(2.0);
        Panel {
            frame,
            x: Axis::logarithmic(left - 0.15, right + 0.15, 6),
            y: Axis::logarithmic(low - 0.4, high + head, 8),
        }
    }

    fn places(&self, panel: &Panel, ladder: &Ladder) -> Vec<Place> {
        ladder.points.iter().map(|point| panel.place(point.work, point.error.min(HIGHEST))).collect()
    }

    fn draw_markers(&self, sketch: &mut Sketch, panel: &Panel, look: Look, ladder: &Ladder) {
        let radius = if self.cast == Cast::Main { 9.0 } else { 6.0 };
        for (place, point) in self.places(panel, ladder).into_iter().zip(&ladder.points) {
            if point.error > HIGHEST {
                sketch.arrow(place, radius + 2.0, look.ink);
            } else {
                sketch.marker(look.marker, place, radius, look.ink, !point.lost);
            }
        }
    }

    fn draw_floor(&self, sketch: &mut Sketch, panel: &Panel) {
        let Some(floor) = self.floor else { return };
        let Frame { left, right, bottom, .. } = panel.frame;
        if floor > panel.y.low {
            sketch.area((left, panel.along(floor.min(panel.y.high))), (right, bottom), BAND);
        }
    }

    fn broken_names(&self) -> Vec<&str> {
        let broken = self.ladders.iter().filter(|ladder| !ladder.broken.is_empty());
        survey::distinct(broken.map(|ladder| name(ladder, self.cast)))
    }

    /// Crosses at the upper edge where runs broke; those of several schemes stand one under another.
    fn draw_broken(&self, sketch: &mut Sketch, palette: &Palette, panel: &Panel) {
        let names = self.broken_names();
        for ladder in self.ladders {
            let row = names.iter().position(|one| *one == name(ladder, self.cast)).unwrap_or_default() % 4;
            for work in &ladder.broken {
                let place = (panel.across(*work), panel.frame.top + 18.0 + 24.0 * row as f64);
                sketch.cross(place, 8.0, self.look(palette, ladder).ink);
            }
        }
    }

    fn labels(&self, palette: &Palette, panel: &Panel) -> Vec<Label> {
        let label = |ladder: &Ladder, end: Place| Label {
            words: ladder.scheme.to_owned(),
            end,
            look: self.look(palette, ladder),
        };
        match self.names {
            Names::None => Vec::new(),
            Names::Ends => self
                .ladders
                .iter()
                .filter_map(|ladder| Some(label(ladder, *self.places(panel, ladder).last()?)))
                .collect(),
            // A scheme is named at its last place on the front.
            Names::Front => {
                let front = ranking::front(self.ladders);
                let last = |ladder: &&Ladder| front.iter().rev().find(|(name, ..)| *name == ladder.scheme);
                let held = self.ladders.iter().filter_map(|ladder| Some((ladder, last(&ladder)?)));
                held.map(|(ladder, (_, x, y))| label(ladder, panel.place(*x, y.min(HIGHEST)))).collect()
            }
        }
    }
}
