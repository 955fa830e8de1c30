//! The legend as a table: a scheme a row with its sign, its name and a number for each panel, so that no number is far from its name.

use super::legend::{self, Sign};
use super::palette::{GRID, INK, Look, SOFT};
use super::sketch::{Anchor, Sketch, Type};

const FACE: Type = Type::plain(30.0, INK);
const HEAD: Type = Type::plain(28.0, SOFT);
/// Height of a row.
const ROW: f64 = 46.0;
/// Between two columns.
const GAP: f64 = 44.0;
/// Rows from which on the table stands in two blocks side by side, where they fit.
const LONG: usize = 7;

/// The table.
pub(super) struct Key {
    /// What stands over the columns of numbers.
    pub heads: Vec<String>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A scheme.
pub(super) struct Row {
    pub look: Look,
    pub name: String,
    /// A number for each head.
    pub cells: Vec<String>,
}

impl Key {
    /// The widths of the names and of each column.
    fn widths(&self) -> (f64, Vec<f64>) {
        let widest = |texts: &mut dyn Iterator<Item = &str>, face: Type| {
            texts.map(|text| face.width(text)).fold(0.0, f64::max)
        };
        let names = widest(&mut self.rows.iter().map(|row| row.name.as_str()), FACE);
        let column = |(index, head): (usize, &String)| {
            let cells = widest(&mut self.rows.iter().filter_map(|row| Some(row.cells.get(index)?.as_str())), FACE);
            cells.max(HEAD.width(head))
        };
        (names, self.heads.iter().enumerate().map(column).collect())
    }

    fn width(&self) -> f64 {
        let (names, columns) = self.widths();
        legend::SIGN + names + columns.iter().map(|width| width + GAP).sum::<f64>()
    }

    fn blocks(&self, room: f64) -> usize {
        if self.rows.len() >= LONG && 2.0 * self.width() + 2.0 * GAP <= room { 2 } else { 1 }
    }

    fn head(&self) -> f64 {
        if self.heads.is_empty() { 0.0 } else { ROW }
    }

    /// Height that the table needs.
    pub(super) fn height(&self, room: f64) -> f64 {
        if self.rows.is_empty() { 0.0 } else { self.head() + ROW * self.rows.len().div_ceil(self.blocks(room)) as f64 }
    }

    /// Draws the table from a corner on.
    pub(super) fn draw(&self, sketch: &mut Sketch, left: f64, top: f64, room: f64) {
        if self.rows.is_empty() {
            return;
        }
        let blocks = self.blocks(room);
        let (names, columns) = self.widths();
        for (block, rows) in self.rows.chunks(self.rows.len().div_ceil(blocks)).enumerate() {
            let left = left + block as f64 * (self.width() + 2.0 * GAP);
            let mut ends = Vec::new();
            columns.iter().fold(left + legend::SIGN + names, |x, width| {
                ends.push(x + GAP + width);
                x + GAP + width
            });
            for (head, end) in self.heads.iter().zip(&ends) {
                sketch.text(head, (*end, top + ROW / 2.0), Anchor::End, HEAD);
            }
            if !self.heads.is_empty() {
                let end = ends.last().copied().unwrap_or(left);
                sketch.line(vec![(left, top + ROW), (end, top + ROW)], GRID, 2.0);
            }
            for (index, row) in rows.iter().enumerate() {
                let y = top + self.head() + ROW * (index as f64 + 0.5);
                legend::draw_sign(sketch, Sign::Scheme(row.look), (left, y));
                sketch.text(&row.name, (left + legend::SIGN, y), Anchor::Start, FACE);
                for (cell, end) in row.cells.iter().zip(&ends) {
                    sketch.text(cell, (*end, y), Anchor::End, FACE);
                }
            }
        }
    }
}
