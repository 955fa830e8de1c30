//! What a campaign measured, as rows that are written to and read from disk.
//!
//! This module depends on nothing of Polhode but the names of quantities and claims: these types are all that a reader of
//! `records.json` needs. Every number carries its unit and its uncertainty. A value that does not exist is `None`
//! (`null` on disk), never a NaN.

pub mod stability;
#[cfg(feature = "cli")]
mod capsule;
mod columns;
mod cost;
mod ditto;
mod engines;
mod evidence;
mod faults;
mod findings;
mod motion;
mod nearby;
mod numbers;
mod packed;
#[cfg(feature = "cli")]
mod place;
mod precision;
mod provenance;
mod published;
mod rule;
mod subjects;
#[cfg(feature = "cli")]
mod tables;
#[cfg(all(feature = "cli", target_os = "linux"))]
mod unnamed;
mod verdict;
#[cfg(feature = "cli")]
mod whole;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::bounded::{self, FileError};
pub use crate::claim::ClaimName;
use crate::fault::{self, Fault};
#[cfg(feature = "cli")]
pub use capsule::{Capsule, Difference, Request, SceneText};
pub use cost::{CostRow, Grows, ScalingRow};
pub use engines::{EngineRow, PeerRow, Twin};
pub use evidence::*;
pub(crate) use findings::TIME_DIGITS;
pub use findings::{Drift, DriftClass, Measurement, Order, OrderStatus, RunStatus, Series};
pub use motion::Motion;
pub use numbers::to_digits;
#[cfg(feature = "cli")]
pub(crate) use place::{is_own_baseline, is_own_json, try_place};
pub use precision::{GrowsAs, Growth, PrecisionRow, PrecisionRun, Reach};
pub use provenance::Provenance;
pub use published::{Agreement, PublishedRow, Sureness, last_digit};
pub use rule::Rule;
pub use subjects::{ReferenceRow, SceneRow, SchemeRow};
#[cfg(feature = "cli")]
pub use tables::{BRIEF_CSV_FILES, CSV_FILES, write_brief_csv, write_csv, write_json};
pub use verdict::{Ruling, Verdict};
#[cfg(feature = "cli")]
pub(crate) use whole::rows_are_kept;
#[cfg(feature = "cli")]
pub(crate) use whole::{WholeFile, write_whole};

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
    /// Where these records are a baseline: who made it and why, and those that it replaced, the newest first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub provenance: Vec<Provenance>,
    /// The scenes, in the order of the campaign.
    #[serde(default)]
    pub scenes: Vec<SceneRow>,
    /// The schemes, in the order of the campaign.
    #[serde(default)]
    pub schemes: Vec<SchemeRow>,
    /// One row a scene, scheme, step and error; the other metrics have rows at the finest step. Most of the records, and so shared where
    /// records are cloned.
    pub measurements: Vec<Arc<Measurement>>,
    /// One row a scene, scheme and quantity: the fitted order of convergence.
    pub orders: Vec<Order>,
    /// One row a scene, scheme and conserved quantity: how it drifts.
    #[serde(default)]
    pub drifts: Vec<Drift>,
    /// One row a scene and scheme: what the gates read.
    #[serde(default, skip_serializing_if = "Vec::is_empty", with = "ditto")]
    pub evidence: Vec<Arc<Evidence>>,
    /// One row a scene: its reference, as the gates read it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub references: Vec<ReferenceEvidence>,
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
    /// Motions to be shown, the truth of a scene before its runs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub motions: Vec<Arc<Motion>>,
    /// Foreign programs among the schemes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub engines: Vec<EngineRow>,
    /// Foreign programs and schemes at equal steps.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub peers: Vec<PeerRow>,
    /// Pairs that move a body alike.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub twins: Vec<Twin>,
    /// Figures that others published, beside ours.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub published: Vec<PublishedRow>,
    /// What schemes reach in single and in double precision, one row a scene, scheme and arithmetic.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub precision: Vec<PrecisionRow>,
    /// Growth of a small displacement over step and damping, one map a scheme.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub maps: Vec<stability::Map>,
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
    /// A file is there that this program did not write.
    #[error("{}: this file is not of this program; --force overwrites it", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// A file is not a records file.
    #[error("{}: not a records file: {why}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// A file says what no records file says.
    #[error("{}", fault::lines(file, faults))]
    Content {
        /// The file.
        file: String,
        /// What it says.
        text: String,
        /// All that is wrong, in the order of the file: the first fault of each key of each row.
        faults: Vec<Fault>,
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
        self.evidence.extend(other.evidence);
        self.series.extend(other.series);
        self.motions.extend(other.motions);
        self.costs.extend(other.costs);
        self.scaling.extend(other.scaling);
        self.engines.extend(other.engines);
        self.peers.extend(other.peers);
        self.twins.extend(other.twins);
        self.published.extend(other.published);
        self.precision.extend(other.precision);
        self.maps.extend(other.maps);
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
        kept.evidence.retain(|row| keep(&row.scheme));
        kept.verdicts.retain(|row| keep(&row.scheme));
        kept.series.retain(|row| keep(&row.scheme));
        kept.motions.retain(|row| keep(&row.scheme));
        kept.costs.retain(|row| keep(&row.scheme));
        kept.precision.retain(|row| keep(&row.scheme));
        kept.maps.retain(|row| keep(&row.scheme));
        kept
    }

    /// Reads `records.json`.
    ///
    /// # Errors
    /// The file cannot be read, is not JSON of this shape, or follows another schema.
    pub fn read(path: &Path) -> Result<Records, RecordError> {
        let text = read_text(path)?;
        match serde_json::from_str::<Records>(&text) {
            Ok(records) if records.schema == SCHEMA => Ok(records),
            other => {
                let (file, faults) = (path.display().to_string(), faults::of_records(&text, other.err()));
                Err(RecordError::Content { file, text, faults })
            }
        }
    }
}

/// The text of a file of records.
fn read_text(path: &Path) -> Result<String, RecordError> {
    bounded::text(path, bounded::MOST_OF_RECORDS).map_err(|error| match error {
        FileError::Unreadable { source, .. } => RecordError::File { path: path.into(), source },
        FileError::Content { line, why, .. } => {
            RecordError::Format { path: path.into(), why: format!("line {line}: {why}") }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{ClaimName, DriftClass, OrderStatus, Ruling, RunStatus};

    #[test]
    fn a_file_has_the_word_of_a_value() {
        let text = |json: serde_json::Result<String>| json.expect("JSON");
        for claim in ClaimName::ALL {
            assert_eq!(text(serde_json::to_string(&claim)), format!("\"{claim}\""));
        }
        assert_eq!(text(serde_json::to_string(&Ruling::NotApplicable)), "\"not-applicable\"");
        assert_eq!(text(serde_json::to_string(&RunStatus::Broken)), "\"broken\"");
        assert_eq!(serde_json::from_str::<OrderStatus>("\"too-few\"").ok(), Some(OrderStatus::TooFew));
        assert_eq!(serde_json::from_str::<DriftClass>("\"secular\"").ok(), Some(DriftClass::Secular));
        assert!(serde_json::from_str::<ClaimName>("\"no-such-claim\"").is_err());
    }
}
