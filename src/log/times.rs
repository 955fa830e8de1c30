//! The times of a log: their spacing, gaps, repeats and steps back.

use super::row::Row;

/// Times the usual spacing from which on a pause is a gap.
const GAP: f64 = 3.0;

/// What the times of a log are like.
pub(super) struct Times {
    /// Median spacing of those that go forward [s]; 0 for a single row.
    pub spacing: f64,
    /// What is odd about them.
    pub notes: Vec<String>,
}

pub(super) fn examine(rows: &[Row]) -> Times {
    let spaced = || rows.windows(2).map(|pair| (pair[1].time() - pair[0].time(), pair));
    let mut forward: Vec<f64> = spaced().map(|(by, _)| by).filter(|by| *by > 0.0).collect();
    let middle = forward.len() / 2;
    let spacing =
        if forward.is_empty() { 0.0 } else { *forward.select_nth_unstable_by(middle, f64::total_cmp).1 };
    let mut notes = Vec::new();
    let mut note = |what: &str, holds: &dyn Fn(f64) -> bool| {
        let odd: Vec<_> = spaced().filter(|(by, _)| holds(*by)).collect();
        let Some((by, pair)) = odd.first() else { return };
        let (line, time) = (pair[1].line, pair[0].time());
        notes.push(format!(
            "{} {what}; the first in line {line}: {by:.6} s after t = {time} s, where {spacing:.6} s is usual",
            odd.len()
        ));
    };
    note("times are those of the row before", &|by| by == 0.0);
    note("gaps", &|by| by > GAP * spacing);
    if rows.len() == 1 {
        notes.push("there is one row: no drift, no frame check, and the error at its time only".to_owned());
    }
    Times { spacing, notes }
}
