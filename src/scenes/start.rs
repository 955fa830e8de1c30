//! The table `[initial]` of a scene file, and the system that it sets going.

use nalgebra::{Quaternion, Vector3, Vector4};

use super::body::Given;
use super::table::Table;
use super::value::Value;
use super::wording;
use crate::fault::Fault;
use crate::model::body::{Body, Shape};
use crate::model::forces::{Kind, Law, TorqueAxes};
use crate::model::system::faults_of_laws as system_faults;
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

/// A start as it is given, before the body has a say in it.
pub(super) struct Stated<'t> {
    table: Option<Table<'t>>,
    position: Option<Vector3<f64>>,
    orientation: Rotation,
    velocity: Option<Vector3<f64>>,
    spin: Spin,
    /// The key that says how the body turns.
    key_of_spin: &'static str,
}

/// Reads the table where there is one, and notes all that is wrong with it.
pub(super) fn read(table: Option<Table>) -> Option<Stated> {
    let Some(table) = table else {
        return Some(Stated {
            table: None,
            position: None,
            orientation: Rotation::identity(),
            velocity: None,
            spin: Spin::Velocity(Vector3::zeros()),
            key_of_spin: SPINS[0],
        });
    };
    let document = table.document();
    let one_spin = document.keep(table.one_of(&SPINS));
    let vector = |key| document.keep(table.optional_vector(key));
    let (position, velocity) = (vector("position"), vector("velocity"));
    let orientation = table.get("orientation").map(|value| read_orientation(&value)).transpose();
    let orientation = document.keep(orientation).map(|given| given.unwrap_or_else(Rotation::identity));
    let [world, body, momentum] = SPINS.map(vector);
    one_spin?;
    let orientation = orientation?;
    let (spin, key_of_spin) = match (world?, body?, momentum?) {
        (_, _, Some(momentum)) => (Spin::Momentum(momentum), SPINS[2]),
        (_, Some(spin), None) => (Spin::Velocity(orientation * spin), SPINS[1]),
        (spin, None, None) => (Spin::Velocity(spin.unwrap_or_default()), SPINS[0]),
    };
    let (position, velocity) = (position?, velocity?);
    Some(Stated { table: Some(table), position, orientation, velocity, spin, key_of_spin })
}

/// Puts the body under its laws from its start, and notes what contradicts the body. `entries` are the tables of the laws.
pub(super) fn system(
    given: Given,
    stated: &Stated,
    laws: Vec<Law>,
    entries: &[Value],
    whole: &Table,
) -> Option<System> {
    let document = whole.document();
    let get = |key| stated.table.as_ref().and_then(|table| table.get(key));
    let place = get(stated.key_of_spin);
    if let (Some(place), Spin::Velocity(spin)) = (&place, &stated.spin) {
        document.keep(check_spin(place, &given.body, stated, spin));
    }
    for error in system_faults(&given.body, &laws) {
        document.note(located(&error, entries, place.as_ref(), whole));
    }
    if !document.is_sound() {
        return None;
    }
    let position = stated.position.unwrap_or(given.center);
    let velocity = stated.velocity.unwrap_or_default();
    let system = System::new(given.body, laws, position, stated.orientation, velocity, stated.spin)
        .map_err(|error| located(&error, entries, place.as_ref(), whole));
    let system = document.keep(system)?;
    if let Some(table) = &stated.table {
        document.keep(check_velocity(table, &system, &velocity));
    }
    document.keep(check_range(&system, place.as_ref(), whole))?;
    Some(system)
}

fn read_orientation(value: &Value) -> Result<Rotation, Fault> {
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
    let message = format!("a quaternion of length {norm:?} is no orientation, which needs length 1 to 1e-9");
    Err(value.refuse(message).advised(format!("write orientation = {instead}")).replaced(instead))
}

