//! What a campaign measured, as rows that are written to and read from disk.
//!
//! This module depends on nothing else of Polhode: whoever holds a `records.json` needs only these types to
//! read it. Every number carries its unit and its uncertainty. A value that does not exist is `None`
//! (`null` on disk), never a NaN.

pub mod stability;
mod engines;
mod tables;
mod whole;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

pub use engines::{EngineRow, PeerRow, Twin};
pub use tables::{write_csv, write_json};
pub use whole::{WholeFile, write_whole};

/// The schema that [`Records`] follows.
pub const SCHEMA: &str = "polhode/records/1";

/// Everything that one campaign measured and judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Records {
    /// [`SCHEMA`].
    pub schema: String,
    /// Version of Polhode that wrote the records.
    pub polhode: String,
    /// Where the costs were measured.
    pub machine: Machine,
    /// Time of writing, RFC 3339, UTC.
    pub made_at: String,
    /// False where the campaign was interrupted: the rows present are whole, others are missing.
    #[serde(default)]
    pub complete: bool,
    /// The scenes, in the order of the campaign.
    #[serde(default)]
    pub scenes: Vec<SceneRow>,
    /// The schemes, in the order of the campaign.
    #[serde(default)]
    pub schemes: Vec<SchemeRow>,
    /// One row a scene, scheme, step and metric; nine tenths of the records, and so shared where records are cloned.
    pub measurements: Vec<Arc<Measurement>>,
    /// One row a scene, scheme and quantity: the fitted order of convergence.
    pub orders: Vec<Order>,
    /// One row a scene, scheme and conserved quantity: how it drifts.
    #[serde(default)]
    pub drifts: Vec<Drift>,
    /// One row a claim that was judged.
    pub verdicts: Vec<Verdict>,
    /// What a step costs, one row a scheme and work.
    #[serde(default)]
    pub costs: Vec<CostRow>,
    /// Cost against size: of a body, of a campaign.
    #[serde(default)]
    pub scaling: Vec<ScalingRow>,
    /// Quantities against time, for drawing.
    #[serde(default)]
    pub series: Vec<Arc<Series>>,
    /// Foreign programs among the schemes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub engines: Vec<EngineRow>,
    /// Foreign programs and schemes at equal steps.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub peers: Vec<PeerRow>,
    /// Pairs that move a body alike.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub twins: Vec<Twin>,
}

/// The machine that the costs belong to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// Operating system.
    pub os: String,
    /// Instruction set.
    pub architecture: String,
    /// Processor as it names itself, or empty.
    pub processor: String,
    /// Threads that may run at once.
    pub threads: usize,
}

/// A scene as the report prints it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SceneRow {
    /// Name, kebab-case.
    pub name: String,
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
    /// Largest relative difference of a state between the least model and the mass points as written,
    /// after 1,000 steps; `None` where the body has no points.
    pub reduction_difference: Option<f64>,
    /// Cost of a step on the mass points over its cost on the least model.
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
    /// Where the scheme fails, in one line, if that is on record.
    #[serde(default)]
    pub fails_where: Option<String>,
}

/// One number of one run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Model that was run.
    pub model: String,
    /// Time step [s].
    pub step_s: f64,
    /// Steps taken.
    pub steps: u64,
    /// Metric, for example `orientation-end`.
    pub metric: String,
    /// Value in `unit`; `None` where the run broke or the metric does not apply.
    pub value: Option<f64>,
    /// Unit of `value` and `uncertainty`; `1` for pure numbers.
    pub unit: String,
    /// The larger of the reference's uncertainty and the measured rounding floor.
    pub uncertainty: Option<f64>,
    /// `ok`, `broken` or `not-applicable`.
    pub status: String,
    /// Reason, where `status` is not `ok`.
    pub why: Option<String>,
    /// Evaluations of the forces in the whole run.
    pub force_evaluations: u64,
    /// Wall-clock cost of a step; differs from run to run.
    pub nanoseconds_per_step: Option<f64>,
}

