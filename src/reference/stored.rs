//! The stored solutions of `references/solutions`: 24 to 40 digits at T/4, T/2, 3T/4 and T.
//!
//! Fourteen were made by independent programs in 230-bit arithmetic; the others by `polhode reference`, whose method
//! meets those fourteen.
//!
//! Numbers are decimal strings, rounded once, to the nearest f64, on reading. A SHA-256 over the canonical text
//! of the samples (defined in `references/solutions/README.md`) is checked before anything is used.

#[cfg(feature = "cli")]
use std::fmt::Write as _;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
#[cfg(feature = "cli")]
use sha2::{Digest, Sha256};

#[cfg(feature = "cli")]
use super::precise::Motion;
use super::sample::{Reader, Sample};
use crate::model::{Snapshot, System};

/// The format that this version reads.
pub const SCHEMA: &str = "polhode/solution/1";

/// A stored solution that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StoredError {
    /// Not the JSON of the schema.
    #[error("stored solution, line {line}, column {column}: {reason}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        reason: String,
    },
    /// Another schema.
    #[error("stored solution '{scene}' has the schema '{found}'; this version reads '{SCHEMA}'")]
    Schema {
        /// Scene.
        scene: String,
        /// Its schema.
        found: String,
    },
    /// Samples that were changed after their checksum was taken.
    #[error("stored solution '{scene}': the samples have SHA-256 {found}, the file says {stated}")]
    Checksum {
        /// Scene.
        scene: String,
        /// What the file says.
        stated: String,
        /// What the samples have.
        found: String,
    },
    /// A string that is no finite number.
    #[error("stored solution '{scene}', sample {sample}: '{text}' is not a finite number")]
    Number {
        /// Scene.
        scene: String,
        /// Index of the sample.
        sample: usize,
        /// The string.
        text: String,
    },
    /// A field that the body needs and the sample lacks.
    #[error("stored solution '{scene}', sample {sample}: '{field}' is missing")]
    Missing {
        /// Scene.
        scene: String,
        /// Index of the sample.
        sample: usize,
        /// The field.
        field: &'static str,
    },
    /// Points that are not those of the body.
    #[error(
        "stored solution '{scene}', sample {sample}: its points are {distance:e} m from those of the body, more than {bound:e} m: it belongs to another body"
    )]
    Body {
        /// Scene.
        scene: String,
        /// Index of the sample.
        sample: usize,
        /// Largest distance [m]; infinite where the numbers of points differ.
        distance: f64,
        /// Distance that rounding may make [m].
        bound: f64,
    },
}

/// A stored solution as it stands in its file.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Stored {
    schema: String,
    /// Name of the scene.
    pub scene: String,
    /// How it was made.
    pub origin: String,
    /// Significant digits.
    pub digits: u32,
    /// Largest absolute difference between two independent calculations.
    pub agreement: String,
    samples: Vec<Sample>,
    sha256: String,
}

/// What a stored solution knows of a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Solution {
    /// Everything.
    Motion(Vec<Snapshot>),
    /// Times [s] and Ω in body axes [rad/s], nothing else.
    Spin(Vec<(f64, Vector3<f64>)>),
}

macro_rules! files {
    ($($scene:literal),* $(,)?) => {
        /// Name and text of every stored solution.
        pub const FILES: &[(&str, &str)] =
            &[$(($scene, include_str!(concat!("../../references/solutions/", $scene, ".json")))),*];
    };
}

files! {
    "free-asymmetric",
    "dzhanibekov",
    "free-oblate",
    "exact-separatrix",
    "free-rod",
    "lagrange-top-pivot-spring",
    "lagrange-top-pivot-spring-undamped",
    "lagrange-fast-top",
    "kovalevskaya",
    "gravity-drag",
    "tether-springs",
    "sciml-rigidbody-wpd",
    "gravity-gradient",
    "time-dependent-field",
    "slow-sphere",
    "fast-sphere",
    "euler-top-unit",
    "heavy-asymmetric-top",
    "sleeping-top",
    "spinning-coin",
    "satellite-gravity-gradient",
    "charged-body-in-fields",
    "dipole-in-field",
    "mujoco-free-box",
    "mujoco-fast-spin",
    "mujoco-middle-axis",
    "jsbsim-rotations",
    "nasa-check-case-2",
    "osrf-boxes-simple",
    "osrf-boxes-complex",
    "thin-body",
    "bouncing-body",
    "tippe-top",
    "water-molecule",
    "planet-free-nutation",
    "satellite-low-orbit",
    "gyrostat",
    "gyrostat-axial",
    "damped-tumble",
    "magnetic-satellite",
    "satellite-circular-orbit",
    "thruster-pulse",
    "thruster-pulse-between-steps",
}

