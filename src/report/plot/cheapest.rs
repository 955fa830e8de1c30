//! The overview of cost: for each decade of error, the cheapest scheme in each family.

use crate::record::Records;
use crate::report::ranking::{self, Ladder, Work};
use crate::report::{number, survey};

use super::axis::Axis;
use super::colour_map::{luma, viridis};
use super::palette::{GRID, INK, SOFT};
use super::panel::{self, Frame};
use super::sketch::{Anchor, Sketch, Type};

const WIDTH: f64 = 2600.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 40.0;
/// Column of the families' names.
const NAMES: f64 = 270.0;
/// Height of a cell, at least.
const CELL: f64 = 118.0;
/// Height of the picture, at least.
const LEAST: f64 = 1000.0;
/// Over the cells: the decades.
const HEAD: f64 = 60.0;
/// The decades of error, log₁₀.
const DECADES: [i32; 11] = [-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11];
/// Lightness above which dark words have more contrast than white ones.
const HALF: f64 = 110.0;
/// Scenes in the picture, at most.
const MOST_SCENES: usize = 3;

/// The cheapest scheme of a family for an error, log₁₀ of its work, and whether less may do as well.
type Cheapest<'a> = Option<(&'a str, f64, bool)>;

/// The overview: the scenes that it is taken over, and for each family what every decade costs.
struct Table<'a> {
    scenes: Vec<&'a str>,
    /// What stands before the decades.
    bound: &'static str,
    families: Vec<(&'a str, Vec<Cheapest<'a>>)>,
}

impl Table<'_> {
    /// Where the last row ends: few families take higher cells.
    fn bottom(&self) -> f64 {
        (TOP + HEAD + self.families.len() as f64 * CELL).max(LEAST - 2.0 * MARGIN)
    }
}

/// The scenes on which most schemes were run and that carry an order, of different models, with their ladders; the same scenes
/// for every kind of work.
fn scenes(records: &Records, work: Work) -> Vec<(&str, Vec<Ladder<'_>>)> {
    let ladders =
        |scene: &str, work| ranking::ladders(records, scene, ranking::quantity(records, scene), work);
    let carry_an_order = records.scenes.iter().filter(|row| row.not_for_order.is_none());
    let mut all: Vec<(&str, &str, usize)> = carry_an_order
        .map(|row| (row.name.as_str(), row.model.as_str(), ladders(&row.name, Work::Evaluations).len()))
        .collect();
    // The sort is stable: of scenes with as many schemes the first of the records come first.
    all.sort_by_key(|(.., schemes)| std::cmp::Reverse(*schemes));
    let most = all.first().map_or(0, |(.., schemes)| *schemes);
    let mut chosen: Vec<(&str, &str)> = Vec::new();
    for (scene, model, schemes) in all {
        let new = chosen.iter().all(|(_, other)| *other != model);
        // A scene that few schemes take would leave the others out of the mean.
        if new && 4 * schemes >= 3 * most && chosen.len() < MOST_SCENES {
            chosen.push((scene, model));
        }
    }
    chosen.into_iter().map(|(scene, _)| (scene, ladders(scene, work))).collect()
}

fn table(records: &Records, work: Work) -> Table<'_> {
    let scenes = scenes(records, work);
    // Mean of the logarithms: the geometric mean of what a scheme costs in every scene.
    let cost = |scheme: &str, decade: i32| {
        let works: Option<Vec<(f64, bool)>> = scenes
            .iter()
            .map(|(_, ladders)| ladders.iter().find(|l| l.scheme == scheme)?.work_for(f64::from(decade)))
            .collect();
        let works = works?;
        let mean = works.iter().map(|(work, _)| work).sum::<f64>() / works.len() as f64;
        Some((mean, works.iter().any(|(_, at_most)| *at_most)))
    };
    let ladders = scenes.first().map_or(&[][..], |(_, ladders)| ladders.as_slice());
    let cheapest = |family: &str, decade: i32| {
        let own = ladders.iter().filter(|ladder| ladder.family == family);
        let costs = own.filter_map(|ladder| {
            let (work, at_most) = cost(ladder.scheme, decade)?;
            Some((ladder.scheme, work, at_most))
        });
        costs.min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let families = survey::distinct(ladders.iter().map(|ladder| ladder.family))
        .into_iter()
        .map(|family| (family, DECADES.map(|decade| cheapest(family, decade)).to_vec()))
        .collect();
    let turns = scenes.iter().all(|(scene, _)| ranking::quantity(records, scene) == "orientation-end");
    let bound = if turns { "error below [rad]" } else { "error below" };
    Table { bound, scenes: scenes.iter().map(|(scene, _)| *scene).collect(), families }
}