/// What a step of a scheme costs on a kind of scene, timed alone on the machine; differs from run to run and decides nothing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CostRow {
    /// Scheme.
    pub scheme: String,
    /// Kind of scene: `free`, `falling`, `torque or pivot`, `forced` or `points`.
    pub kind: String,
    /// Model that was run.
    pub model: String,
    /// The scene that stands for all of the same model, laws and number of points.
    pub scene: String,
    /// Time step [s].
    pub step_s: f64,
    /// Wall-clock cost of a step in the least block.
    pub nanoseconds_per_step: f64,
    /// In the median block.
    pub median_nanoseconds_per_step: f64,
    /// Evaluations of the forces a step, counted.
    pub evaluations_per_step: f64,
    /// Steps of a block.
    pub steps_a_block: u64,
    /// Blocks timed.
    pub blocks: usize,
    /// Time spent in them [s].
    pub seconds: f64,
    /// True for the second measurement of the same course: what it differs by is noise.
    #[serde(default)]
    pub again: bool,
}

/// A cost against a size.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ScalingRow {
    /// What grows: `points` (mass points of the body) or `cells` (schemes × scenes of a campaign).
    pub what: String,
    /// Scheme, or nothing for a campaign.
    pub scheme: String,
    /// Form of the model: `points` or `least`; nothing for a campaign.
    pub form: String,
    /// Threads.
    pub threads: usize,
    /// How many.
    pub size: u64,
    /// The cost in `unit`.
    pub value: f64,
    /// `ns/step` or `s`.
    pub unit: String,
}

/// The fitted order of convergence of one quantity.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Order {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Quantity with the place it is taken at: `orientation-end`, `position-max`, …
    pub quantity: String,
    /// Least-squares slope of log error against log step; `None` where no window was found.
    pub order: Option<f64>,
    /// Lower end of its 95 % confidence interval.
    pub low: Option<f64>,
    /// Upper end of its 95 % confidence interval.
    pub high: Option<f64>,
    /// Leading error constant C = e/hᵖ with the claimed order p, in `unit`/sᵖ.
    pub constant: Option<f64>,
    /// Rungs of the ladder inside the fitted window.
    pub rungs_used: usize,
    /// Rungs left out: near the floor, before the asymptotic range, or broken.
    pub rungs_dropped: usize,
    /// The steps inside the fitted window [s].
    #[serde(default)]
    pub steps_used_s: Vec<f64>,
    /// Errors below this are rounding or reference error, in `unit`.
    #[serde(default)]
    pub floor: Option<f64>,
    /// Unit of the error.
    #[serde(default)]
    pub unit: String,
    /// `fitted`, `exact`, `unsettled`, `too-few` or `broken`.
    #[serde(default)]
    pub status: String,
    /// Reason, where `status` is not `fitted`.
    #[serde(default)]
    pub why: Option<String>,
}

/// How a conserved quantity drifts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drift {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Quantity: `rotational-energy`, `angular-momentum-magnitude`, …
    pub quantity: String,
    /// `exact`, `bounded`, `secular`, `growing` or `undecided`.
    pub class: String,
    /// For a secular drift: order in the step of its rate.
    pub rate_order: Option<f64>,
    /// Lower end of the 95 % confidence interval of `rate_order`.
    pub low: Option<f64>,
    /// Upper end of the 95 % confidence interval of `rate_order`.
    pub high: Option<f64>,
    /// Rate at the finest step that still shows one, in `unit`/s.
    pub rate: Option<f64>,
    /// The step that `rate` belongs to [s].
    pub step_s: Option<f64>,
    /// Largest deviation over the run at that step, in `unit`.
    pub level: Option<f64>,
    /// Unit of the quantity; `1` for relative changes.
    pub unit: String,
}

