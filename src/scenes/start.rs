//! The table `[initial]` of a scene file, and the system that it sets going.

use nalgebra::{Quaternion, Vector3, Vector4};

use super::SceneError;
use super::body::Given;
use super::table::Table;
use super::value::Value;
use super::wording;
use crate::model::body::{Body, Shape};
use crate::model::forces::{Kind, Law, TorqueAxes};
use crate::model::{Spin, System, SystemError};
use crate::rotation::{self, Rotation};

/// How far an orientation may be from a unit quaternion, and a stated start from what the body can do.
const TOLERANCE: f64 = 1e-9;

/// The keys of `[initial]`.
pub(super) const KEYS: &[&str] =
    &["position", "orientation", "velocity", "angular_velocity", "angular_velocity_body", "angular_momentum"];

/// The keys that say how the body turns, of which a scene gives one.
const SPINS: [&str; 3] = ["angular_velocity", "angular_velocity_body", "angular_momentum"];

/// The keys of an orientation that is given by Euler angles.
pub(super) const EULER: &[&str] = &["euler", "sequence", "axes", "unit"];

/// Puts the body under its laws from its start. `initial` is the table where there is one, `entries` the tables
/// of the laws.
pub(super) fn system(
    given: Given,
    initial: Option<&Table>,
    laws: Vec<Law>,
    entries: &[Value],
    whole: &Table,
) -> Result<System, SceneError> {
    let get = |key| initial.and_then(|table| table.get(key));
    let vector = |key| get(key).map(|value| value.vector()).transpose();
    if let Some(table) = initial {
        table.one_of(&SPINS)?;
    }
    let position = vector("position")?.unwrap_or(given.center);
    let orientation =
        get("orientation").map_or(Ok(Rotation::identity()), |value| read_orientation(&value))?;
    let velocity = vector("velocity")?;
    let key_of_spin = SPINS.into_iter().find(|key| get(key).is_some()).unwrap_or(SPINS[0]);
    let given_spin = vector(key_of_spin)?.unwrap_or_default();
    let spin = match key_of_spin {
        "angular_momentum" => Spin::Momentum(given_spin),
        "angular_velocity_body" => Spin::Velocity(orientation * given_spin),
        _ => Spin::Velocity(given_spin),
    };
    let place = get(key_of_spin);
    if let (Some(place), Spin::Velocity(spin)) = (&place, &spin) {
        check_spin(place, &given.body, &orientation, spin)?;
    }
    let start_velocity = velocity.unwrap_or_default();
    let system = System::new(given.body, laws, position, orientation, start_velocity, spin)
        .map_err(|error| located(&error, entries, place.as_ref(), whole))?;
    if let Some(value) = get("velocity") {
        check_velocity(&value, &system, &start_velocity)?;
    }
    check_range(&system, place.as_ref(), whole)?;
    Ok(system)
}

fn read_orientation(value: &Value) -> Result<Rotation, SceneError> {
    if value.is_table() {
        return read_euler(&value.table(EULER)?);
    }
    let given: Vector4<f64> = value.quaternion()?;
    let norm = given.norm();
    if (norm - 1.0).abs() <= TOLERANCE {
        let [w, x, y, z] = given.into();
        return Ok(Rotation::new_normalize(Quaternion::new(w, x, y, z)));
    }
    let unit = given / norm;
    let instead = if norm.is_finite() && norm > 1e-150 {
        wording::list(unit.as_slice())
    } else {
        "[1.0, 0.0, 0.0, 0.0]".to_string()
    };
    Err(value.refuse(format!(
        "a quaternion of length {norm:?} is no orientation, which needs length 1 to 1e-9: write orientation = {instead}"
    )))
}

/// Three angles, and the axes that they are about.
fn read_euler(table: &Table) -> Result<Rotation, SceneError> {
    let angles = table.required("euler")?.vector()?;
    let sequence = table.required("sequence")?;
    let letters: Vec<usize> = sequence.text()?.chars().filter_map(|letter| "xyz".find(letter)).collect();
    let axes = <[usize; 3]>::try_from(letters).ok().filter(|axes| {
        axes[0] != axes[1] && axes[1] != axes[2] && sequence.text().is_ok_and(|text| text.len() == 3)
    });
    let Some(axes) = axes else {
        return Err(sequence.expected("three letters of x, y, z, no two alike side by side"));
    };
    let unit = table.required("unit")?;
    let factor = match unit.text()? {
        "deg" => 1f64.to_radians(),
        "rad" => 1.0,
        _ => return Err(unit.expected("\"deg\" or \"rad\"")),
    };
    let of_body = table.get("axes").map_or(Ok(TorqueAxes::Body), |value| value.axes())? == TorqueAxes::Body;
    Ok(rotation::euler((angles * factor).into(), axes, of_body))
}

