//! A motion as a picture: the polhode on the inertia ellipsoid, the path of an axis in space, Ω and energy against time.

use std::f64::consts::TAU;

use plotters::style::RGBColor;

use super::axis::Axis;
use super::legend::{self, Entry, Sign};
use super::palette::{GRID, GUIDE, Look, Marker, Palette, tint};
use super::panel::{self, Frame, Panel};
use super::render;
use super::sketch::{Place, Sketch};
use crate::record::Motion;
use crate::report::DrawingError;

const WIDTH: f64 = 2400.0;
const HEIGHT: f64 = 2100.0;
const MARGIN: f64 = 30.0;
/// Where the eye stands: the angle around the vertical, and the one above the horizon [rad].
const EYE: (f64, f64) = (0.9, 0.35);
/// A point in space.
type Point = [f64; 3];

/// The picture of a motion as PNG bytes.
///
/// # Errors
/// The bundled typeface cannot be read, or the backend fails.
pub fn motion_picture(motion: &Motion) -> Result<Vec<u8>, DrawingError> {
    super::font::register().map_err(|why| render::Fault(why.into()))?;
    Ok(render::png(&sketch(motion))?)
}

fn sketch(motion: &Motion) -> Sketch {
    let title = format!("{} in {}", motion.scheme, motion.scene);
    let mut sketch = Sketch::new(WIDTH, HEIGHT, title.clone());
    let end = motion.time_s.last().copied().unwrap_or_default();
    let subtitle = format!(
        "h = {} s, {} states up to t = {} s; paths begin at the disc",
        crate::report::number::setting(motion.step_s),
        motion.time_s.len(),
        crate::report::number::setting(end)
    );
    panel::headline(&mut sketch, &title, &subtitle);
    let all = Frame { left: MARGIN, top: 150.0, right: WIDTH - MARGIN, bottom: HEIGHT - MARGIN };
    let cell = |index| all.cell((2, 2), index);
    let palette = Palette::new(NAMES.to_vec());
    let look = palette.look(NAMES[0]);
    draw_polhode(&mut sketch, cell(0), motion, look.ink);
    draw_axis(&mut sketch, cell(1), motion, look.ink);
    draw_spin(&mut sketch, cell(2), motion, &palette);
    draw_energy(&mut sketch, cell(3), motion, look);
    sketch
}

/// The components of Ω.
const NAMES: [&str; 3] = ["Ω₁", "Ω₂", "Ω₃"];

/// A view of space in a frame: across, up, and the depth towards the eye.
struct View {
    centre: Place,
    radius: f64,
}

impl View {
    fn of(cell: Frame) -> View {
        let radius = 0.42 * (cell.right - cell.left).min(cell.bottom - cell.top - 80.0);
        let (x, y) = cell.centre();
        View { centre: (x, y + 30.0), radius }
    }

    fn place(&self, [x, y, z]: Point) -> (Place, f64) {
        let (around, above) = EYE;
        let across = -around.sin() * x + around.cos() * y;
        let away = around.cos() * x + around.sin() * y;
        let up = above.cos() * z - above.sin() * away;
        let depth = above.cos() * away + above.sin() * z;
        ((self.centre.0 + self.radius * across, self.centre.1 - self.radius * up), depth)
    }

    /// A path; what lies behind is pale.
    fn trace(&self, sketch: &mut Sketch, path: &[Point], ink: RGBColor, width: f64) {
        for behind in [true, false] {
            let ink = if behind { tint(ink, 0.4) } else { ink };
            let places: Vec<(Place, f64)> = path.iter().map(|point| self.place(*point)).collect();
            for pair in places.windows(2).filter(|pair| (pair[1].1 < 0.0) == behind) {
                sketch.line(vec![pair[0].0, pair[1].0], ink, width);
            }
        }
    }

    /// A path with a disc at its start.
    fn path(&self, sketch: &mut Sketch, path: &[Point], ink: RGBColor) {
        self.trace(sketch, path, ink, 4.0);
        if let Some((place, depth)) = path.first().map(|start| self.place(*start)) {
            sketch.marker(Marker::Disc, place, 11.0, if depth < 0.0 { tint(ink, 0.4) } else { ink }, true);
        }
    }

    /// Circles of latitude and longitude on an ellipsoid of these half axes.
    fn globe(&self, sketch: &mut Sketch, half: Point) {
        let ring = |point: &dyn Fn(f64) -> Point| -> Vec<Point> {
            let at = |n: i32| {
                let point = point(TAU * f64::from(n) / 72.0);
                [point[0] * half[0], point[1] * half[1], point[2] * half[2]]
            };
            (0..=72).map(at).collect()
        };
        for level in -3..=3 {
            let (s, c) = (f64::from(level) * TAU / 16.0).sin_cos();
            self.trace(sketch, &ring(&|t| [c * t.cos(), c * t.sin(), s]), GUIDE, 1.5);
        }
        for plane in 0..6 {
            let (s, c) = (f64::from(plane) * TAU / 12.0).sin_cos();
            self.trace(sketch, &ring(&|t| [c * t.cos(), s * t.cos(), t.sin()]), GUIDE, 1.5);
        }
    }
}