/// The picture; `None` where there are no two families.
pub(super) fn sketch(records: &Records, work: Work) -> Option<Sketch> {
    let table = table(records, work);
    if table.families.len() < 2 {
        return None;
    }
    let height = table.bottom() + 2.0 * MARGIN;
    let unit = match work {
        Work::Nanoseconds => "nanoseconds a simulated second",
        _ => "force evaluations a simulated second",
    };
    let title = format!("What an error costs, in {unit}");
    let mut sketch = Sketch::new(WIDTH, height, title.clone());
    let scenes = table.scenes.join(", ");
    let subtitle = format!(
        "cheapest of each family, mean over {scenes} · framed: of all · ≤: the coarsest step is enough"
    );
    panel::headline(&mut sketch, &title, &subtitle);
    draw(&mut sketch, &table);
    Some(sketch)
}

fn draw(sketch: &mut Sketch, table: &Table) {
    let cells =
        Frame { left: MARGIN + NAMES, top: TOP + HEAD, right: WIDTH - MARGIN, bottom: table.bottom() };
    let grid = (DECADES.len(), table.families.len());
    sketch.text(table.bound, (cells.left - 24.0, cells.top - 26.0), Anchor::End, panel::TICK);
    for (column, decade) in DECADES.iter().enumerate() {
        let (x, _) = cells.cell(grid, column).centre();
        let label = format!("10{}", number::superscript(*decade));
        sketch.text(&label, (x, cells.top - 26.0), Anchor::Middle, panel::TICK);
    }
    let costs: Vec<f64> = table
        .families
        .iter()
        .flat_map(|(_, cells)| cells.iter().flatten().map(|(_, cost, _)| *cost))
        .collect();
    let (low, high) = super::convergence_panel::bounds(&costs);
    let scale = Axis::logarithmic(low, high, 5);
    for (row, (family, costs)) in table.families.iter().enumerate() {
        let (_, y) = cells.cell(grid, row * DECADES.len()).centre();
        let family = panel::fitted(family, panel::AXIS, NAMES - 30.0);
        sketch.text(&family, (cells.left - 24.0, y), Anchor::End, panel::AXIS);
        for (column, cheapest) in costs.iter().enumerate() {
            draw_cell(sketch, cells.cell(grid, row * DECADES.len() + column), *cheapest, &scale);
        }
    }
    for column in 0..DECADES.len() {
        let cost = |(row, (_, cells)): (usize, &(&str, Vec<Cheapest>))| {
            cells[column].map(|(_, cost, _)| (row, cost))
        };
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
    let Some((scheme, cost, at_most)) = cheapest else {
        sketch.outline(cell.low(), cell.high(), GRID, 2.0);
        sketch.text(number::NONE, (x, y), Anchor::Middle, Type::plain(26.0, SOFT));
        return;
    };
    // Cheap is light. Dark cells take white words.
    let ground = viridis(0.15 + 0.85 * (1.0 - scale.part(cost)));
    sketch.area(cell.low(), cell.high(), ground);
    let ink = if luma(ground) > HALF { INK } else { super::palette::OVER };
    let name = Type::plain(22.0, ink);
    let lines = broken(scheme, &name, cell.right - cell.left - 12.0);
    let leading = 26.0;
    let first = y - leading * lines.len() as f64 / 2.0;
    for (index, line) in lines.iter().enumerate() {
        sketch.text(line, (x, first + leading * index as f64), Anchor::Middle, name);
    }
    let sign = if at_most { "≤ " } else { "" };
    let cost = format!("{sign}{}", number::significant(10f64.powf(cost), 2));
    sketch.text(
        &cost,
        (x, first + leading * lines.len() as f64 + 2.0),
        Anchor::Middle,
        Type::bold(22.0, ink),
    );
}

/// A name broken at its hyphens into lines of a width, no line of a letter or two.
fn broken(name: &str, face: &Type, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in name.split_inclusive('-') {
        match lines.last_mut() {
            Some(line) if face.width(&format!("{line}{part}")) <= room => line.push_str(part),
            Some(line) if part.chars().count() < 3 => {
                let tail = line.trim_end_matches('-').rfind('-').map_or(0, |hyphen| hyphen + 1);
                let moved = line.split_off(tail);
                lines.push(moved + part);
            }
            _ => lines.push(part.to_owned()),
        }
    }
    lines.retain(|line| !line.is_empty());
    lines
}
