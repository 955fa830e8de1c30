//! The pictures of a report: which there are, and how each is drawn.

mod axis;
mod cheapest;
mod colour_map;
mod colours;
mod convergence;
mod convergence_panel;
mod curves;
mod drift;
mod engines;
mod font;
pub mod heat_map;
mod invariants;
mod key;
mod labels;
mod legend;
pub mod line_chart;
pub mod motion;
mod orders_panel;
mod overview;
mod overview_panels;
mod palette;
mod panel;
mod precision;
mod raster;
mod render;
mod sketch;
mod slopes;
mod scaling;
mod strip;
mod vector;
pub(super) mod stability;
mod work_precision;
mod work_precision_panel;

use std::collections::HashSet;

use crate::record::Records;

use super::ranking::Work;
use super::stability::side_by_side;
use super::survey;
use palette::Palette;
pub(in crate::report) use raster::base64;
pub(in crate::report) use render::Fault;
pub use render::is_own_picture;
use sketch::Sketch;
pub(in crate::report) use vector::alone;
pub(super) use work_precision::{Cast, Group};

/// What a picture shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Subject {
    /// Everything at a glance.
    Overview,
    /// The orders of it alone, for a narrow screen.
    NarrowOverview,
    /// Drift of the rotational energy in every scene.
    DriftRates,
    /// Errors of one scene against the step.
    Convergence(String),
    /// Invariants of one scene against time.
    Invariants(String),
    /// Errors of one scene against cost and step: of the main schemes or of all, in a group of quantities.
    WorkPrecision(String, Cast, Group),
    /// What an error costs in each family.
    Cheapest(Work),
    /// Cost against size.
    Scaling,
    /// Errors in single and in double precision.
    Precision,
    /// Growth of a small displacement over step and damping.
    Growth,
    /// Errors of foreign programs and of schemes on one scene, against step and cost.
    Engines(String),
}

impl Subject {
    /// File name inside the folder of plots.
    pub(super) fn file_name(&self) -> String {
        self.file_stem() + ".png"
    }

    /// Whether a page that holds all of a report shows it: those that tell the most, as far as its size allows.
    pub(super) fn stands_for_a_page(&self) -> bool {
        !matches!(self, Subject::Invariants(_) | Subject::WorkPrecision(..))
    }

    /// File name without its ending.
    pub(super) fn file_stem(&self) -> String {
        match self {
            Subject::Overview => "overview".into(),
            Subject::NarrowOverview => "overview-narrow".into(),
            Subject::DriftRates => "drift-rates".into(),
            Subject::Convergence(scene) => format!("{}-convergence", survey::file_stem(scene)),
            Subject::Invariants(scene) => format!("{}-invariants", survey::file_stem(scene)),
            Subject::WorkPrecision(scene, cast, group) => {
                let whose = if *cast == Cast::Everyone { "-of-all" } else { "" };
                format!("{}-work-precision{whose}-{}", survey::file_stem(scene), group.word())
            }
            Subject::Cheapest(Work::Nanoseconds) => "cheapest-by-time".into(),
            Subject::Cheapest(_) => "cheapest-by-evaluations".into(),
            Subject::Scaling => "scaling".into(),
            Subject::Precision => "precision".into(),
            Subject::Growth => "growth".into(),
            Subject::Engines(scene) => format!("engines-{}", survey::file_stem(scene)),
        }
    }
}

/// A picture, laid out and ready to be drawn.
pub(super) struct Picture(Sketch);

impl Picture {
    /// The picture as PNG bytes.
    pub(super) fn png(&self) -> Result<Vec<u8>, Fault> {
        render::png(&self.0)
    }

    /// The picture as an SVG element.
    pub(super) fn svg(&self) -> Result<String, Fault> {
        vector::svg(&self.0)
    }
}

/// The look of each scheme, as pages write it.
pub(super) struct Looks(Vec<(String, String)>);

impl Looks {
    /// Of the schemes that are drawn, as their pictures have them, and of those that stand apart.
    pub(super) fn new(records: &Records) -> Looks {
        let main = records.without_apart();
        let mut names = survey::measured_schemes(&main);
        let others = survey::measured_schemes(records).into_iter().filter(|name| !names.contains(name));
        names.extend(others.collect::<Vec<_>>());
        let palette = Palette::of_schemes(names, &records.schemes);
        let look = |name: &&str| ((*name).to_owned(), palette.look(name).of_pages());
        Looks(palette.schemes().iter().map(look).collect())
    }