fn title(sketch: &mut Sketch, cell: Frame, words: &str) {
    let place = (cell.left + 20.0, cell.top + 30.0);
    sketch.text(words, place, super::sketch::Anchor::Start, panel::TITLE);
}

fn draw_polhode(sketch: &mut Sketch, cell: Frame, motion: &Motion, ink: RGBColor) {
    title(sketch, cell, "Polhode on the inertia ellipsoid, principal axes");
    let most = motion.spin.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
    let energy = 2.0 * motion.energies().first().copied().unwrap_or_default();
    let half = motion.moments.map(|moment| if moment > 0.0 { (energy / moment).sqrt() } else { 0.0 });
    let scale = half.iter().copied().fold(most, f64::max);
    if scale > 0.0 {
        let view = View::of(cell);
        view.globe(sketch, half.map(|edge| edge / scale));
        let path: Vec<Point> = motion.spins().map(|w| [w[0] / scale, w[1] / scale, w[2] / scale]).collect();
        view.path(sketch, &path, ink);
    }
}

fn draw_axis(sketch: &mut Sketch, cell: Frame, motion: &Motion, ink: RGBColor) {
    title(sketch, cell, "Path in space of the axis of the largest moment");
    let largest = (0..3).max_by(|a, b| motion.moments[*a].total_cmp(&motion.moments[*b])).unwrap_or(2);
    // A column of the rotation matrix of the quaternion.
    let axis = |q: &[f64]| {
        let (w, v) = (q[0], [q[1], q[2], q[3]]);
        let mut along = v.map(|one| 2.0 * v[largest] * one);
        along[largest] += 2.0 * w * w - 1.0;
        let (next, last) = ((largest + 1) % 3, (largest + 2) % 3);
        along[next] += 2.0 * w * v[last];
        along[last] -= 2.0 * w * v[next];
        along
    };
    let view = View::of(cell);
    view.globe(sketch, [1.0; 3]);
    view.path(sketch, &motion.turns().map(axis).collect::<Vec<_>>(), ink);
}

/// The values of a line and its look.
type Curve = (Vec<f64>, Look);
/// Markers on a line, so that it is found in the legend without colour.
const MARKERS: usize = 10;

fn draw_spin(sketch: &mut Sketch, cell: Frame, motion: &Motion, palette: &Palette) {
    let curve = |index: usize| {
        let name = NAMES[index];
        (motion.spins().map(|spin| spin[index]).collect(), palette.look(name))
    };
    let curves: Vec<Curve> = (0..3).map(curve).collect();
    draw_curves(sketch, cell, motion, &curves, "Ω in principal axes [rad/s]");
    let sign = |(index, name): (usize, &&str)| Entry::new(Sign::Scheme(palette.look(NAMES[index])), *name);
    let entries: Vec<Entry> = NAMES.iter().enumerate().map(sign).collect();
    legend::draw(sketch, &entries, cell.left + 200.0, cell.bottom - 64.0, cell.right - cell.left - 260.0);
}

fn draw_energy(sketch: &mut Sketch, cell: Frame, motion: &Motion, look: Look) {
    let energies = motion.energies();
    let first = energies.first().copied().unwrap_or_default();
    if first > 0.0 {
        let change = energies.iter().map(|energy| energy / first - 1.0).collect();
        draw_curves(sketch, cell, motion, &[(change, look)], "Relative change of the rotational energy");
    }
}

fn draw_curves(sketch: &mut Sketch, cell: Frame, motion: &Motion, curves: &[Curve], words: &str) {
    let values = || curves.iter().flat_map(|(values, _)| values).copied().filter(|value| value.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let margin = if high > low { 0.05 * (high - low) } else { 1e-16 + 0.05 * high.abs() };
    let end = motion.time_s.last().copied().unwrap_or(1.0);
    let panel = Panel {
        frame: cell.inside(190.0, 70.0, 40.0, 190.0),
        x: Axis::linear(0.0, end, 6),
        y: Axis::linear(low - margin, high + margin, 7),
    };
    panel.draw_grid(sketch);
    if low < 0.0 && high > 0.0 {
        let (left, right) = (panel.frame.left, panel.frame.right);
        sketch.line(vec![(left, panel.along(0.0)), (right, panel.along(0.0))], tint(GRID, 1.0), 3.0);
    }
    for (values, look) in curves {
        let finite = motion.time_s.iter().zip(values).filter(|(_, value)| value.is_finite());
        let places: Vec<Place> = finite.map(|(time, value)| panel.place(*time, *value)).collect();
        for place in places.iter().step_by(places.len().div_ceil(MARKERS).max(1)) {
            sketch.marker(look.marker, *place, 8.0, look.ink, true);
        }
        sketch.line(places, look.ink, 3.0);
    }
    panel.draw_frame(sketch);
    panel.label_x(sketch, "time [s]");
    panel.label_y(sketch);
    panel.title(sketch, words);
}
