//! One panel of a work-precision picture: one quantity against one kind of work.

use crate::report::ranking::{self, Ladder};

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::legend;
use super::palette::{BAND, GUIDE, INK, Marker, PALE, Palette};
use super::panel::{self, Frame, Panel};
use super::sketch::{Anchor, Place, Sketch};

/// Errors above this, log₁₀, are those of runs that have left the motion: they stand at the upper edge.
pub(super) const HIGHEST: f64 = 2.0;
/// A floor so many decades below the smallest error is not drawn.
pub(super) const FLOOR_IN_SIGHT: f64 = 2.0;

/// What one panel shows.
pub(super) struct View<'a> {
    pub ladders: &'a [Ladder<'a>],
    /// The ladders by evaluations, which every scheme has.
    pub all: &'a [Ladder<'a>],
    pub floor: Option<f64>,
    /// Schemes outside it are grey.
    pub palette: &'a Palette<'a>,
    /// The grey ones on a front, which have numbers.
    pub fronts: &'a [&'a str],
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

impl View<'_> {
    /// Draws the panel.
    pub(super) fn draw(&self, sketch: &mut Sketch, frame: Frame, title: &str, words: &str) {
        if self.ladders.is_empty() {
            panel::words(sketch, frame, "Not timed", &["report --full times every scheme".to_owned()]);
            sketch.text(title, (frame.left, frame.top - 30.0), Anchor::Start, panel::TITLE);
            return;
        }
        let panel = self.panel(frame);
        panel.draw_grid(sketch);
        self.draw_floor(sketch, &panel);
        let (named, grey): (Vec<&Ladder>, Vec<&Ladder>) =
            self.ladders.iter().partition(|ladder| self.palette.schemes().contains(&ladder.scheme));
        for ladder in grey {
            let places = self.places(&panel, ladder);
            places.iter().for_each(|place| sketch.marker(Marker::Disc, *place, 5.0, GUIDE, true));
            sketch.line(places, PALE, 2.5);
        }
        for ladder in &named {
            let look = self.palette.look(ladder.scheme);
            sketch.stroke(self.places(&panel, ladder), look.ink, 4.0, look.dash);
        }
        let front = ranking::front(self.ladders);
        sketch.line(stairs(&front, &panel), INK, 5.0);
        for ladder in named {
            self.draw_markers(sketch, &panel, ladder);
        }
        self.draw_numbers(sketch, &panel, &front);
        panel.draw_frame(sketch);
        self.draw_broken(sketch, &panel);
        panel.label_x(sketch, words);
        panel.label_y(sketch);
        panel.title(sketch, title);
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
        let head = (0.05 + 0.05 * self.broken().count().min(4) as f64) * (high - low).max(2.0);
        Panel {
            frame,
            x: Axis::logarithmic(left - 0.15, right + 0.15, 6),
            y: Axis::logarithmic(low - 0.4, high + head, 8),
        }
    }

    fn places(&self, panel: &Panel, ladder: &Ladder) -> Vec<Place> {
        ladder.points.iter().map(|point| panel.place(point.work, point.error.min(HIGHEST))).collect()
    }

    fn draw_markers(&self, sketch: &mut Sketch, panel: &Panel, ladder: &Ladder) {
        const RADIUS: f64 = 9.0;
        let look = self.palette.look(ladder.scheme);
        for (place, point) in self.places(panel, ladder).into_iter().zip(&ladder.points) {
            if point.error > HIGHEST {
                sketch.arrow(place, RADIUS + 2.0, look.ink);
            } else {
                sketch.marker(look.marker, place, RADIUS, look.ink, !point.lost);
            }
        }
    }

    /// A scheme without a colour has its number at its first place on the front.
    fn draw_numbers(&self, sketch: &mut Sketch, panel: &Panel, front: &[(&str, f64, f64)]) {
        for (index, scheme) in self.fronts.iter().enumerate() {
            if let Some((_, work, error)) = front.iter().find(|(name, ..)| name == scheme) {
                legend::numbered(sketch, panel.place(*work, error.min(HIGHEST)), index + 1);
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

    fn broken(&self) -> impl Iterator<Item = &Ladder<'_>> {
        self.ladders.iter().filter(|ladder| !ladder.broken.is_empty())
    }

    /// Crosses at the upper edge where runs broke; those of several schemes stand one under another.
    fn draw_broken(&self, sketch: &mut Sketch, panel: &Panel) {
        for (row, ladder) in self.broken().enumerate() {
            let is_named = self.palette.schemes().contains(&ladder.scheme);
            let ink = if is_named { self.palette.look(ladder.scheme).ink } else { PALE };
            for work in &ladder.broken {
                let place = (panel.across(*work), panel.frame.top + 18.0 + 24.0 * (row % 4) as f64);
                sketch.cross(place, 8.0, ink);
            }
        }
    }
}