/// Refuses a spin that the body does not have: of a point, or of a rod about itself.
fn check_spin(
    place: &Value,
    body: &Body,
    orientation: &Rotation,
    spin: &Vector3<f64>,
) -> Result<(), SceneError> {
    let length = rotation::length(spin);
    match body.shape {
        Shape::Point if length != 0.0 => {
            Err(place.refuse("the body is a single point, which cannot spin: remove this line"))
        }
        Shape::Rod { direction } => {
            let direction = orientation * direction;
            let along = direction.dot(spin);
            if along.abs() <= TOLERANCE * length {
                return Ok(());
            }
            let across = spin - direction * along;
            Err(place.refuse(format!(
                "the body is a rod and cannot spin about its own line, as {along:?} rad/s of this would: write \
                 angular_velocity = {}",
                wording::list(across.as_slice())
            )))
        }
        _ => Ok(()),
    }
}

/// Refuses a velocity that the pivot contradicts.
fn check_velocity(value: &Value, system: &System, given: &Vector3<f64>) -> Result<(), SceneError> {
    let actual = system.start.velocity;
    let apart = rotation::length(&(given - actual));
    let size = rotation::length(given);
    if !system.body.pivoted || size == 0.0 || apart <= TOLERANCE * size {
        return Ok(());
    }
    Err(value.refuse(format!(
        "the pivot and the spin give the centre of mass the velocity {}: remove this line",
        wording::list(actual.as_slice())
    )))
}

/// Refuses a start whose products leave the range of f64.
fn check_range(system: &System, place: Option<&Value>, whole: &Table) -> Result<(), SceneError> {
    let start = &system.start;
    let body_momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
    let spin = system.body.inverse_inertia() * body_momentum;
    let finite = [start.velocity, start.angular_momentum, spin, system.origin()]
        .iter()
        .all(|vector| vector.iter().all(|x| x.is_finite()));
    let momentum_lost =
        system.body.shape == Shape::Extended && start.angular_momentum.amax() > 0.0 && spin.amax() == 0.0;
    if finite && !momentum_lost {
        return Ok(());
    }
    let message = "spin and inertia multiply out of the range of f64: choose other units, so that the numbers are \
                   nearer to one";
    Err(place.map_or_else(|| whole.refuse("initial", message), |place| place.refuse(message)))
}

/// Puts file, line and key to what the system says of itself.
fn located(error: &SystemError, entries: &[Value], spin: Option<&Value>, whole: &Table) -> SceneError {
    let in_law = |index: usize, key: &str| entries.get(index).and_then(|entry| entry.member(key));
    let (place, advice) = match error {
        SystemError::AlongRod { .. } | SystemError::PointMomentum { .. } => (spin.cloned(), String::new()),
        SystemError::TorqueAlongRod { index, .. } => {
            (in_law(*index, "at").or_else(|| in_law(*index, "law")), String::new())
        }
        SystemError::NoPoints { index, .. } => {
            (in_law(*index, "law"), "; remove the law or give the body as points".to_string())
        }
        SystemError::ListLength { index, points, .. } => (
            Law::ALL
                .iter()
                .flat_map(|law| law.parameters)
                .filter(|parameter| parameter.kind == Kind::PerPoint)
                .find_map(|parameter| in_law(*index, parameter.key)),
            format!(": write {points} values, or one number for all"),
        ),
        SystemError::PointIndex { index, points: 0, .. } => {
            (in_law(*index, "point"), ": write at = [x, y, z] instead".to_string())
        }
        SystemError::PointIndex { index, points, .. } => {
            (in_law(*index, "point"), format!(": write point = 0 to {}", points - 1))
        }
        SystemError::NoPointForm | SystemError::Range { .. } => (None, String::new()),
    };
    let message = format!("{error}{advice}");
    place.map_or_else(|| whole.refuse("body", message.clone()), |place| place.refuse(message.clone()))
}