/// Three angles, and the axes that they are about.
fn read_euler(table: &Table) -> Result<Rotation, Fault> {
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
fn check_spin(place: &Value, body: &Body, stated: &Stated, spin: &Vector3<f64>) -> Result<(), Fault> {
    let length = rotation::length(spin);
    match body.shape {
        Shape::Point if length != 0.0 => {
            let message = "the body is a single point, which cannot spin: remove this line";
            Err(unwanted(stated.table.as_ref(), stated.key_of_spin, message, place))
        }
        Shape::Rod { direction } => {
            let direction = stated.orientation * direction;
            let along = direction.dot(spin);
            if along.abs() <= TOLERANCE * length {
                return Ok(());
            }
            let across = spin - direction * along;
            let in_body = stated.key_of_spin == SPINS[1];
            let across = if in_body { stated.orientation.inverse_transform_vector(&across) } else { across };
            let instead = wording::list(across.as_slice());
            let message = format!(
                "the body is a rod and cannot spin about its own line, as {along:?} rad/s of this would"
            );
            let advice = format!("write {} = {instead}", stated.key_of_spin);
            Err(place.refuse(message).advised(advice).replaced(instead))
        }
        _ => Ok(()),
    }
}

/// Says that an entry of the start should not be there.
fn unwanted(table: Option<&Table>, key: &str, message: &str, place: &Value) -> Fault {
    table.and_then(|table| table.unwanted(key, message)).unwrap_or_else(|| place.refuse(message))
}

/// Refuses a velocity that the pivot contradicts.
fn check_velocity(table: &Table, system: &System, given: &Vector3<f64>) -> Result<(), Fault> {
    let actual = system.start.velocity;
    let apart = rotation::length(&(given - actual));
    let size = rotation::length(given);
    if !system.body.pivoted || size == 0.0 || apart <= TOLERANCE * size {
        return Ok(());
    }
    let message = format!(
        "the pivot and the spin give the centre of mass the velocity {}: remove this line",
        wording::list(actual.as_slice())
    );
    table.unwanted("velocity", message).map_or(Ok(()), Err)
}

/// Refuses a start whose products leave the range of f64.
fn check_range(system: &System, place: Option<&Value>, whole: &Table) -> Result<(), Fault> {
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

/// Puts line, key and a text to what the system says of itself.
fn located(error: &SystemError, entries: &[Value], spin: Option<&Value>, whole: &Table) -> Fault {
    let in_law = |index: usize, key: &str| entries.get(index).and_then(|entry| entry.member(key));
    let at = |place: Option<Value>| match place {
        Some(place) => place.refuse(error.to_string()),
        None => whole.refuse("body", error.to_string()),
    };
    match error {
        SystemError::AlongRod { .. } | SystemError::PointMomentum { .. } => at(spin.cloned()),
        SystemError::TorqueAlongRod { index, .. } => {
            at(in_law(*index, "at").or_else(|| in_law(*index, "law")))
        }
        SystemError::NoPoints { index, .. } => {
            at(in_law(*index, "law")).advised("remove the law or give the body as points")
        }
        SystemError::ListLength { index, points, .. } => {
            let parameters = Law::ALL.iter().flat_map(|law| law.parameters);
            let mut lists = parameters.filter(|parameter| parameter.kind == Kind::PerPoint);
            let place = lists.find_map(|parameter| in_law(*index, parameter.key));
            let instead = place.as_ref().and_then(Value::first_item).unwrap_or_else(|| "1.0".to_owned());
            at(place).advised(format!("write {points} values, or one number for all")).replaced(instead)
        }
        SystemError::PointIndex { index, points: 0, .. } => {
            at(in_law(*index, "point")).advised("write at = [x, y, z] instead")
        }
        SystemError::PointIndex { index, points, .. } => {
            at(in_law(*index, "point")).advised(format!("write point = 0 to {}", points - 1)).replaced("0")
        }
        SystemError::NoPointForm | SystemError::Range { .. } => at(None),
    }
}
