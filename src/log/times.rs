//! The times of a log: their spacing, gaps and repeats.

use super::row::Row;

/// Times the usual spacing above which a pause is a gap.
const GAP: f64 = 3.0;

/// Median spacing of neighbours [s]; 0 for a single row.
pub(super) fn spacing<'a>(pairs: impl Iterator<Item = &'a [Row]>) -> f64 {
    let spaced = pairs.map(|pair| pair[1].time() - pair[0].time());
    let mut forward: Vec<f64> = spaced.filter(|by| *by > 0.0).collect();
    let middle = forward.len() / 2;
    if forward.is_empty() { 0.0 } else { *forward.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// Oddities of one kind: how many, and the first: its line, the time before it and the spacing [s].
#[derive(Clone, Copy, Debug, Default)]
struct Oddities {
    count: usize,
    first: Option<(u32, f64, f64)>,
}

/// What is odd about times, row by row.
#[derive(Debug)]
pub(super) struct Odd {
    spacing: f64,
    before: Option<f64>,
    repeats: Oddities,
    gaps: Oddities,
    rows: usize,
}

impl Odd {
    /// Where `spacing` [s] is usual.
    pub fn new(spacing: f64) -> Odd {
        let none = Oddities::default();
        Odd { spacing, before: None, repeats: none, gaps: none, rows: 0 }
    }

    /// Looks at the next rows.
    pub fn take(&mut self, rows: &[Row]) {
        for row in rows {
            if let Some(before) = self.before {
                let by = row.time() - before;
                let kind = match by {
                    0.0 => Some(&mut self.repeats),
                    by if by > GAP * self.spacing => Some(&mut self.gaps),
                    _ => None,
                };
                if let Some(kind) = kind {
                    kind.count += 1;
                    kind.first.get_or_insert((row.line, before, by));
                }
            }
            self.before = Some(row.time());
        }
        self.rows += rows.len();
    }

    /// What is to be said.
    pub fn notes(&self) -> Vec<String> {
        let spacing = self.spacing;
        let note = |what: &str, odd: &Oddities| {
            let (line, time, by) = odd.first?;
            let count = odd.count;
            Some(format!(
                "{count} {what}; the first in line {line}: {by:.6} s after t = {time} s, where {spacing:.6} s is usual"
            ))
        };
        let repeats = note("times are those of the row before", &self.repeats);
        let gaps = note("gaps", &self.gaps);
        let one = (self.rows == 1)
            .then(|| "there is one row: no drift, no frame check, and the error at its time only".to_owned());
        [repeats, gaps, one].into_iter().flatten().collect()
    }
}
