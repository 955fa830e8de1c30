//! Errors against the step in single and in double precision, beside truncation alone: a panel a scene.

use crate::record::{PrecisionRow, PrecisionRun, Records};
use crate::report::survey;

use super::axis::Axis;
use super::convergence_panel::bounds;
use super::legend::{self, Entry, Sign};
use super::palette::{Palette, tint};
use super::panel::{self, Frame, Panel};
use super::sketch::{Place, Sketch};

const WIDTH: f64 = 3000.0;
const MARGIN: f64 = 40.0;
const TOP: f64 = 150.0;
const BODY: f64 = 1150.0;
/// Widths of the lines of f32 and of f64, and of the band of truncation under them.
const SINGLE: f64 = 4.0;
const DOUBLE: f64 = 3.0;
const TRUNCATION: f64 = 12.0;

/// The picture; `None` where precision was not studied.
pub(super) fn sketch(records: &Records, palette: &Palette) -> Option<Sketch> {
    let rows = &records.precision;
    let scenes = survey::distinct(rows.iter().map(|row| row.scene.as_str()));
    if scenes.is_empty() {
        return None;
    }
    let shown = |name: &&&str| rows.iter().any(|row| row.scheme == **name);
    let mut entries: Vec<Entry> = palette
        .schemes()
        .iter()
        .filter(shown)
        .map(|name| Entry::new(Sign::Scheme(palette.look(name)), *name))
        .collect();
    entries.push(Entry::new(Sign::Filled, "with markers: f32"));
    entries.push(Entry::new(Sign::Front, "thin line: f64"));
    entries.push(Entry::new(Sign::Band, "pale band: truncation alone, in double-double"));
    let room = WIDTH - 2.0 * MARGIN;
    let strip = legend::height(&entries, room);
    let bottom = TOP + BODY;
    let mut sketch = Sketch::new(
        WIDTH,
        bottom + strip + MARGIN,
        "Errors in single and in double precision against the step".into(),
    );
    panel::headline(
        &mut sketch,
        "Single precision: below a smallest useful step rounding makes the error worse",
        "largest orientation error over the run [rad] against the step",
    );
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom };
    for (index, scene) in scenes.iter().enumerate() {
        let own: Vec<&PrecisionRow> = rows.iter().filter(|row| row.scene == *scene).collect();
        let frame = all.cell((scenes.len(), 1), index).inside(100.0, 66.0, 20.0, 110.0);
        draw(&mut sketch, palette, frame, &own, survey::title(records, scene), extent(rows));
    }
    legend::draw(&mut sketch, &entries, MARGIN, bottom + 10.0, room);
    Some(sketch)
}

/// log₁₀ of the step and of the error of the runs that came to their end.
fn points(row: &PrecisionRow) -> Vec<(f64, f64)> {
    let point = |run: &PrecisionRun| {
        let error = run.error_rad.filter(|error| *error > 0.0 && error.is_finite())?;
        Some((run.step_s.log10(), error.log10()))
    };
    row.runs.iter().filter_map(point).collect()
}

/// The least and the greatest log₁₀ of the errors of all panels, which share their vertical axis.
fn extent(rows: &[PrecisionRow]) -> (f64, f64) {
    bounds(&rows.iter().flat_map(points).map(|(_, error)| error).collect::<Vec<_>>())
}

fn draw(
    sketch: &mut Sketch,
    palette: &Palette,
    frame: Frame,
    rows: &[&PrecisionRow],
    title: &str,
    (low, high): (f64, f64),
) {
    let steps: Vec<f64> = rows.iter().flat_map(|row| points(row)).map(|(step, _)| step).collect();
    let (left, right) = bounds(&steps);
    let panel = Panel {
        frame,
        x: Axis::logarithmic(left - 0.12, right + 0.12, 6),
        y: Axis::logarithmic(low - 0.4, high + 0.4, 9),
    };
    panel.draw_grid(sketch);
    // Truncation lies under the lines that leave it.
    for layer in ["double-double", "f64", "f32"] {
        for row in rows.iter().filter(|row| row.arithmetic == layer) {
            let look = palette.look(&row.scheme);
            let places: Vec<Place> = points(row).into_iter().map(|(x, y)| panel.place(x, y)).collect();
            let (ink, width) = match layer {
                "f32" => (look.ink, SINGLE),
                "f64" => (look.ink, DOUBLE),
                _ => (tint(look.ink, 0.25), TRUNCATION),
            };
            if places.len() > 1 {
                sketch.stroke(
                    places.clone(),
                    ink,
                    width,
                    if layer == "double-double" { &[] } else { look.dash },
                );
            }
            if layer == "f32" {
                for place in places {
                    sketch.marker(look.marker, place, 8.0, look.ink, true);
                }
            }
        }
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, "step h [s]");
    panel.label_y(sketch);
    let room = frame.right - frame.left;
    panel.title(sketch, &panel::fitted(title, panel::TITLE, room));
}
