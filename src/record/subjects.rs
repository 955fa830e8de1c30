//! Who was measured: scenes and schemes as a report prints them.

use serde::{Deserialize, Serialize};

/// A scene as the report prints it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SceneRow {
    /// Name, kebab-case.
    pub name: String,
    /// Fingerprint of body, forces, start and duration.
    #[serde(default)]
    pub content: String,
    /// File that it was read from, as the user named it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub file: String,
    /// One line.
    pub title: String,
    /// Why the scene is in the list.
    pub why: String,
    /// Duration of a run [s].
    pub duration_s: f64,
    /// The least model that determines the motion: free, falling, torque, pivot or forced.
    pub model: String,
    /// Mass points of the body; 0 where no positive masses stand for its inertia.
    pub points: usize,
    /// The force laws, in the order of the file.
    pub laws: Vec<String>,
    /// Why the order gate does not apply, if it does not.
    pub not_for_order: Option<String>,
    /// The sources of the reference solution.
    pub references: Vec<ReferenceRow>,
    /// Largest relative difference of a state between the least model and the mass points as written, after 128 steps in
    /// double-double or 1,000 in f64; `None` where the body has no points.
    pub reduction_difference: Option<f64>,
    /// Cost of a step of Peskin's scheme on the mass points over its cost on the least model, timed alone.
    pub reduction_speedup: Option<f64>,
}

/// One source of a reference solution.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ReferenceRow {
    /// `stored`, `dop853`, `tsit45` or the name of a closed form.
    pub source: String,
    /// How it was made: method and tolerance, or file, digits and checksum.
    pub detail: String,
    /// What it is used for: `end`, `run` (the maximum over the run) or `check`.
    pub role: String,
    /// Largest disagreement with the other sources, as an orientation angle [rad]; `None` where there is none
    /// to compare with.
    pub disagreement_rad: Option<f64>,
}

/// A scheme's card as the report prints it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SchemeRow {
    /// Name as on the command line.
    pub name: String,
    /// One line.
    pub title: String,
    /// Family of schemes.
    pub family: String,
    /// Claimed order of convergence.
    pub order: u32,
    /// Force evaluations a step.
    pub evaluations: u32,
    /// The claims, each in words.
    pub claims: Vec<String>,
    /// Keys in references/bibliography.bib.
    pub source: String,
    /// True where the scheme stands in rankings and tables of verdicts alone, and is not drawn beside the main ones.
    #[serde(default)]
    pub apart: bool,
    /// Number of its colour, marker and dash: the main schemes have the same in every report.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub look: Option<usize>,
    /// Where the scheme fails, in one line, if that is on record.
    #[serde(default)]
    pub fails_where: Option<String>,
}
