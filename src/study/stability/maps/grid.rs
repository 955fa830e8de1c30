//! The cells of a map and where they stand.

use crate::interrupt;
use crate::record::stability::{Map, MapAxis, MapCurve};

/// Two axes, cut into cells.
pub(super) struct Grid {
    pub x: MapAxis,
    pub y: MapAxis,
    pub cells: usize,
}

impl Grid {
    /// The middle of a cell along an axis.
    pub(super) fn middle(&self, axis: &MapAxis, index: usize) -> f64 {
        let part = (index as f64 + 0.5) / self.cells as f64;
        if axis.logarithmic {
            axis.low * (axis.high / axis.low).powf(part)
        } else {
            axis.low + (axis.high - axis.low) * part
        }
    }

    /// The middles along the horizontal axis.
    pub(super) fn across(&self) -> Vec<f64> {
        (0..self.cells).map(|index| self.middle(&self.x, index)).collect()
    }

    /// The middles along the vertical axis.
    pub(super) fn along(&self) -> Vec<f64> {
        (0..self.cells).map(|index| self.middle(&self.y, index)).collect()
    }

    /// The map whose rows this function fills: given y and every x, the values and the steps that they took.
    pub(super) fn fill(self, mut row: impl FnMut(f64, &[f64]) -> (Vec<Option<f64>>, u64)) -> Map {
        let across = self.across();
        let mut steps = 0;
        let mut values = Vec::with_capacity(self.cells);
        for y in self.along() {
            if interrupt::requested() {
                values.push(vec![None; self.cells]);
                continue;
            }
            let (cells, taken) = row(y, &across);
            values.push(cells.into_iter().map(|value| value.filter(|value| value.is_finite())).collect());
            steps += taken;
        }
        Map { x: self.x, y: self.y, cells: self.cells, values, steps, unit: "1".to_owned(), ..Map::default() }
    }
}

/// A curve x(y) over the heights of a map; places outside the map are left out.
pub(super) fn curve(name: &str, map: &Map, x_of_y: impl Fn(f64) -> Option<f64>) -> MapCurve {
    let grid = Grid { x: map.x.clone(), y: map.y.clone(), cells: 256 };
    let places = grid.along().into_iter().filter_map(|y| Some((x_of_y(y)?, y)));
    let inside = places.filter(|(x, _)| (map.x.low..=map.x.high).contains(x));
    let (x, y) = inside.unzip();
    MapCurve { name: name.to_owned(), x, y }
}

/// The lowest x of every row at which a value rises past the edge, as a curve.
pub(super) fn measured_edge(map: &Map, edge: f64) -> MapCurve {
    let grid = Grid { x: map.x.clone(), y: map.y.clone(), cells: map.cells };
    let across = grid.across();
    let places = grid
        .along()
        .into_iter()
        .zip(&map.values)
        .filter_map(|(y, row)| Some((crossing(map, &across, row, edge)?, y)));
    let (x, y) = places.unzip();
    MapCurve { name: "measured".to_owned(), x, y }
}

/// How far that x is from x(y), relative: the median over the rows in which both lie inside the map.
pub(super) fn edge_off(map: &Map, edge: f64, x_of_y: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let measured = measured_edge(map, edge);
    let off = measured.x.iter().zip(&measured.y).filter_map(|(x, y)| Some((x / x_of_y(*y)? - 1.0).abs()));
    crate::study::stability::kink::median(off.collect())
}

/// Where the straight line between two neighbours crosses the edge.
fn crossing(map: &Map, across: &[f64], row: &[Option<f64>], edge: f64) -> Option<f64> {
    let above = row.iter().position(|value| value.is_some_and(|value| value > edge))?;
    let (before, after) = (row.get(above.checked_sub(1)?).copied().flatten()?, row[above]?);
    let part = (edge - before) / (after - before);
    let (low, high) = (across[above - 1], across[above]);
    Some(if map.x.logarithmic { low * (high / low).powf(part) } else { low + (high - low) * part })
}
