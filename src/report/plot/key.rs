//! The legend as a table: a scheme a row with its sign, its name and a number for each panel, so that no number is far from its name.

use super::legend::{self, Sign};
use super::palette::{GRID, INK, Look, SOFT};
use super::sketch::{Anchor, Sketch, Type};

/// Heights of letters of rows and of heads, where the table is not wider than its room.
const EM: (f64, f64) = (30.0, 28.0);
/// Height of a row.
const ROW: f64 = 46.0;
/// Between two columns.
const GAP: f64 = 44.0;
/// Fewest rows of a table that is set in two blocks side by side, where they fit.
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
    /// The table as it is laid out in a room: smaller where it would be wider.
    fn layout(&self, room: f64) -> Layout {
        let whole = Layout::of(self, 1.0);
        if whole.width() > room {
            // Signs and gaps keep their widths.
            let kept = legend::SIGN + GAP * self.heads.len() as f64;
            return Layout::of(self, (room - kept) / (whole.width() - kept));
        }
        let blocks = if self.rows.len() >= LONG && 2.0 * whole.width() + 2.0 * GAP <= room { 2 } else { 1 };
        Layout { blocks, ..whole }
    }

    fn head(&self) -> f64 {
        if self.heads.is_empty() { 0.0 } else { ROW }
    }

    /// Height that the table needs.
    pub(super) fn height(&self, room: f64) -> f64 {
        if self.rows.is_empty() {
            return 0.0;
        }
        self.head() + ROW * self.rows.len().div_ceil(self.layout(room).blocks) as f64
    }

    /// Draws the table from a corner on.
    pub(super) fn draw(&self, sketch: &mut Sketch, left: f64, top: f64, room: f64) {
        if self.rows.is_empty() {
            return;
        }
        let layout = self.layout(room);
        for (block, rows) in self.rows.chunks(self.rows.len().div_ceil(layout.blocks)).enumerate() {
            let left = left + block as f64 * (layout.width() + 2.0 * GAP);
            let ends: Vec<f64> = layout.ends.iter().map(|end| left + end).collect();
            for (head, end) in self.heads.iter().zip(&ends) {
                sketch.text(head, (*end, top + ROW / 2.0), Anchor::End, layout.head);
            }
            if !self.heads.is_empty() {
                sketch.line(vec![(left, top + ROW), (left + layout.width(), top + ROW)], GRID, 2.0);
            }
            for (index, row) in rows.iter().enumerate() {
                let y = top + self.head() + ROW * (index as f64 + 0.5);
                legend::draw_sign(sketch, Sign::Scheme(row.look), (left, y));
                sketch.text(&row.name, (left + legend::SIGN, y), Anchor::Start, layout.face);
                for (cell, end) in row.cells.iter().zip(&ends) {
                    sketch.text(cell, (*end, y), Anchor::End, layout.face);
                }
            }
        }
    }
}

/// Sizes of a table.
struct Layout {
    face: Type,
    head: Type,
    blocks: usize,
    /// Right end of the names.
    names: f64,
    /// Right end of each column.
    ends: Vec<f64>,
}

impl Layout {
    /// With letters so many times as high as usual.
    fn of(key: &Key, scale: f64) -> Layout {
        let (face, head) = (Type::plain(EM.0 * scale, INK), Type::plain(EM.1 * scale, SOFT));
        let names = key.rows.iter().map(|row| face.width(&row.name)).fold(0.0, f64::max) + legend::SIGN;
        let mut ends = Vec::new();
        let mut end = names;
        for (index, title) in key.heads.iter().enumerate() {
            let cells = key.rows.iter().filter_map(|row| row.cells.get(index));
            end += GAP + cells.map(|cell| face.width(cell)).fold(head.width(title), f64::max);
            ends.push(end);
        }
        Layout { face, head, blocks: 1, names, ends }
    }

    fn width(&self) -> f64 {
        self.ends.last().copied().unwrap_or(self.names)
    }
}
