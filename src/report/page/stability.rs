//! The page on stability: the limits on record for the schemes of the report.

use serde::Serialize;

use crate::record::stability::{LimitStatus, Meaning, Stability};
use crate::record::{Records, SchemeRow};
use crate::report::plot::Subject;
use crate::report::{number, survey};

use super::{Figure, FigureView, figure};

/// The section.
#[derive(Serialize)]
pub(super) struct Section {
    failures: Vec<Failures>,
    growth: Option<FigureView>,
    linear: Vec<Linear>,
    rows: Vec<Row>,
}

/// Where a scheme fails, of each of [`BODIES`].
#[derive(Serialize)]
struct Failures {
    scheme: String,
    anchor: String,
    cells: [String; 4],
}

/// The limit on the spring-held body.
#[derive(Serialize)]
struct Linear {
    scheme: String,
    scene: String,
    measured: String,
    theory: String,
    why: String,
    failure: String,
}

/// The largest usable steps of a scheme in a scene.
#[derive(Serialize)]
struct Row {
    scene: String,
    anchor: String,
    scheme: String,
    limits: [String; 3],
    failure: String,
}

const GROWTH: &str = "Growth a step of a small displacement of the spring-held body, over step and damping: zero is white, and it begins to \
                      grow at the dashed line.";

/// The bodies of the line that says where a scheme fails.
const BODIES: [&str; 4] = ["spring-held body", "free body", "tumbling body", "heavy top"];

const MEANINGS: [Meaning; 3] = [Meaning::Bounded, Meaning::Energy, Meaning::Orientation];

impl Section {
    /// Of the schemes and scenes of these records; `None` where none of them is on record.
    pub(super) fn new(main: &Records, figures: &[Figure]) -> Option<Section> {
        let study = Stability::built_in();
        let schemes = survey::schemes(main);
        let scenes = survey::scenes(main);
        let known = |scheme: &str, scene: &str| schemes.contains(&scheme) && scenes.contains(&scene);
        let linear: Vec<Linear> = study
            .linear
            .iter()
            .filter(|row| schemes.contains(&row.scheme.as_str()))
            .map(|row| Linear {
                scheme: row.scheme.clone(),
                scene: row.scene.clone(),
                measured: four(row.h_omega),
                theory: four(row.theory_h_omega),
                why: row.theory.clone().unwrap_or_default(),
                failure: row.failure.clone(),
            })
            .collect();
        let bounded = study.limits.iter().filter(|row| row.meaning == Meaning::Bounded);
        let rows: Vec<Row> = bounded
            .filter(|row| known(&row.scheme, &row.scene) && row.step_or_none())
            .map(|row| Row {
                scene: row.scene.clone(),
                anchor: survey::file_stem(&row.scene),
                scheme: row.scheme.clone(),
                limits: MEANINGS.map(|meaning| limit(study, &row.scene, &row.scheme, meaning)),
                failure: row.failure.clone().unwrap_or_default(),
            })
            .collect();
        let growth = figure(figures, &Subject::Growth, GROWTH);
        let failures = main.schemes.iter().filter_map(Failures::of).collect();
        (!linear.is_empty() || !rows.is_empty()).then_some(Section { failures, growth, linear, rows })
    }
}

impl Failures {
    /// `None` where it was not studied.
    fn of(scheme: &SchemeRow) -> Option<Failures> {
        let line = scheme.fails_where.as_ref()?;
        let of = |body: &str| line.split("; ").find_map(|part| part.strip_prefix(body));
        let cell = |body| of(body).map_or(number::NONE, |part| part.trim_start_matches([':', ',', ' ']));
        Some(Failures {
            scheme: scheme.name.clone(),
            anchor: survey::file_stem(&scheme.name),
            cells: BODIES.map(|body| cell(body).to_owned()),
        })
    }
}

fn four(value: Option<f64>) -> String {
    value.map_or(number::NONE.into(), |value| number::significant(value, 4))
}

/// The largest usable step in radians, or in seconds where nothing turns.
fn limit(study: &Stability, scene: &str, scheme: &str, meaning: Meaning) -> String {
    let same = |row: &&crate::record::stability::Limit| {
        row.meaning == meaning && row.scene == scene && row.scheme == scheme
    };
    let Some(row) = study.limits.iter().find(same) else { return number::NONE.into() };
    let size = match (row.radians_per_step, row.step_s) {
        (Some(radians), _) => format!("{} rad", number::significant(radians, 3)),
        (_, Some(step)) => format!("{} s", number::significant(step, 3)),
        _ => number::NONE.into(),
    };
    match row.status {
        LimitStatus::Limit if row.ragged => format!("~ {size}"),
        LimitStatus::Limit => size,
        LimitStatus::Unlimited => format!("≥ {size}"),
        LimitStatus::None => "none tried".into(),
        _ => number::NONE.into(),
    }
}
