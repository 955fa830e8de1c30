//! The overview of cost: for each decade of error, the cheapest scheme in each family.

use crate::record::Records;
use crate::report::ranking::{self, Ladder, Work};
use crate::report::{number, survey};

use super::axis::Axis;
use super::colour_map::viridis;
use super::palette::{GRID, INK, SOFT};
use super::panel::{self, Frame};
use super::sketch::{Anchor, Sketch, Type};

const WIDTH: f64 = 2600.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 40.0;
/// Column of the families' names.
const NAMES: f64 = 270.0;
const CELL: f64 = 118.0;
/// Over the cells of a scene: its title and the decades.
const HEAD: f64 = 120.0;
/// The decades of error, log₁₀.
const DECADES: [i32; 11] = [-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11];
/// Scenes in the picture, at most.
const MOST_SCENES: usize = 3;

/// The cheapest scheme of a family for an error, and log₁₀ of its work.
pub(in crate::report) type Cheapest<'a> = Option<(&'a str, f64)>;

/// A scene's table: the families, and for each of them what every decade costs.
pub(in crate::report) struct Table<'a> {
    /// The scene.
    pub scene: &'a str,
    /// Family and its cells, in the order of the decades.
    pub families: Vec<(&'a str, Vec<Cheapest<'a>>)>,
}

/// The tables of the scenes on which most schemes were run and that carry an order, of three different models.
pub(in crate::report) fn tables(records: &Records, work: Work) -> Vec<Table<'_>> {
    let mut tables: Vec<(usize, &str, Table)> = Vec::new();
    for row in records.scenes.iter().filter(|row| row.not_for_order.is_none()) {
        let metric = ranking::quantity(records, &row.name);
        let ladders = ranking::ladders(records, &row.name, metric, work);
        tables.push((ladders.len(), &row.model, table(&row.name, &ladders)));
    }
    // The sort is stable: of scenes with as many schemes the first of the records come first.
    tables.sort_by_key(|(schemes, ..)| std::cmp::Reverse(*schemes));
    let mut chosen: Vec<(&str, Table)> = Vec::new();
    for (_, model, table) in tables {
        let new = chosen.iter().all(|(other, _)| *other != model);
        if new && table.families.len() > 1 && chosen.len() < MOST_SCENES {
            chosen.push((model, table));
        }
    }
    chosen.into_iter().map(|(_, table)| table).collect()
}