/// Whether a claim holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ruling {
    /// The claim holds.
    Pass,
    /// The claim does not hold.
    Fail,
    /// The measurement cannot decide.
    #[default]
    Inconclusive,
    /// The claim says nothing about this scene.
    NotApplicable,
    /// The run or its reference failed.
    Broken,
}

impl Ruling {
    /// The word that stands in records and tables.
    pub fn word(self) -> &'static str {
        match self {
            Ruling::Pass => "pass",
            Ruling::Fail => "fail",
            Ruling::Inconclusive => "inconclusive",
            Ruling::NotApplicable => "not-applicable",
            Ruling::Broken => "broken",
        }
    }
}

/// One claim, judged.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Claim, for example `order`.
    pub claim: String,
    /// Quantity that the claim is about.
    pub quantity: String,
    /// The ruling.
    pub verdict: Ruling,
    /// What was measured.
    pub measured: Option<f64>,
    /// Lower end of its uncertainty.
    pub low: Option<f64>,
    /// Upper end of its uncertainty.
    pub high: Option<f64>,
    /// The reason in words, with bound and unit.
    pub detail: String,
    /// Reason why this failure is known and does not fail the gate, if it is.
    #[serde(default)]
    pub known_deviation: Option<String>,
}

/// A quantity against time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// Scene.
    pub scene: String,
    /// Scheme.
    pub scheme: String,
    /// Time step [s].
    pub step_s: f64,
    /// Quantity: `rotational-energy`, `total-energy`, `angular-momentum` (relative change of its magnitude), …
    pub quantity: String,
    /// Unit of `value`; `1` for relative changes.
    pub unit: String,
    /// Times [s].
    pub time_s: Vec<f64>,
    /// Values at those times.
    pub value: Vec<f64>,
}

/// Reading or writing records failed.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file is not a records file.
    #[error("{}: not a records file: {why}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
}

impl Records {
    /// Takes in what another campaign measured on some of the same scenes with other schemes. What it says of the references is
    /// already here.
    pub fn take_in(&mut self, other: Records) {
        self.complete &= other.complete;
        self.schemes.extend(other.schemes);
        self.measurements.extend(other.measurements);
        self.orders.extend(other.orders);
        self.drifts.extend(other.drifts);
        self.series.extend(other.series);
        self.costs.extend(other.costs);
        self.scaling.extend(other.scaling);
        self.engines.extend(other.engines);
        self.peers.extend(other.peers);
        self.twins.extend(other.twins);
        let judged = self.verdicts.len();
        for verdict in other.verdicts {
            if !self.verdicts[..judged].contains(&verdict) {
                self.verdicts.push(verdict);
            }
        }
    }

    /// Without the schemes that stand apart.
    pub fn without_apart(&self) -> Records {
        let apart: Vec<&str> = self.schemes.iter().filter(|s| s.apart).map(|s| s.name.as_str()).collect();
        let mut kept = self.clone();
        let keep = |scheme: &str| !apart.contains(&scheme);
        kept.schemes.retain(|row| keep(&row.name));
        kept.measurements.retain(|row| keep(&row.scheme));
        kept.orders.retain(|row| keep(&row.scheme));
        kept.drifts.retain(|row| keep(&row.scheme));
        kept.verdicts.retain(|row| keep(&row.scheme));
        kept.series.retain(|row| keep(&row.scheme));
        kept.costs.retain(|row| keep(&row.scheme));
        kept
    }

    /// Reads `records.json`.
    ///
    /// # Errors
    /// The file cannot be read, is not JSON of this shape, or follows another schema.
    pub fn read(path: &Path) -> Result<Records, RecordError> {
        let text =
            fs::read_to_string(path).map_err(|source| RecordError::File { path: path.into(), source })?;
        let format = |why| RecordError::Format { path: path.into(), why };
        let records: Records = serde_json::from_str(&text).map_err(|error| format(error.to_string()))?;
        if records.schema != SCHEMA {
            return Err(format(format!("schema is \"{}\", expected \"{SCHEMA}\"", records.schema)));
        }
        Ok(records)
    }
}
