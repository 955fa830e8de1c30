//! What the script moves: the truth of a scene and runs beside it, as differences of whole numbers, which pack well.

use serde::Serialize;

use crate::record::{Motion, Records};
use crate::report::plot::Looks;

/// Steps of a drawn number between 0 and its largest value: a twentieth of a pixel on a view of 400 pixels.
const PARTS: f64 = 4000.0;

/// The motions of a scene.
#[derive(Serialize)]
pub(super) struct Motions {
    moments: [f64; 3],
    /// Time of the last state [s].
    end: f64,
    /// Largest component of Ω [rad/s].
    largest: f64,
    parts: f64,
    runs: Vec<Run>,
}

#[derive(Serialize)]
struct Run {
    /// Nothing for the truth.
    name: String,
    /// Colour on white, colour on a dark ground, dashes.
    look: String,
    step: f64,
    /// Differences of quaternions, in parts of 1.
    turn: Vec<i32>,
    /// Differences of Ω, in parts of the largest.
    spin: Vec<i32>,
}

impl Motions {
    /// `None` where the records hold no motion of the scene.
    pub(super) fn new(records: &Records, looks: &Looks, scene: &str) -> Option<Motions> {
        let rows: Vec<&Motion> =
            records.motions.iter().map(AsRef::as_ref).filter(|row| row.scene == scene).collect();
        let truth = rows.iter().find(|row| row.scheme.is_empty())?;
        let largest = rows.iter().flat_map(|row| &row.spin).fold(0.0, |most: f64, w| most.max(w.abs()));
        let largest = if largest > 0.0 { largest } else { 1.0 };
        let run = |row: &&Motion| Run {
            name: row.scheme.clone(),
            look: looks.of(&row.scheme),
            step: row.step_s,
            turn: differences(&row.turn, 4, 1.0),
            spin: differences(&row.spin, 3, largest),
        };
        Some(Motions {
            moments: truth.moments,
            end: truth.time_s.last().copied().unwrap_or_default(),
            largest,
            parts: PARTS,
            runs: rows.iter().map(run).collect(),
        })
    }
}

/// Each number less the one `width` before it, in parts of `largest`.
fn differences(values: &[f64], width: usize, largest: f64) -> Vec<i32> {
    let whole: Vec<i32> = values.iter().map(|value| (value / largest * PARTS).round() as i32).collect();
    let before = |index: usize| index.checked_sub(width).map_or(0, |before| whole[before]);
    whole.iter().enumerate().map(|(index, value)| value - before(index)).collect()
}
