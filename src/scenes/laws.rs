//! The tables `[[forces]]` of a scene file: one function a law.

use nalgebra::Vector3;

use super::SceneError;
use super::value::Value;
use super::wording;
use crate::model::forces::{
    Attachment, CentralGravity, Dipole, Drag, Gravity, GravityGradient, Ground, Law, Lorentz, Spring, Torque,
    TorqueAxes,
};

/// Reads one law. `origin` is the origin of the body in the frame of its points [m].
pub(super) fn read(entry: &Value, origin: &Vector3<f64>) -> Result<Law, SceneError> {
    let Some(name) = entry.member("law") else { return Err(entry.lacks("law")) };
    Ok(match name.text()? {
        "gravity" => Law::Gravity(gravity(entry)?),
        "spring" => Law::Spring(spring(entry, origin)?),
        "drag" => Law::Drag(drag(entry)?),
        "central-gravity" => Law::CentralGravity(central_gravity(entry)?),
        "lorentz" => Law::Lorentz(lorentz(entry)?),
        "torque" => Law::Torque(torque(entry)?),
        "dipole" => Law::Dipole(dipole(entry)?),
        "gravity-gradient" => Law::GravityGradient(gravity_gradient(entry)?),
        "ground" => Law::Ground(ground(entry)?),
        other => return Err(unknown(&name, other)),
    })
}

fn unknown(name: &Value, given: &str) -> SceneError {
    let known = || Law::NAMES.iter().map(|(name, _)| *name);
    let meant = wording::nearest(given, known());
    let meant = meant.first().map_or(String::new(), |near| format!("did you mean {near}? "));
    name.refuse(format!("no such law: {meant}the laws are {}", known().collect::<Vec<_>>().join(", ")))
}

fn gravity(entry: &Value) -> Result<Gravity, SceneError> {
    let table = entry.table(&["law", "acceleration"])?;
    Ok(Gravity { acceleration: table.vector("acceleration")? })
}

fn spring(entry: &Value, origin: &Vector3<f64>) -> Result<Spring, SceneError> {
    let table = entry.table(&["law", "point", "at", "anchor", "stiffness", "damping", "rest_length"])?;
    table.not_both("point", "at")?;
    let attachment = match (table.get("point"), table.get("at")) {
        (Some(point), _) => Attachment::Point(point.index()?),
        (None, Some(at)) => Attachment::At(at.vector()? - origin),
        (None, None) => {
            let message = "is missing: write point = 0 for a mass point, or at = [x, y, z] for any place";
            return Err(table.refuse("point", message));
        }
    };
    Ok(Spring {
        attachment,
        anchor: table.vector_or_zero("anchor")?,
        stiffness: table.number("stiffness")?,
        damping: table.number_or("damping", 0.0)?,
        rest_length: table.number_or("rest_length", 0.0)?,
    })
}

fn drag(entry: &Value) -> Result<Drag, SceneError> {
    let table = entry.table(&["law", "coefficient"])?;
    Ok(Drag { coefficient: table.required("coefficient")?.per_point()? })
}

fn central_gravity(entry: &Value) -> Result<CentralGravity, SceneError> {
    let table = entry.table(&["law", "mu", "center"])?;
    Ok(CentralGravity { mu: table.number("mu")?, center: table.vector_or_zero("center")? })
}

fn lorentz(entry: &Value) -> Result<Lorentz, SceneError> {
    let table = entry.table(&[
        "law",
        "charge",
        "electric",
        "electric_cosine",
        "electric_sine",
        "frequency",
        "magnetic",
    ])?;
    Ok(Lorentz {
        charge: table.required("charge")?.per_point()?,
        electric: table.vector_or_zero("electric")?,
        electric_cosine: table.vector_or_zero("electric_cosine")?,
        electric_sine: table.vector_or_zero("electric_sine")?,
        frequency: table.number_or("frequency", 0.0)?,
        magnetic: table.vector_or_zero("magnetic")?,
    })
}

fn torque(entry: &Value) -> Result<Torque, SceneError> {
    let table = entry.table(&["law", "axes", "constant", "cosine", "sine", "frequency"])?;
    let axes = table.required("axes")?;
    Ok(Torque {
        axes: match axes.text()? {
            "world" => TorqueAxes::World,
            "body" => TorqueAxes::Body,
            _ => return Err(axes.expected("\"world\" or \"body\"")),
        },
        constant: table.vector_or_zero("constant")?,
        cosine: table.vector_or_zero("cosine")?,
        sine: table.vector_or_zero("sine")?,
        frequency: table.number_or("frequency", 0.0)?,
    })
}

fn dipole(entry: &Value) -> Result<Dipole, SceneError> {
    let table = entry.table(&["law", "moment", "field"])?;
    Ok(Dipole { moment: table.vector("moment")?, field: table.vector("field")? })
}

fn gravity_gradient(entry: &Value) -> Result<GravityGradient, SceneError> {
    let table = entry.table(&["law", "mu_over_r3", "direction", "normal", "rate"])?;
    Ok(GravityGradient {
        mu_over_r3: table.number("mu_over_r3")?,
        direction: table.required("direction")?.direction()?,
        normal: table.direction_or_z("normal")?,
        rate: table.number_or("rate", 0.0)?,
    })
}

fn ground(entry: &Value) -> Result<Ground, SceneError> {
    let table =
        entry.table(&["law", "normal", "height", "stiffness", "damping", "friction", "slip_velocity"])?;
    let friction = table.number_or("friction", 0.0)?;
    let slip_velocity = table.number_or("slip_velocity", 1e-3)?;
    if let Some(value) = table.get("slip_velocity")
        && friction != 0.0
        && slip_velocity <= 0.0
    {
        return Err(value.expected("a velocity above zero where there is friction"));
    }
    Ok(Ground {
        normal: table.direction_or_z("normal")?,
        height: table.number_or("height", 0.0)?,
        stiffness: table.number("stiffness")?,
        damping: table.number_or("damping", 0.0)?,
        friction,
        slip_velocity,
    })
}
