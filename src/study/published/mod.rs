//! Figures on rigid-body motion that others published, computed again.
//!
//! The figures are data: `references/published/figures.toml`. Each has its source, the printed numbers, the digits that
//! Polhode gives, and the limit that a difference is held to. The scenes stand beside them. A number comes from the
//! truth, which is the Taylor series of our own, or from a scheme at the published step.
//!
//! A limit is one unit of the last printed digit, or the error that the source states, or one that the figure
//! derives.

mod data;
mod list;
mod measure;
mod motion;
mod period;

use rayon::prelude::*;

use crate::journal::{self, Journal};
use crate::ode::SolverError;
use crate::record::PublishedRow;
use crate::scenes::{Scene, SceneError};
use crate::simulate::Break;

use data::{Problem, numbers};
use motion::Motion;

pub use list::SCENES;

/// A published figure that cannot be computed.
#[derive(Debug, thiserror::Error)]
pub enum PublishedError {
    /// The figures cannot be read.
    #[error("references/published/figures.toml: {0}")]
    Figures(#[from] toml::de::Error),
    /// A scene cannot be read.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The truth cannot be solved.
    #[error("{scene}: {source}")]
    Truth {
        /// Scene.
        scene: String,
        /// Why.
        source: SolverError,
    },
    /// A run broke.
    #[error("{scene}, {scheme}: {why}")]
    Broken {
        /// Scene.
        scene: String,
        /// Scheme.
        scheme: String,
        /// Where and why.
        why: Break,
    },
    /// The user asks for the end.
    #[error("interrupted")]
    Interrupted,
    /// A figure asks for what it does not say, or for what the scene does not have.
    #[error("{scene}, '{quantity}': {why}")]
    Figure {
        /// Scene.
        scene: String,
        /// What is measured.
        quantity: String,
        /// What is missing.
        why: &'static str,
    },
}

/// Every published figure beside what Polhode gives now, in the order of the data. A problem is a row of the journal.
///
/// # Errors
/// [`PublishedError`].
pub fn rows(journal: Option<&Journal>) -> Result<Vec<PublishedRow>, PublishedError> {
    kept_rows_of(list::FIGURES, journal)
}

/// The same for the text of a file like `references/published/figures.toml`.
///
/// # Errors
/// [`PublishedError`].
pub fn rows_of(figures: &str) -> Result<Vec<PublishedRow>, PublishedError> {
    kept_rows_of(figures, None)
}

fn kept_rows_of(figures: &str, journal: Option<&Journal>) -> Result<Vec<PublishedRow>, PublishedError> {
    let problems = data::problems(figures)?;
    let kept = |problem: &Problem| {
        let key = ("published", &problem.scene, &problem.title);
        journal::try_row(journal, &key, || problem_rows(problem)).unwrap_or(Err(PublishedError::Interrupted))
    };
    let rows: Result<Vec<Vec<PublishedRow>>, PublishedError> = problems.par_iter().map(kept).collect();
    Ok(rows?.into_iter().flatten().collect())
}

fn problem_rows(problem: &Problem) -> Result<Vec<PublishedRow>, PublishedError> {
    let scene = list::scene(&problem.scene)?;
    let motion = Motion::of(&scene, problem)?;
    problem.figures.iter().map(|figure| row(&scene, problem, figure, &motion)).collect()
}

fn row(
    scene: &Scene,
    problem: &Problem,
    figure: &data::Figure,
    motion: &Motion,
) -> Result<PublishedRow, PublishedError> {
    let missing =
        |why| PublishedError::Figure { scene: scene.name.clone(), quantity: figure.quantity.clone(), why };
    let computed = measure::values(figure, motion)?;
    let printed = numbers(&figure.published).ok_or_else(|| missing("a published number is not a number"))?;
    let ours = numbers(&figure.ours).ok_or_else(|| missing("a number of ours is not a number"))?;
    if computed.len() != printed.len() || computed.len() != ours.len() {
        return Err(missing("published, ours and computed are not equally many numbers"));
    }
    Ok(PublishedRow {
        problem: problem.title.clone(),
        scene: scene.name.clone(),
        source: figure.source.as_ref().unwrap_or(&problem.source).clone(),
        quantity: figure.quantity.clone(),
        by: figure.by(),
        unit: figure.unit.clone(),
        difference: printed.iter().zip(&ours).map(|(a, b)| a - b).collect(),
        held_to: figure.limits(&printed),
        limit: figure.because.clone(),
        published: figure.published.clone(),
        ours: figure.ours.clone(),
        computed,
        agreement: figure.agreement,
        sureness: figure.sureness,
        truncated: figure.truncated,
        note: figure.note.clone(),
    })
}
