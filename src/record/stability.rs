//! What a study of stability measured, as rows that are written to and read from disk.
//!
//! A value that does not exist is `None` (`null` on disk), never a NaN.

use std::path::Path;
use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::{Machine, RecordError, to_digits};
use crate::words::words;

words! {
    /// What a usable step means.
    Meaning {
        /// The energy stays below ten times its scale and nothing breaks.
        #[default]
        Bounded = "bounded",
        /// The energy is within 1 % of its scale of the truth.
        Energy = "energy",
        /// The orientation is within 0.1 rad of the truth.
        Orientation = "orientation",
    }
}

words! {
    /// What was found of a limit.
    LimitStatus {
        /// There is one.
        Limit = "limit",
        /// Every step that was tried is usable.
        Unlimited = "unlimited",
        /// No step that was tried is usable.
        None = "none",
        /// The scheme cannot take the scene.
        #[default]
        NotApplicable = "not-applicable",
        /// The scene has no reference.
        Broken = "broken",
    }
}

words! {
    /// How the energy changes over a long run.
    LongRunClass {
        /// As the root of the number of steps, by about a rounding each.
        RoundingLikeRoot = "rounding-like-root",
        /// As their number, by about a rounding each.
        RoundingLikeN = "rounding-like-n",
        /// It does not grow.
        Bounded = "bounded",
        /// It grows by more than roundings.
        #[default]
        Secular = "secular",
        /// It has grown as far as it can.
        Saturated = "saturated",
        /// The run broke.
        Broken = "broken",
    }
}

/// The schema that [`Stability`] follows.
pub const SCHEMA: &str = "polhode/stability/1";

/// Digits of a cell that is kept for its colour alone: a colour map has some two hundred steps.
const DIGITS: usize = 3;

/// Everything that one study measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// [`SCHEMA`].
    pub schema: String,
    /// Version of Polhode that wrote the records.
    pub polhode: String,
    /// Where the times were measured.
    pub machine: Machine,
    /// Time of writing, RFC 3339, UTC.
    pub made_at: String,
    /// False where the study was interrupted: the rows present are whole, others are missing.
    pub complete: bool,
    /// One row a scene, scheme and meaning of "usable".
    pub limits: Vec<Limit>,
    /// One row a scheme: the limit on the spring-held body at rest, beside linear theory.
    pub linear: Vec<LinearLimit>,
    /// One row a scheme: where it fails, in words.
    pub fails_where: Vec<FailsWhere>,
    /// Maps over two parameters.
    #[serde(default)]
    pub maps: Vec<Map>,
    /// Long runs.
    #[serde(default)]
    pub long_runs: Vec<LongRun>,
    /// Drift rates of the energy beside the law that predicts them.
    #[serde(default)]
    pub energy_law: Vec<EnergyRate>,
    /// One row a scheme: order of convergence across a bounce.
    #[serde(default)]
    pub kink_orders: Vec<KinkOrder>,
}

/// The largest usable step of a scheme in a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// What usable means.
    pub meaning: Meaning,
    /// Whether there is a limit.
    pub status: LimitStatus,
    /// Largest usable step [s]; the largest tried where unlimited.
    pub step_s: Option<f64>,
    /// Smallest step above it that fails [s]; the smallest tried where none is usable.
    pub fails_at_s: Option<f64>,
    /// Radians that the body turns in a step, at its largest |Ω|.
    pub radians_per_step: Option<f64>,
    /// h·ω.
    pub h_omega: Option<f64>,
    /// ω [rad/s].
    pub omega_rad_s: Option<f64>,
    /// What ω is: `natural frequency` or `largest spin`.
    pub omega_is: String,
    /// How the scheme fails above the limit: a class in one word or two.
    pub failure: Option<String>,
    /// The same with numbers, or the reason why there is no limit.
    pub detail: Option<String>,
    /// True where a larger step than the limit is usable again, so that the edge is no clean one.
    pub ragged: bool,
}

impl Limit {
    /// Whether the row tells of steps at all: the scheme takes the scene and the scene has a reference.
    pub fn step_or_none(&self) -> bool {
        matches!(self.status, LimitStatus::Limit | LimitStatus::Unlimited | LimitStatus::None)
    }

    /// The largest usable step [s]: zero where there is none, infinite where none fails.
    pub fn edge(&self) -> f64 {
        match self.status {
            LimitStatus::None => 0.0,
            LimitStatus::Limit => self.step_s.unwrap_or(0.0),
            _ => f64::INFINITY,
        }
    }
}

/// The limit of a scheme on the spring-held body at rest.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LinearLimit {
    /// Scheme.
    pub scheme: String,
    /// Scene whose body and spring it is.
    pub scene: String,
    /// ω of the stiffest mode [rad/s].
    pub omega_rad_s: f64,
    /// ζ of that mode.
    pub zeta: f64,
    /// Largest h·ω at which a small displacement does not grow; `None` where it grows at every step tried, or where none is found.
    pub h_omega: Option<f64>,
    /// The same from the scheme's linear stability polynomial, where it is known.
    pub theory_h_omega: Option<f64>,
    /// The polynomial or rule that the theory rests on.
    pub theory: Option<String>,
    /// How it fails above the limit.
    pub failure: String,
    /// Growth of the displacement a step, just above the limit.
    pub growth_per_step: Option<f64>,
}

