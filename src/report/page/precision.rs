//! The table of what schemes reach in single and in double precision.

use serde::Serialize;

use super::{Figure, FigureView, figure};
use crate::record::{Growth, PrecisionRow, Reach, Records};
use crate::report::plot::Subject;
use crate::report::{number, survey};

/// The section.
#[derive(Serialize)]
pub(super) struct Precision {
    figure: Option<FigureView>,
    rows: Vec<Row>,
}

/// A scheme in a scene.
#[derive(Serialize)]
struct Row {
    scene: String,
    anchor: String,
    scheme: String,
    single: Cells,
    double: Cells,
}

/// What an arithmetic reaches.
#[derive(Default, Serialize)]
struct Cells {
    error: String,
    step: String,
    growth: String,
}

impl Precision {
    /// `None` where precision was not studied.
    pub(super) fn new(records: &Records, figures: &[Figure]) -> Option<Precision> {
        let of = |arithmetic: &'static str| {
            records.precision.iter().filter(move |row| row.arithmetic == arithmetic)
        };
        let rows: Vec<Row> = of("f32")
            .map(|single| Row {
                scene: single.scene.clone(),
                anchor: survey::file_stem(&single.scene),
                scheme: single.scheme.clone(),
                single: Cells::new(single),
                double: of("f64")
                    .find(|row| (&row.scene, &row.scheme) == (&single.scene, &single.scheme))
                    .map(Cells::new)
                    .unwrap_or_default(),
            })
            .collect();
        let caption = "Error against step in f32, in f64 and by truncation alone.";
        let figure = figure(figures, &Subject::Precision, caption);
        (!rows.is_empty()).then_some(Precision { figure, rows })
    }
}

impl Cells {
    fn new(row: &PrecisionRow) -> Cells {
        let known = |value: Option<f64>| value.map_or(number::NONE.into(), |x| number::significant(x, 2));
        let (error, step) = (known(row.smallest_error_rad), known(row.at_step_s));
        let coarsest = row.runs.first().is_some_and(|run| Some(run.step_s) == row.at_step_s);
        let (error, step) = match row.reach {
            Some(Reach::Falling) => (format!("≤ {error}, still falls"), format!("≤ {step}")),
            Some(Reach::OtherMotion) => (format!("{error}, another motion"), number::NONE.into()),
            Some(Reach::Broken) => ("broken".into(), number::NONE.into()),
            _ if coarsest => (error, format!("≥ {step}")),
            _ => (error, step),
        };
        Cells { error, step, growth: row.growth.as_ref().map_or(number::NONE.into(), growth) }
    }
}

/// `0.52 ± 0.13: √n`.
fn growth(growth: &Growth) -> String {
    format!("{:.2} ± {:.2}: {}", growth.exponent, growth.uncertainty, growth.law)
}