    /// The look of a scheme; that of the first for what is none.
    pub(super) fn of(&self, scheme: &str) -> String {
        let own = self.0.iter().find(|(name, _)| name == scheme);
        own.map_or_else(|| Looks::by_place(0), |(_, look)| look.clone())
    }

    /// The look of the n-th of many things.
    pub(super) fn by_place(place: usize) -> String {
        palette::look(place).of_pages()
    }
}

/// Everything that the records may have a picture of.
pub(super) fn subjects(records: &Records) -> Vec<Subject> {
    let mut subjects = vec![
        Subject::Overview,
        Subject::NarrowOverview,
        Subject::DriftRates,
        Subject::Cheapest(Work::Nanoseconds),
        Subject::Cheapest(Work::Evaluations),
        Subject::Scaling,
        Subject::Precision,
        Subject::Growth,
    ];
    for scene in survey::scenes(records) {
        subjects.push(Subject::Convergence(scene.into()));
        subjects.push(Subject::Invariants(scene.into()));
        let cast = if has_more_than_the_main_ones(records, scene) { Cast::Everyone } else { Cast::Main };
        subjects.extend(Group::ALL.map(|group| Subject::WorkPrecision(scene.into(), cast, group)));
    }
    subjects.extend(engine_subjects(records));
    subjects
}

/// Whether schemes that stand apart were run on a scene: the picture of all shows the main ones, too.
fn has_more_than_the_main_ones(records: &Records, scene: &str) -> bool {
    let apart: HashSet<&str> =
        records.schemes.iter().filter(|row| row.apart).map(|row| row.name.as_str()).collect();
    records.measurements.iter().any(|row| row.scene == scene && apart.contains(row.scheme.as_str()))
}

/// The pictures of foreign programs: none where there is no program.
pub(super) fn engine_subjects(records: &Records) -> Vec<Subject> {
    if records.engines.is_empty() {
        return Vec::new();
    }
    survey::scenes(records).into_iter().map(|scene| Subject::Engines(scene.into())).collect()
}

/// The pictures that stand for all: the overview, the drift, and the first scene under forces that carries an
/// order.
pub(super) fn key_subjects(records: &Records) -> Vec<Subject> {
    let typical = records.scenes.iter().find(|row| !row.laws.is_empty() && row.not_for_order.is_none());
    let typical = typical.map(|row| Subject::Convergence(row.name.clone()));
    [Subject::Overview, Subject::DriftRates]
        .into_iter()
        .chain(typical)
        .chain(engine_subjects(records))
        .collect()
}

/// Lays a picture out; `None` where the records hold nothing to draw. `main` is the records without the schemes that stand apart.
///
/// # Errors
/// The bundled typeface cannot be read.
pub(super) fn lay_out(
    records: &Records,
    main: &Records,
    subject: &Subject,
) -> Result<Option<Picture>, Fault> {
    font::register().map_err(|why| Fault(why.into()))?;
    let palette = Palette::of_schemes(survey::measured_schemes(main), &main.schemes);
    let sketch = match subject {
        Subject::Overview => overview::sketch(main, &palette),
        Subject::NarrowOverview => overview::narrow(main, &palette),
        Subject::DriftRates => drift::sketch(main, &palette),
        Subject::Convergence(scene) => convergence::sketch(main, &palette, scene),
        Subject::Invariants(scene) => invariants::sketch(main, &palette, scene),
        Subject::WorkPrecision(scene, cast, group) => {
            work_precision::sketch(records, main, &palette, scene, (*cast, *group))
        }
        Subject::Cheapest(work) => cheapest::sketch(records, *work),
        Subject::Scaling => scaling::sketch(records),
        Subject::Precision => precision::sketch(main, &palette),
        Subject::Growth => side_by_side(&main.maps).map(|maps| maps.checked()).transpose()?,
        Subject::Engines(scene) => engines::sketch(records, scene),
    };
    Ok(sketch.map(Picture))
}
