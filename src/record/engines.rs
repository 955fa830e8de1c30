//! Rows about foreign programs: who they are, and how they stand beside one another and beside our schemes.

use serde::{Deserialize, Serialize};

/// A foreign program under test.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EngineRow {
    /// Name of the scheme: `engine:` and the command line, which holds every setting.
    pub scheme: String,
    /// Name that the program gives itself.
    pub name: String,
    /// Version that it gives itself, or empty.
    pub version: String,
    /// Its integrator, or empty.
    pub integrator: String,
    /// True where it says that it computes in single precision, or where every number that it returned is one.
    pub single_precision: bool,
    /// What is odd about its answers, a sentence each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
}

impl EngineRow {
    /// Name and integrator: `mujoco RK4`.
    pub fn label(&self) -> String {
        format!("{} {}", self.name, self.integrator).trim_end().to_owned()
    }
}

/// One run at a step that every scheme and program is run at.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PeerRow {
    /// Scene.
    pub scene: String,
    /// Scheme, or program.
    pub scheme: String,
    /// Time step [s].
    pub step_s: f64,
    /// Steps taken.
    pub steps: u64,
    /// Orientation error at the end [rad].
    pub orientation_end_rad: Option<f64>,
    /// Error of the centre of mass at the end [m].
    pub position_end_m: Option<f64>,
    /// Largest relative change of the rotational energy.
    pub rotational_energy_max: Option<f64>,
    /// Wall-clock cost of a step, as the program tells it; differs from run to run.
    pub nanoseconds_per_step: Option<f64>,
    /// Why there are no errors, where there are none.
    pub why: Option<String>,
}

/// Two that move a body alike at the same step: their difference is a small part of what either is off by.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Twin {
    /// Scene.
    pub scene: String,
    /// Time step [s].
    pub step_s: f64,
    /// The one.
    pub one: String,
    /// The other.
    pub other: String,
    /// Largest angle between both over the run [rad].
    pub apart_rad: f64,
    /// Largest orientation error over the run of the one that is further off [rad].
    pub error_rad: f64,
    /// Digits of their errors that agree, in orientation and position: log₁₀ of error over difference.
    pub digits: f64,
    /// True where they differ by no more than roundings add up to, in orientation and position.
    pub to_rounding: bool,
}
