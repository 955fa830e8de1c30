//! One sample of a stored solution: strings of digits on their way to numbers.

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

#[cfg(feature = "cli")]
use super::precise::{DoubleDouble, Moment, decimal};
use super::stored::{Stored, StoredError};
#[cfg(feature = "cli")]
use crate::model::Quantity;
use crate::model::body::Shape;
use crate::model::{Snapshot, System};
use crate::rotation::{self, Rotation};

type Triple = [String; 3];

#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case, reason = "the symbols of the files")]
pub(super) struct Sample {
    time_s: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    X_cm: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    U_cm: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    L: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    W: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub W_body: Option<Triple>,
    #[serde(skip_serializing_if = "Option::is_none")]
    E: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    R: Option<[Triple; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    Xt: Option<Vec<Triple>>,
}

impl Sample {
    /// Name and numbers of each field, a line each.
    #[cfg(feature = "cli")]
    pub fn canonical(&self) -> String {
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

impl Sample {
    /// A moment of a motion of `system`, to so many digits.
    #[cfg(feature = "cli")]
    pub fn of(system: &System, moment: &Moment, digits: usize) -> Sample {
        let triple = |v: &[DoubleDouble; 3], quantity: Quantity| {
            decimal::write_vector(v, moment.bound(quantity), digits)
        };
        let turned = |x: Vector3<f64>| {
            let product = |row: usize, column: usize| moment.axes[column][row] * x[column].into();
            [0, 1, 2].map(|row| product(row, 0) + product(row, 1) + product(row, 2))
        };
        let row = |row: usize| {
            triple(&[0, 1, 2].map(|column: usize| moment.axes[column][row]), Quantity::Orientation)
        };
        let places =
            system.body.points.iter().map(|point| triple(&turned(point.position), Quantity::BodyPoint));
        Sample {
            time_s: moment.time.to_string(),
            X_cm: Some(triple(&moment.position, Quantity::Position)),
            U_cm: Some(triple(&moment.velocity, Quantity::Velocity)),
            L: Some(triple(&moment.angular_momentum, Quantity::AngularMomentum)),
            W: Some(triple(&moment.angular_velocity, Quantity::AngularVelocity)),
            W_body: None,
            E: None,
            R: Some([0, 1, 2].map(row)),
            Xt: Some(places.collect()),
        }
    }
}

/// The orientation of a rod with the rounding of its fit turned away, by its farthest point.
fn along_the_places(fit: &Rotation, points: &[Vector3<f64>], places: &[Vector3<f64>]) -> Rotation {
    let farther = |a: &(&Vector3<f64>, &Vector3<f64>), b: &(&Vector3<f64>, &Vector3<f64>)| {
        a.0.norm_squared().total_cmp(&b.0.norm_squared())
    };
    match points.iter().zip(places).max_by(farther) {
        Some((x, place)) if *x != Vector3::zeros() => {
            rotation::turn(&((fit * x).cross(place) / x.norm_squared())) * fit
        }
        _ => *fit,
    }
}

/// A sample on its way to numbers.
pub(super) struct Reader<'a> {
    pub stored: &'a Stored,
    pub index: usize,
    pub sample: &'a Sample,
}

impl Reader<'_> {
    fn number(&self, text: &str) -> Result<f64, StoredError> {
        text.parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| StoredError::Number {
            scene: self.stored.scene.clone(),
            sample: self.index,
            text: text.to_owned(),
        })
    }

    pub fn time(&self) -> Result<f64, StoredError> {
        self.number(&self.sample.time_s)
    }

    fn missing(&self, field: &'static str) -> StoredError {
        StoredError::Missing { scene: self.stored.scene.clone(), sample: self.index, field }
    }

    fn triple(&self, triple: &Triple) -> Result<Vector3<f64>, StoredError> {
        Ok(Vector3::new(self.number(&triple[0])?, self.number(&triple[1])?, self.number(&triple[2])?))
    }

    pub fn vector(&self, field: &'static str, value: &Option<Triple>) -> Result<Vector3<f64>, StoredError> {
        self.triple(value.as_ref().ok_or_else(|| self.missing(field))?)
    }

    pub fn snapshot(&self, system: &System) -> Result<Snapshot, StoredError> {
        let orientation = self.orientation(system)?;
        let angular_velocity = self.vector("W", &self.sample.W)?;
        let given = self.sample.X_cm.is_some() && self.sample.U_cm.is_some();
        let (position, velocity) = if system.body.pivoted && !given {
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
        let orientation = match system.body.shape {
            Shape::Rod { .. } => along_the_places(&orientation, &points, &places),
            Shape::Point | Shape::Extended => orientation,
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