/// The stored solution of a built-in scene; `None` where there is none.
///
/// # Errors
/// [`StoredError`]: the file is not what it was.
pub fn find(scene: &str) -> Result<Option<Stored>, StoredError> {
    FILES.iter().find(|(name, _)| *name == scene).map(|(_, text)| Stored::parse(text)).transpose()
}

impl Stored {
    /// Reads a file and, with the feature `cli`, checks its checksum.
    ///
    /// # Errors
    /// [`StoredError`].
    pub fn parse(text: &str) -> Result<Stored, StoredError> {
        let stored: Stored = serde_json::from_str(text).map_err(|error| StoredError::Syntax {
            line: error.line(),
            column: error.column(),
            reason: error.to_string(),
        })?;
        if stored.schema != SCHEMA {
            return Err(StoredError::Schema { scene: stored.scene, found: stored.schema });
        }
        #[cfg(feature = "cli")]
        stored.check()?;
        Ok(stored)
    }

    /// Whether the samples are those that the checksum was made of.
    #[cfg(feature = "cli")]
    fn check(&self) -> Result<(), StoredError> {
        let (stated, found) = (&self.sha256, self.checksum());
        if found == *stated {
            return Ok(());
        }
        Err(StoredError::Checksum { scene: self.scene.clone(), stated: stated.clone(), found })
    }

    /// A solution of ours, to so many digits, ready to be written.
    #[cfg(feature = "cli")]
    pub fn of(scene: &str, system: &System, motion: &Motion, digits: usize) -> Stored {
        let [(order, _), (other, _)] = motion.runs;
        let samples = motion.moments.iter().map(|moment| Sample::of(system, moment, digits)).collect();
        let largest =
            motion.moments.iter().flat_map(|moment| moment.error.values()).copied().fold(0.0, f64::max);
        let mut stored = Stored {
            schema: SCHEMA.to_owned(),
            scene: scene.to_owned(),
            origin: format!(
                "Taylor series of order {order} in double-double arithmetic, held against a second run of order \
                 {other} with other steps"
            ),
            digits: digits as u32,
            agreement: format!("{largest:.2e}"),
            samples,
            sha256: String::new(),
        };
        stored.sha256 = stored.checksum();
        stored
    }

    /// The text of its file.
    ///
    /// # Errors
    /// What serde_json says.
    pub fn text(&self) -> Result<String, serde_json::Error> {
        let mut text = Vec::new();
        let formatter = serde_json::ser::PrettyFormatter::with_indent(b" ");
        self.serialize(&mut serde_json::Serializer::with_formatter(&mut text, formatter))?;
        Ok(String::from_utf8_lossy(&text).into_owned() + "\n")
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.samples.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.samples.is_empty()
    }

    #[cfg(feature = "cli")]
    fn checksum(&self) -> String {
        let text: String = self.samples.iter().map(Sample::canonical).collect();
        Sha256::digest(text).iter().fold(String::new(), |mut hexadecimal, byte| {
            // Writing to a string cannot fail.
            let _ = write!(hexadecimal, "{byte:02x}");
            hexadecimal
        })
    }

    /// The solution in the terms of `system`, whose scene it is.
    ///
    /// # Errors
    /// [`StoredError::Number`], [`StoredError::Missing`], [`StoredError::Body`].
    pub fn solution(&self, system: &System) -> Result<Solution, StoredError> {
        let samples =
            || self.samples.iter().enumerate().map(|(index, sample)| Reader { stored: self, index, sample });
        if self.samples.iter().all(|sample| sample.W_body.is_some()) {
            let spins = samples().map(|s| Ok((s.time()?, s.vector("W_body", &s.sample.W_body)?)));
            return spins.collect::<Result<_, _>>().map(Solution::Spin);
        }
        samples().map(|s| s.snapshot(system)).collect::<Result<_, _>>().map(Solution::Motion)
    }
}
