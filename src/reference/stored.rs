//! The stored solutions of `references/solutions`: 40 digits at T/4, T/2, 3T/4 and T.
//!
//! Numbers are decimal strings, rounded once, to the nearest f64, on reading. A SHA-256 over the canonical text
//! of the samples (defined in `references/solutions/README.md`) is checked before anything is used.

use std::fmt::Write as _;

use nalgebra::{Matrix3, Vector3};
use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::model::{Snapshot, System};
use crate::rotation::{self, Rotation};

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
#[derive(Clone, Debug, PartialEq, Deserialize)]
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

type Triple = [String; 3];

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "the symbols of the files")]
struct Sample {
    time_s: String,
    X_cm: Option<Triple>,
    U_cm: Option<Triple>,
    L: Option<Triple>,
    W: Option<Triple>,
    W_body: Option<Triple>,
    E: Option<String>,
    R: Option<[Triple; 3]>,
    Xt: Option<Vec<Triple>>,
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
}

/// The stored solution of a built-in scene; `None` where there is none.
///
/// # Errors
/// [`StoredError`]: the file is not what it was.
pub fn find(scene: &str) -> Result<Option<Stored>, StoredError> {
    FILES.iter().find(|(name, _)| *name == scene).map(|(_, text)| Stored::parse(text)).transpose()
}

impl Stored {
    /// Reads a file and checks its checksum.
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
        let found = stored.checksum();
        if found != stored.sha256 {
            return Err(StoredError::Checksum { scene: stored.scene, stated: stored.sha256, found });
        }
        Ok(stored)
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.samples.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.samples.is_empty()
    }

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

impl Sample {
    /// Name and numbers of each field, a line each.
    fn canonical(&self) -> String {
        let triple = |v: &Triple| v.join(" ");
        let rows = |v: &[Triple]| v.iter().map(triple).collect::<Vec<_>>().join(" ");
        let fields = [
            ("time_s", Some(self.time_s.clone())),
            ("X_cm", self.X_cm.as_ref().map(triple)),
            ("U_cm", self.U_cm.as_ref().map(triple)),
            ("L", self.L.as_ref().map(triple)),
            ("W", self.W.as_ref().map(triple)),
            ("W_body", self.W_body.as_ref().map(triple)),
            ("E", self.E.clone()),
            ("R", self.R.as_ref().map(|r| rows(r))),
            ("Xt", self.Xt.as_ref().map(|x| rows(x))),
        ];
        fields.iter().filter_map(|(name, v)| v.as_ref().map(|v| format!("{name} {v}\n"))).collect()
    }
}

/// A sample on its way to numbers.
struct Reader<'a> {
    stored: &'a Stored,
    index: usize,
    sample: &'a Sample,
}

impl Reader<'_> {
    fn number(&self, text: &str) -> Result<f64, StoredError> {
        text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| StoredError::Number {
            scene: self.stored.scene.clone(),
            sample: self.index,
            text: text.to_owned(),
        })
    }

    fn time(&self) -> Result<f64, StoredError> {
        self.number(&self.sample.time_s)
    }

    fn missing(&self, field: &'static str) -> StoredError {
        StoredError::Missing { scene: self.stored.scene.clone(), sample: self.index, field }
    }

    fn triple(&self, triple: &Triple) -> Result<Vector3<f64>, StoredError> {
        Ok(Vector3::new(self.number(&triple[0])?, self.number(&triple[1])?, self.number(&triple[2])?))
    }

    fn vector(&self, field: &'static str, value: &Option<Triple>) -> Result<Vector3<f64>, StoredError> {
        self.triple(value.as_ref().ok_or_else(|| self.missing(field))?)
    }

    fn snapshot(&self, system: &System) -> Result<Snapshot, StoredError> {
        let orientation = self.orientation(system)?;
        let angular_velocity = self.vector("W", &self.sample.W)?;
        let (position, velocity) = if system.body.pivoted {
            let arm = orientation * system.body.center;
            (system.origin() + arm, angular_velocity.cross(&arm))
        } else {
            (self.vector("X_cm", &self.sample.X_cm)?, self.vector("U_cm", &self.sample.U_cm)?)
        };
        Ok(Snapshot {
            time: self.time()?,
            position,
            velocity,
            orientation,
            angular_velocity,
            angular_momentum: self.vector("L", &self.sample.L)?,
            stretch: 0.0,
        })
    }

    /// R, or the rotation that carries the body's points to `Xt`, which must fit them.
    fn orientation(&self, system: &System) -> Result<Rotation, StoredError> {
        let given = self.sample.Xt.as_ref().ok_or_else(|| self.missing("Xt"))?;
        let places = given.iter().map(|p| self.triple(p)).collect::<Result<Vec<_>, _>>()?;
        let points: Vec<_> = system.body.points.iter().map(|p| p.position).collect();
        let masses: Vec<_> = system.body.points.iter().map(|p| p.mass).collect();
        let orientation = match &self.sample.R {
            Some([x, y, z]) => {
                let rows = [self.triple(x)?, self.triple(y)?, self.triple(z)?];
                rotation::from_matrix(&Matrix3::from_rows(&rows.map(|row| row.transpose())))
            }
            None => rotation::best_fit(&points, &places, &masses),
        };
        let apart = |(x, place): (&Vector3<f64>, &Vector3<f64>)| rotation::length(&(orientation * x - place));
        let farthest = points.iter().zip(&places).map(apart).fold(0.0, f64::max);
        let distance = if points.len() == places.len() { farthest } else { f64::INFINITY };
        // A rotation of a rounded vector: a few u of its length.
        let bound = 16.0 * f64::EPSILON * system.body.extent();
        if distance <= bound {
            return Ok(orientation);
        }
        Err(StoredError::Body { scene: self.stored.scene.clone(), sample: self.index, distance, bound })
    }
}