/// Where a scheme fails, in one line.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FailsWhere {
    /// Scheme.
    pub scheme: String,
    /// The line.
    pub line: String,
}

/// An axis of a map.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MapAxis {
    /// What varies along it.
    pub name: String,
    /// Its unit; `1` for pure numbers.
    pub unit: String,
    /// Whether the cells are equal in the logarithm.
    pub logarithmic: bool,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// A curve of theory over a map, in the units of its axes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MapCurve {
    /// What it is.
    pub name: String,
    /// Places along the horizontal axis.
    pub x: Vec<f64>,
    /// Places along the vertical axis.
    pub y: Vec<f64>,
}

/// A quantity over two parameters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Map {
    /// Name, kebab-case.
    pub name: String,
    /// Scheme.
    pub scheme: String,
    /// One line.
    pub title: String,
    /// What a cell holds and how it was run.
    pub what: String,
    /// Unit of the cells; `1` for pure numbers.
    pub unit: String,
    /// Horizontal axis.
    pub x: MapAxis,
    /// Vertical axis.
    pub y: MapAxis,
    /// Cells along either axis.
    pub cells: usize,
    /// Rows from the lowest up, each from the left: the value in the middle of a cell, `null` where there is none.
    pub values: Vec<Vec<Option<f64>>>,
    /// For a map of classes: their names; a cell holds the index of its class.
    pub classes: Vec<String>,
    /// A value that separates good from bad, where the map has one.
    pub edge: Option<f64>,
    /// Theory.
    pub curves: Vec<MapCurve>,
    /// Steps of all runs together.
    pub steps: u64,
    /// Wall-clock time that the map took [s]; differs from run to run.
    pub seconds: f64,
    /// How far the edge of the map is from the theory: the median over the rows, relative; `None` without theory.
    pub edge_off_theory: Option<f64>,
}

impl Map {
    /// The map in as many digits as a colour shows, without the time that it took.
    pub fn rounded(self) -> Map {
        let round = |value: Option<f64>| value.map(|value| to_digits(value, DIGITS));
        let values = self.values.into_iter().map(|row| row.into_iter().map(round).collect()).collect();
        Map { values, seconds: 0.0, ..self }
    }
}

/// A run of very many steps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LongRun {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// h [s].
    pub step_s: f64,
    /// Radians turned a step.
    pub radians_per_step: f64,
    /// Steps taken.
    pub steps: u64,
    /// Number of the colour, marker and dash of a main scheme.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub look: Option<usize>,
    /// Step numbers of the samples.
    pub at_step: Vec<u64>,
    /// Change of the rotational energy since the start, relative.
    pub energy_change: Vec<f64>,
    /// Power of n with which the change grows over the last two decades.
    pub growth_power: Option<f64>,
    /// How the energy changes.
    pub class: LongRunClass,
    /// Principal axis that the spin ends on: `smallest`, `middle` or `largest` inertia, or `none`.
    pub final_axis: String,
    /// Why the run ended early, if it did.
    pub why: Option<String>,
    /// Wall-clock time of the steps [s]; differs from run to run.
    pub seconds: f64,
}

/// A measured drift rate of the energy beside the law.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyRate {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// h [s].
    pub step_s: f64,
    /// dE/dt as measured [J/s].
    pub measured_w: f64,
    /// dE/dt of the law [J/s].
    pub law_w: f64,
}

/// The order of a scheme across a bounce.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct KinkOrder {
    /// Scheme.
    pub scheme: String,
    /// Order that the scheme claims for smooth forces.
    pub claimed: u32,
    /// Median of the order between halvings of h, over many drops onto an elastic ground: the force has a kink.
    pub elastic: Option<f64>,
    /// The same on a damped ground: the force jumps.
    pub damped: Option<f64>,
}

impl Stability {
    /// Reads a file that [`write_json`](super::write_json) wrote.
    ///
    /// # Errors
    /// The file cannot be read, is not JSON of this shape, or follows another schema.
    pub fn read(path: &Path) -> Result<Stability, RecordError> {
        let text = super::read_text(path)?;
        Stability::parse(&text).map_err(|why| RecordError::Format { path: path.into(), why })
    }

    /// Reads the text of such a file.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn parse(text: &str) -> Result<Stability, String> {
        let records: Stability = serde_json::from_str(text).map_err(|error| error.to_string())?;
        if records.schema != SCHEMA {
            return Err(format!("schema is \"{}\", expected \"{SCHEMA}\"", records.schema));
        }
        Ok(records)
    }

    /// The limits and lines of this version, for the built-in scenes: references/stability.json.
    ///
    /// # Panics
    /// The file in the program is not of this schema, which a test rules out.
    pub fn built_in() -> &'static Stability {
        static BUILT_IN: LazyLock<Stability> = LazyLock::new(|| {
            Stability::parse(include_str!("../../references/stability.json"))
                .expect("references/stability.json holds a study of stability")
        });
        &BUILT_IN
    }

    /// The limit of a scheme on the spring-held body of a scene, where there is one.
    pub fn linear(&self, scene: &str, scheme: &str) -> Option<&LinearLimit> {
        self.linear.iter().find(|row| row.scene == scene && row.scheme == scheme)
    }

    /// The line of a scheme, where there is one.
    pub fn line(&self, scheme: &str) -> Option<&str> {
        self.fails_where.iter().find(|row| row.scheme == scheme).map(|row| row.line.as_str())
    }
}
