//! What a step costs, and how its cost grows.

use serde::{Deserialize, Serialize};

use crate::words::words;

words! {
    /// What a cost is measured against.
    Grows {
        /// The number of mass points of the body.
        #[default]
        Points = "points",
        /// The number of cells of a campaign, schemes × scenes: in files of former versions.
        Cells = "cells",
    }
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
    /// What grows.
    pub what: Grows,
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
