//! The table `[body]` of a scene file: mass points in any frame, or a mass and an inertia.

use nalgebra::Vector3;

use super::table::Table;
use super::value::Value;
use super::wording;
use crate::fault::Fault;
use crate::model::body::{Body, BodyError, MassPoint};

/// The keys of `[body]`.
pub(super) const KEYS: &[&str] = &["points", "massless", "mass", "inertia", "unphysical_inertia", "pivot"];

/// A body, and where its frame lies.
pub(super) struct Given {
    /// The body about its origin.
    pub body: Body,
    /// Centre of mass [m], in the frame of the points.
    pub center: Vector3<f64>,
    /// Origin of the body [m], in the frame of the points: the pivot, or the centre of mass.
    pub origin: Vector3<f64>,
}

/// Reads the body, and notes all that is wrong with it.
pub(super) fn read(entry: &Value) -> Option<Given> {
    let document = entry.document();
    let table = document.keep(entry.table(KEYS))?;
    document.keep(table.not_both("points", "inertia"))?;
    let pivot = document.keep(table.optional_vector("pivot"));
    match (table.get("points"), table.get("inertia")) {
        (Some(points), _) => from_points(&table, &points, pivot),
        (None, Some(inertia)) => from_inertia(&table, &inertia, pivot),
        (None, None) => {
            let advice = "write points = [ { mass = 1.0, position = [0.5, 0.0, 0.0] }, … ], or mass = 1.0 and \
                          inertia = [1.0, 2.0, 2.5]";
            let line = match table.get("mass") {
                Some(_) => "inertia = [1.0, 2.0, 2.5]",
                None => "points = [ { mass = 1.0, position = [0.5, 0.0, 0.0] } ]",
            };
            document.note(table.missing("points", line).advised(advice));
            None
        }
    }
}

/// Reads mass points; `pivot` is none where it is wrong.
fn from_points(table: &Table, points: &Value, pivot: Option<Option<Vector3<f64>>>) -> Option<Given> {
    let document = table.document();
    for (key, why) in [
        ("mass", "the masses of the points say it: remove it"),
        ("unphysical_inertia", "mass points cannot have one: remove it"),
    ] {
        if let Some(fault) = table.unwanted(key, format!("stands beside points, and {why}")) {
            document.note(fault);
        }
    }
    let items = document.keep(points.list("a list of mass points"))?;
    let given: Vec<Option<MassPoint>> = items.iter().map(mass_point).collect();
    let given = given.into_iter().collect::<Option<Vec<_>>>()?;
    let massless = document.keep(table.get("massless").map_or(Ok(Vec::new()), |value| places(&value)))?;
    let pivot = pivot?;
    let (body, center) =
        document.keep(Body::with_massless(&given, &massless, pivot).map_err(|error| match error {
            BodyError::Empty => points.expected("at least one mass point"),
            BodyError::Massless => {
                let fault = table.unwanted("massless", error.to_string());
                fault.unwrap_or_else(|| refused(points, &error))
            }
            other => refused(points, &other),
        }))?;
    Some(Given { body, center, origin: pivot.unwrap_or(center) })
}

fn mass_point(item: &Value) -> Option<MassPoint> {
    let document = item.document();
    let table = document.keep(item.table(&["mass", "position"]))?;
    let mass = document.keep(table.required("mass").and_then(|value| value.positive()));
    let position = document.keep(table.vector("position"));
    Some(MassPoint { mass: mass?, position: position? })
}

fn places(value: &Value) -> Result<Vec<Vector3<f64>>, Fault> {
    value.list("a list of places")?.iter().map(Value::vector).collect()
}

fn from_inertia(table: &Table, inertia: &Value, pivot: Option<Option<Vector3<f64>>>) -> Option<Given> {
    let document = table.document();
    let message =
        "stands beside inertia: give the body as points, or name the place of a spring by at = [x, y, z]";
    if let Some(fault) = table.unwanted("massless", message) {
        document.note(fault);
    }
    let mass = document.keep(table.required("mass").and_then(|value| value.positive()));
    let flag = table.get("unphysical_inertia").map_or(Ok(false), |flag| flag.flag());
    let unphysical = document.keep(flag);
    let matrix = document.keep(inertia.matrix("three principal moments, or three rows of three numbers"));
    let pivot = pivot?;
    let matrix = matrix?;
    let body = Body::from_inertia(mass?, matrix, pivot, unphysical?).map_err(|error| {
        let BodyError::Asymmetric { row, column, .. } = error else { return refused(inertia, &error) };
        let fault = refused(entry_of(inertia, row, column).as_ref().unwrap_or(inertia), &error);
        fault.replaced(format!("{:?}", matrix[(column, row)]))
    });
    Some(Given { body: document.keep(body)?, center: Vector3::zeros(), origin: pivot.unwrap_or_default() })
}

fn entry_of<'t>(inertia: &Value<'t>, row: usize, column: usize) -> Option<Value<'t>> {
    let rows = inertia.list("").ok()?;
    rows.get(row)?.list("").ok()?.into_iter().nth(column)
}

/// What the body says of itself, with what to write instead where it does not say so.
fn refused(place: &Value, error: &BodyError) -> Fault {
    let fault = place.refuse(error.to_string());
    match error {
        BodyError::Asymmetric { row, column, .. } => {
            fault.advised(format!("write the same number in row {} column {}", column + 1, row + 1))
        }
        BodyError::NegativeMoment { .. } => fault.advised("write moments that are zero or above"),
        BodyError::Condition { .. } => fault.advised("write zero for the smallest moment, or a thicker body"),
        BodyError::Range => fault.advised("choose other units, so that the numbers are nearer to one"),
        BodyError::Mass { .. } | BodyError::Empty => {
            fault.advised(format!("write {}", wording::example("points")))
        }
        BodyError::Triangle { .. } | BodyError::Massless => fault,
    }
}
