//! Per scene: the error of every quantity at the end of the run against the time step.

use crate::record::Records;
use crate::report::{number, survey};

use super::convergence_panel::{self, label_words};
use super::curves::{self, Quantity};
use super::key::{Key, Row};
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame};
use super::sketch::Sketch;

const WIDTH: f64 = 2600.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;

/// The picture; `None` where no scheme has errors at two steps.
pub(super) fn sketch(records: &Records, palette: &Palette, scene: &str) -> Option<Sketch> {
    let quantities = curves::at_the_end(records, scene);
    let (exact, mut drawn): (Vec<_>, Vec<_>) =
        quantities.into_iter().filter(|one| one.has_a_line() || one.is_exact()).partition(Quantity::is_exact);
    if drawn.is_empty() {
        return None;
    }
    let cells = drawn.len() + usize::from(!exact.is_empty());
    let grid = grid(cells);
    let key = key(palette, &drawn);
    // Rounding says nothing about an order: the table names what is exact.
    drawn.iter_mut().for_each(|quantity| quantity.curves.retain(|curve| !curve.is_exact()));
    let entries = entries(&drawn);
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let strip = key.height(room) + legend::height(&entries, room);
    let bottom = TOP + grid.1 as f64 * row_height(grid);
    let title = survey::title(records, scene);
    let mut sketch = Sketch::new(
        WIDTH,
        bottom + strip + 3.0 * MARGIN,
        format!("{title}: error at the end against the time step"),
    );
    panel::headline(&mut sketch, title, &subtitle(records, scene));
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom };
    for (index, quantity) in drawn.iter().enumerate() {
        convergence_panel::draw(&mut sketch, palette, quantity, all.cell(grid, index));
    }
    if !exact.is_empty() {
        note_exact(&mut sketch, &exact, all.cell(grid, drawn.len()));
    }
    key.draw(&mut sketch, MARGIN + 20.0, bottom + MARGIN, room);
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, bottom + 1.5 * MARGIN + key.height(room), room);
    Some(sketch)
}

/// A row a scheme, with its order in each quantity.
fn key(palette: &Palette, drawn: &[Quantity]) -> Key {
    let curve =
        |quantity: &Quantity, scheme: &str| quantity.curves.iter().position(|curve| curve.scheme == scheme);
    let row = |scheme: &&str| {
        let cell = |quantity: &Quantity| {
            curve(quantity, scheme).map_or(number::NONE.into(), |index| label_words(&quantity.curves[index]))
        };
        let shown = drawn.iter().any(|quantity| curve(quantity, scheme).is_some());
        let cells = drawn.iter().map(cell).collect();
        shown.then(|| Row { look: palette.look(scheme), name: (*scheme).into(), cells })
    };
    let head = |quantity: &Quantity| format!("order of {}", survey::quantity_words(quantity.name));
    Key { heads: drawn.iter().map(head).collect(), rows: palette.schemes().iter().filter_map(row).collect() }
}

/// Columns and rows for so many panels.
fn grid(cells: usize) -> (usize, usize) {
    let columns = match cells {
        0..=3 => cells.max(1),
        4 => 2,
        _ => 3,
    };
    (columns, cells.div_ceil(columns))
}

fn row_height((_, rows): (usize, usize)) -> f64 {
    if rows == 1 { 960.0 } else { 680.0 }
}

fn subtitle(records: &Records, scene: &str) -> String {
    let mut text = format!("{scene} · error at the end of the run against the time step");
    if let Some(row) = survey::scene(records, scene) {
        text += &format!(" · T = {} s", number::setting(row.duration_s));
        if row.not_for_order.is_some() {
            text += " · no order is claimed here";
        }
    }
    text
}

fn entries(drawn: &[Quantity]) -> Vec<Entry> {
    let curves = || drawn.iter().flat_map(|quantity| &quantity.curves);
    let mut entries = Vec::new();
    if curves().any(|curve| curve.rungs.iter().any(|rung| !rung.used)) {
        entries.push(Entry::new(Sign::Hollow, "does not decide the order"));
    }
    if drawn.iter().any(|quantity| !quantity.guide_orders().is_empty()) {
        entries.push(Entry::new(Sign::Guide, "slope of a whole order"));
    }
    if drawn.iter().any(|quantity| quantity.floor().is_some()) {
        entries.push(Entry::new(Sign::Band, "floor: reference or rounding"));
    }
    if curves().any(|curve| !curve.broken.is_empty()) {
        entries.push(Entry::new(Sign::Cross, "run broke"));
    }
    entries
}

fn note_exact(sketch: &mut Sketch, exact: &[Quantity], cell: Frame) {
    let line = |quantity: &Quantity| {
        let largest = quantity.curves.iter().map(|curve| curve.largest()).fold(f64::NEG_INFINITY, f64::max);
        let name = survey::quantity_words(quantity.name);
        if largest == f64::NEG_INFINITY {
            return format!("{name}: no error at all");
        }
        let bound = number::joined(&number::significant(10f64.powf(largest), 2), quantity.unit);
        format!("{name}: error at most {bound}")
    };
    let lines: Vec<String> = exact.iter().map(line).collect();
    panel::words(sketch, cell.inside(50.0, 66.0, 30.0, 110.0), "Exact for every scheme", &lines);
}
