//! The table `[body]` of a scene file: mass points in any frame, or a mass and an inertia.

use nalgebra::Vector3;

use super::SceneError;
use super::table::Table;
use super::value::Value;
use super::wording;
use crate::model::body::{Body, BodyError, MassPoint};

/// The keys of `[body]`.
pub(super) const KEYS: &[&str] = &["points", "mass", "inertia", "unphysical_inertia", "pivot"];

/// A body, and where its frame lies.
pub(super) struct Given {
    /// The body about its origin.
    pub body: Body,
    /// Centre of mass [m], in the frame of the points.
    pub center: Vector3<f64>,
    /// Origin of the body [m], in the frame of the points: the pivot, or the centre of mass.
    pub origin: Vector3<f64>,
}

/// Reads the body.
pub(super) fn read(entry: &Value) -> Result<Given, SceneError> {
    let table = entry.table(KEYS)?;
    table.not_both("points", "inertia")?;
    let pivot = table.optional_vector("pivot")?;
    match (table.get("points"), table.get("inertia")) {
        (Some(points), _) => from_points(&table, &points, pivot),
        (None, Some(inertia)) => from_inertia(&table, &inertia, pivot),
        (None, None) => {
            let message = "is missing: write points = [ { mass = 1.0, position = [0.5, 0.0, 0.0] }, … ], or \
                           mass = 1.0 and inertia = [1.0, 2.0, 2.5]";
            Err(table.refuse("points", message))
        }
    }
}

fn from_points(table: &Table, points: &Value, pivot: Option<Vector3<f64>>) -> Result<Given, SceneError> {
    for (key, why) in [
        ("mass", "the masses of the points say it: remove it"),
        ("unphysical_inertia", "mass points cannot have one: remove it"),
    ] {
        if let Some(value) = table.get(key) {
            return Err(value.refuse(format!("stands beside points, and {why}")));
        }
    }
    let items = points.list("a list of mass points")?;
    let given: Vec<MassPoint> = items.iter().map(mass_point).collect::<Result<_, _>>()?;
    let (body, center) = Body::from_points(&given, pivot).map_err(|error| match error {
        BodyError::Empty => points.expected("at least one mass point"),
        other => points.refuse(advised(&other)),
    })?;
    Ok(Given { body, center, origin: pivot.unwrap_or(center) })
}

fn mass_point(item: &Value) -> Result<MassPoint, SceneError> {
    let table = item.table(&["mass", "position"])?;
    Ok(MassPoint { mass: table.required("mass")?.positive()?, position: table.vector("position")? })
}

fn from_inertia(table: &Table, inertia: &Value, pivot: Option<Vector3<f64>>) -> Result<Given, SceneError> {
    let mass = table.required("mass")?.positive()?;
    let unphysical = table.get("unphysical_inertia").map_or(Ok(false), |flag| flag.flag())?;
    let body = Body::from_inertia(mass, inertia.matrix("three principal moments, or three rows of three numbers")?, pivot, unphysical).map_err(|error| {
        let place = match error {
            BodyError::Asymmetric { row, column, .. } => entry_of(inertia, row, column),
            _ => None,
        };
        place.as_ref().unwrap_or(inertia).refuse(advised(&error))
    })?;
    Ok(Given { body, center: Vector3::zeros(), origin: pivot.unwrap_or_default() })
}

fn entry_of<'t>(inertia: &Value<'t>, row: usize, column: usize) -> Option<Value<'t>> {
    let rows = inertia.list("").ok()?;
    rows.get(row)?.list("").ok()?.into_iter().nth(column)
}

/// What the body says of itself, with what to write instead where it does not say so.
fn advised(error: &BodyError) -> String {
    let advice = match error {
        BodyError::Asymmetric { row, column, .. } => {
            format!("write the same number in row {} column {}", column + 1, row + 1)
        }
        BodyError::NegativeMoment { .. } => "write moments that are zero or above".to_string(),
        BodyError::Condition { .. } => "write zero for the smallest moment, or a thicker body".to_string(),
        BodyError::Range => "choose other units, so that the numbers are nearer to one".to_string(),
        BodyError::Mass { .. } | BodyError::Empty => format!("write {}", wording::example("points")),
        BodyError::Triangle { .. } => return error.to_string(),
    };
    format!("{error}: {advice}")
}
