//! Per scene: the error of every scheme against its work, in force evaluations and in nanoseconds a simulated second. A scheme
//! is a line in the colour of its family; the Pareto front, where no scheme reaches a smaller error for less work, is drawn
//! over them and named.

use crate::record::Records;
use crate::report::ranking::{self, Ladder, Work};
use crate::report::survey;

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::labels::{self, Label};
use super::legend::{self, Entry, Sign};
use super::palette::{INK, Palette, tint};
use super::panel::{self, Frame, Panel};
use super::sketch::{Place, Sketch};

const WIDTH: f64 = 2600.0;
const HEIGHT: f64 = 1500.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;

/// The picture; `None` where fewer than two schemes have errors.
pub(super) fn sketch(records: &Records, scene: &str) -> Option<Sketch> {
    let [counted, timed] = Work::ALL.map(|work| ranking::ladders(records, scene, work));
    if counted.len() < 2 {
        return None;
    }
    let palette = Palette::new(survey::distinct(counted.iter().map(|ladder| ladder.family)));
    let title = survey::title(records, scene);
    let quantity = survey::quantity_words(ranking::quantity(records, scene));
    let mut sketch = Sketch::new(WIDTH, HEIGHT, format!("{title}: error against work"));
    let subtitle =
        format!("{scene} · error of the {quantity} at the end against work · black: nothing better for less");
    panel::headline(&mut sketch, title, &subtitle);
    let mut entries: Vec<Entry> = palette
        .schemes()
        .iter()
        .map(|family| Entry::new(Sign::Scheme(palette.look(family)), *family))
        .collect();
    entries.push(Entry::new(Sign::Hollow, "at the floor of reference or rounding"));
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let strip = legend::height(&entries, room);
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom: HEIGHT - strip - 2.0 * MARGIN };
    let panels = [
        (&counted, "force evaluations a simulated second"),
        (&timed, "nanoseconds a simulated second (this machine)"),
    ];
    for (index, (ladders, words)) in panels.into_iter().enumerate() {
        draw(&mut sketch, &palette, ladders, all.cell((2, 1), index), words);
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, HEIGHT - strip - MARGIN, room);
    Some(sketch)
}

fn draw(sketch: &mut Sketch, palette: &Palette, ladders: &[Ladder], cell: Frame, words: &str) {
    let front = front(ladders);
    let names: Vec<&str> = survey::distinct(front.iter().map(|(scheme, ..)| *scheme));
    let frame = cell.inside(128.0, 40.0, labels::column_width(names.iter().copied()), 110.0);
    let points = || ladders.iter().flat_map(|ladder| &ladder.points);
    let (left, right) = bounds(&points().map(|point| point.work).collect::<Vec<_>>());
    let (low, high) = bounds(&points().map(|point| point.error).collect::<Vec<_>>());
    let panel = Panel {
        frame,
        x: Axis::logarithmic(left - 0.15, right + 0.15, 6),
        y: Axis::logarithmic(low - 0.4, high + 0.4, 8),
    };
    panel.draw_grid(sketch);
    for ladder in ladders {
        let look = palette.look(ladder.family);
        let places: Vec<Place> = ladder.points.iter().map(|p| panel.place(p.work, p.error)).collect();
        sketch.line(places.clone(), tint(look.ink, 0.7), 3.0);
        for (place, point) in places.into_iter().zip(&ladder.points) {
            sketch.marker(look.marker, place, 7.0, look.ink, !point.lost);
        }
    }
    let line: Vec<Place> = front.iter().map(|(_, work, error)| panel.place(*work, *error)).collect();
    sketch.line(line, INK, 5.0);
    panel.draw_frame(sketch);
    panel.label_x(sketch, words);
    panel.label_y(sketch);
    let family = |name: &str| ladders.iter().find(|l| l.scheme == name).map_or("", |l| l.family);
    // A scheme is named at its last place on the front.
    let ends = names.iter().filter_map(|name| {
        let (_, work, error) = front.iter().rev().find(|(scheme, ..)| scheme == name)?;
        let end = panel.place(*work, *error);
        Some(Label { words: (*name).into(), end, look: palette.look(family(name)) })
    });
    labels::draw(sketch, frame, ends.collect());
}

/// The points that no other beats in work and error both, work rising: scheme, log₁₀ work, log₁₀ error.
fn front<'a>(ladders: &[Ladder<'a>]) -> Vec<(&'a str, f64, f64)> {
    let mut points: Vec<(&str, f64, f64)> = ladders
        .iter()
        .flat_map(|ladder| ladder.points.iter().filter(|p| !p.lost).map(|p| (ladder.scheme, p.work, p.error)))
        .collect();
    points.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2)));
    let mut least = f64::INFINITY;
    points.retain(|(_, _, error)| {
        let better = *error < least;
        least = least.min(*error);
        better
    });
    points
}
