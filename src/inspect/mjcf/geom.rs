//! A geom: its shape, its place and its mass.

use nalgebra::{Matrix3, Vector3};

use super::classes::Attributes;
use super::hull::{Hull, Hulls};
use super::settings::Settings;
use super::vector;
use crate::inspect::element::{Element, Fault, finite};
use crate::inspect::pose::{self, Pose};
use crate::inspect::solid::{Part, Shape, Solid};
use crate::rotation::{self, Rotation};

/// Density where no class gives one [kg/m³].
const WATER: f64 = 1000.0;

/// A geom of a body.
pub(super) struct Geom {
    /// `None` for a mesh and for a plane.
    pub solid: Option<Solid>,
    /// Whether its size is not in the file.
    pub mesh: bool,
    /// What a mesh without faces fills, in the axes of the body.
    pub hull: Option<Hull>,
    /// [kg] where it is given; it beats the density.
    pub mass: Option<f64>,
    /// [kg/m³].
    pub density: f64,
    pub group: i64,
}

impl Geom {
    /// Its matter: the mass beats the density.
    pub fn part(&self) -> Option<Part> {
        let of = |volume: f64| self.mass.unwrap_or(self.density * volume);
        match (&self.solid, &self.hull) {
            (Some(solid), _) => Some(solid.of_mass(of(solid.shape.volume()))),
            (None, Some(hull)) => {
                Some(Part { mass: of(hull.volume), center: hull.center, tensor: hull.tensor })
            }
            (None, None) => None,
        }
    }
}

pub(super) fn read(
    element: &Element,
    given: &Attributes,
    settings: &Settings,
    frame: &Pose,
    hulls: &Hulls,
) -> Result<Geom, Fault> {
    let one =
        |key: &str| given.get(key).map(|text| finite::<1>(element, text).map(|[value]| value)).transpose();
    let kind = given.get("type").copied().unwrap_or("sphere");
    let fitted = given.contains_key("mesh");
    let mesh = fitted || ["mesh", "hfield", "sdf"].contains(&kind);
    let solid = if mesh || kind == "plane" { None } else { Some(solid(element, given, settings, kind)?) };
    let named = if kind == "mesh" { given.get("mesh").and_then(|name| hulls.get(*name)) } else { None };
    let hull = match named {
        Some(hull) => Some(hull.placed(&frame.then(&placed(element, given, settings)?))),
        None => None,
    };
    Ok(Geom {
        solid: solid.map(|solid| Solid { pose: frame.then(&solid.pose), ..solid }),
        mesh,
        hull,
        mass: one("mass")?,
        density: one("density")?.unwrap_or(WATER),
        group: given.get("group").and_then(|text| text.parse().ok()).unwrap_or(0),
    })
}

fn solid(element: &Element, given: &Attributes, settings: &Settings, kind: &str) -> Result<Solid, Fault> {
    let text = given.get("size").copied().unwrap_or_default();
    let sizes: Vec<f64> =
        crate::inspect::element::printed(element, text)?.into_iter().map(|number| number.value).collect();
    let size = |place: usize| {
        let value = sizes.get(place).copied().filter(|value| value.is_finite() && *value >= 0.0);
        value.ok_or_else(|| Fault::at(element, format!("size of this {kind} lacks number {}", place + 1)))
    };
    let ends = given.get("fromto").map(|text| finite::<6>(element, text)).transpose()?;
    let (pose, half) = match ends {
        Some([ax, ay, az, bx, by, bz]) => {
            let (from, to) = (Vector3::new(ax, ay, az), Vector3::new(bx, by, bz));
            let along = from - to;
            let pose = Pose::new((from + to) / 2.0, &pose::from_z(&along));
            (pose, Some(rotation::length(&along) / 2.0))
        }
        None => (placed(element, given, settings)?, None),
    };
    let half_length = |place: usize| half.map_or_else(|| size(place), Ok);
    let axes = || -> Result<Vector3<f64>, Fault> {
        let side = if half.is_some() { size(1).or_else(|_| size(0))? } else { size(1)? };
        Ok(Vector3::new(size(0)?, side, half_length(2)?))
    };
    let shape = match kind {
        "sphere" => Shape::sphere(size(0)?),
        "capsule" => Shape::Capsule(size(0)?, half_length(1)?),
        "cylinder" => Shape::Cylinder(size(0)?, half_length(1)?),
        "box" => Shape::Box(axes()?),
        "ellipsoid" => Shape::Ellipsoid(axes()?),
        other => return Err(Fault::at(element, format!("'{other}' is no type of a geom"))),
    };
    Ok(Solid { shape, pose, density: None })
}

/// pos and one of quat, axisangle, euler, xyaxes, zaxis.
pub(super) fn placed(element: &Element, given: &Attributes, settings: &Settings) -> Result<Pose, Fault> {
    let position = vector(element, given.get("pos").copied())?;
    let text = |key: &str| given.get(key).copied();
    if let Some(text) = text("xyaxes") {
        let [ax, ay, az, bx, by, bz] = finite::<6>(element, text)?;
        let (x, y) = (Vector3::new(ax, ay, az), Vector3::new(bx, by, bz));
        let x =
            x.try_normalize(0.0).ok_or_else(|| Fault::at(element, "xyaxes: the x axis has length zero"))?;
        let y = (y - x * x.dot(&y))
            .try_normalize(0.0)
            .ok_or_else(|| Fault::at(element, "xyaxes: the y axis is along the x axis"))?;
        return Ok(Pose { position, axes: Matrix3::from_columns(&[x, y, x.cross(&y)]) });
    }
    let rotation = if let Some(text) = text("quat") {
        pose::quaternion(element, finite::<4>(element, text)?)?
    } else if let Some(text) = text("axisangle") {
        let [x, y, z, angle] = finite::<4>(element, text)?;
        let axis = Vector3::new(x, y, z)
            .try_normalize(0.0)
            .ok_or_else(|| Fault::at(element, "axisangle: the axis has length zero"))?;
        rotation::turn(&(axis * settings.radians(angle)))
    } else if let Some(text) = text("euler") {
        euler(finite::<3>(element, text)?, settings)
    } else if let Some(text) = text("zaxis") {
        pose::from_z(&Vector3::from(finite::<3>(element, text)?))
    } else {
        Rotation::identity()
    };
    Ok(Pose::new(position, &rotation))
}

/// Turns in the order of eulerseq; about axes that turn along where its letter is small, about fixed ones where it is a capital.
fn euler(angles: [f64; 3], settings: &Settings) -> Rotation {
    let mut whole = Rotation::identity();
    for (angle, letter) in angles.into_iter().zip(settings.euler_sequence) {
        let axis = match letter.to_ascii_lowercase() {
            'x' => Vector3::x(),
            'y' => Vector3::y(),
            _ => Vector3::z(),
        };
        let turn = rotation::turn(&(axis * settings.radians(angle)));
        whole = if letter.is_ascii_lowercase() { whole * turn } else { turn * whole };
    }
    whole
}