fn table<'a>(scene: &'a str, ladders: &[Ladder<'a>]) -> Table<'a> {
    let cheapest = |family: &str, decade: i32| {
        let own = ladders.iter().filter(|ladder| ladder.family == family);
        let costs = own.filter_map(|ladder| Some((ladder.scheme, ladder.work_for(f64::from(decade))?)));
        costs.min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let families = survey::distinct(ladders.iter().map(|ladder| ladder.family))
        .into_iter()
        .map(|family| (family, DECADES.map(|decade| cheapest(family, decade)).to_vec()))
        .collect();
    Table { scene, families }
}

/// The picture; `None` where no scene has two families.
pub(super) fn sketch(records: &Records, work: Work) -> Option<Sketch> {
    let tables = tables(records, work);
    if tables.is_empty() {
        return None;
    }
    let rows: usize = tables.iter().map(|table| table.families.len()).sum();
    let height = TOP + rows as f64 * CELL + tables.len() as f64 * (HEAD + MARGIN) + 60.0;
    let unit = match work {
        Work::Nanoseconds => "nanoseconds a simulated second",
        _ => "force evaluations a simulated second",
    };
    let title = "What an error costs: the cheapest scheme of each family";
    let mut sketch = Sketch::new(WIDTH, height.max(1000.0), format!("{title}, in {unit}"));
    panel::headline(
        &mut sketch,
        title,
        &format!("{unit} for an error below each power of ten · light: cheap · framed: the cheapest of all"),
    );
    let mut top = TOP;
    for table in &tables {
        draw(&mut sketch, records, table, top);
        top += HEAD + table.families.len() as f64 * CELL + MARGIN;
    }
    Some(sketch)
}

fn draw(sketch: &mut Sketch, records: &Records, table: &Table, top: f64) {
    let metric = ranking::quantity(records, table.scene);
    let unit = if metric == "orientation-end" { "rad" } else { "m" };
    let words = format!(
        "{}: error of the {} [{unit}]",
        survey::title(records, table.scene),
        survey::quantity_words(metric)
    );
    sketch.text(&words, (MARGIN, top + 34.0), Anchor::Start, panel::TITLE);
    let cells = Frame {
        left: MARGIN + NAMES,
        top: top + HEAD,
        right: WIDTH - MARGIN,
        bottom: top + HEAD + table.families.len() as f64 * CELL,
    };
    let grid = (DECADES.len(), table.families.len());
    for (column, decade) in DECADES.iter().enumerate() {
        let (x, _) = cells.cell(grid, column).centre();
        let label = format!("10{}", number::superscript(*decade));
        sketch.text(&label, (x, cells.top - 26.0), Anchor::Middle, panel::TICK);
    }
    let costs: Vec<f64> =
        table.families.iter().flat_map(|(_, cells)| cells.iter().flatten().map(|(_, cost)| *cost)).collect();
    let (low, high) = super::convergence_panel::bounds(&costs);
    let scale = Axis::logarithmic(low, high, 5);
    for (row, (family, costs)) in table.families.iter().enumerate() {
        let y = cells.top + (row as f64 + 0.5) * CELL;
        let family = panel::fitted(family, panel::AXIS, NAMES - 30.0);
        sketch.text(&family, (cells.left - 24.0, y), Anchor::End, panel::AXIS);
        for (column, cheapest) in costs.iter().enumerate() {
            draw_cell(sketch, cells.cell(grid, row * DECADES.len() + column), *cheapest, &scale);
        }
    }
    for column in 0..DECADES.len() {
        let cost =
            |(row, (_, cells)): (usize, &(&str, Vec<Cheapest>))| cells[column].map(|(_, cost)| (row, cost));
        let best = table.families.iter().enumerate().filter_map(cost).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((row, _)) = best {
            let cell = cells.cell(grid, row * DECADES.len() + column).inside(4.0, 4.0, 4.0, 4.0);
            sketch.outline(cell.low(), cell.high(), INK, 7.0);
        }
    }
}

fn draw_cell(sketch: &mut Sketch, cell: Frame, cheapest: Cheapest, scale: &Axis) {
    let cell = cell.inside(2.0, 2.0, 2.0, 2.0);
    let (x, y) = cell.centre();
    let Some((scheme, cost)) = cheapest else {
        sketch.outline(cell.low(), cell.high(), GRID, 2.0);
        sketch.text(number::NONE, (x, y), Anchor::Middle, Type::plain(26.0, SOFT));
        return;
    };
    // Cheap is light. The dark half of the map takes white words.
    let part = 1.0 - scale.part(cost);
    sketch.area(cell.low(), cell.high(), viridis(0.15 + 0.85 * part));
    let ink = if part > 0.5 { INK } else { super::palette::OVER };
    let name = Type::plain(22.0, ink);
    let lines = broken(scheme, &name, cell.right - cell.left - 12.0);
    let leading = 26.0;
    let first = y - leading * lines.len() as f64 / 2.0;
    for (index, line) in lines.iter().enumerate() {
        sketch.text(line, (x, first + leading * index as f64), Anchor::Middle, name);
    }
    let cost = number::significant(10f64.powf(cost), 2);
    sketch.text(
        &cost,
        (x, first + leading * lines.len() as f64 + 2.0),
        Anchor::Middle,
        Type::bold(22.0, ink),
    );
}

/// A name broken at its hyphens into lines of a width.
fn broken(name: &str, face: &Type, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in name.split_inclusive('-') {
        match lines.last_mut() {
            Some(line) if face.width(&format!("{line}{part}")) <= room => line.push_str(part),
            _ => lines.push(part.to_owned()),
        }
    }
    lines
}
