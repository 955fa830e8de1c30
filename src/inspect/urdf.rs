//! URDF: links with `<inertial>`, in the axes of the rpy of its origin.
//!
//! A link without `<inertial>` is a frame. Joints are left alone. Source: the URDF pages of the ROS wiki, urdfdom.

use super::element::{Element, Fault, finite, number};
use super::link::{Inertial, Link, Robot, SIX, Source};
use super::pose;
use super::printed::Printed;
use super::solid::{Shape, Solid};

pub(super) fn read(root: &Element) -> Result<Robot, Fault> {
    let links = root.all("link").map(link).collect::<Result<_, _>>()?;
    Ok(Robot { format: "urdf", links, ..Robot::default() })
}

fn link(element: &Element) -> Result<Link, Fault> {
    let name = element.attribute("name").ok_or_else(|| Fault::at(element, "has no name"))?;
    let mut link = Link { name: name.to_owned(), line: element.line, ..Link::default() };
    if let Some(given) = element.child("inertial") {
        link.inertial = Some(inertial(given)?);
        link.inertials = element.all("inertial").count();
        link.source = Source::Explicit;
    }
    for part in element.children.iter().filter(|part| ["collision", "visual"].contains(&part.name.as_str())) {
        let Some(solid) = solid(part)? else {
            link.meshes += usize::from(part.child("geometry").is_some());
            continue;
        };
        if part.name == "collision" { &mut link.solids } else { &mut link.drawn }.push(solid);
    }
    Ok(link)
}

fn inertial(element: &Element) -> Result<Inertial, Fault> {
    let missing =
        |name: &str| Fault::at(element, format!("has no <{name}>: write one, or leave <inertial> out"));
    let mass = element.child("mass").ok_or_else(|| missing("mass"))?;
    let value =
        mass.attribute("value").ok_or_else(|| Fault::at(mass, "has no value: write value=\"1.0\""))?;
    let tensor = element.child("inertia").ok_or_else(|| missing("inertia"))?;
    let mut six: [Printed; 6] = Default::default();
    for (place, name) in SIX.into_iter().enumerate() {
        // Old exports write the numbers below the diagonal.
        let transposed: String = [0, 2, 1].iter().filter_map(|i| name.chars().nth(*i)).collect();
        let text = tensor.attribute(name).or_else(|| tensor.attribute(&transposed));
        let text = text.ok_or_else(|| Fault::at(tensor, format!("has no {name}: write all six numbers")))?;
        six[place] = number(tensor, text)?;
    }
    Ok(Inertial { mass: number(mass, value)?, six, pose: pose::urdf(element)? })
}

fn solid(part: &Element) -> Result<Option<Solid>, Fault> {
    let Some(geometry) = part.child("geometry").and_then(|geometry| geometry.children.first()) else {
        return Ok(None);
    };
    let of = |name: &str| {
        let text = geometry.attribute(name);
        text.ok_or_else(|| Fault::at(geometry, format!("has no {name}")))
            .and_then(|text| finite::<1>(geometry, text))
            .map(|[value]| value)
    };
    let shape = match geometry.name.as_str() {
        "box" => {
            let text = geometry.attribute("size").ok_or_else(|| Fault::at(geometry, "has no size"))?;
            Shape::Box(nalgebra::Vector3::from(finite::<3>(geometry, text)?) / 2.0)
        }
        "sphere" => Shape::sphere(of("radius")?),
        "cylinder" => Shape::Cylinder(of("radius")?, of("length")? / 2.0),
        "capsule" => Shape::Capsule(of("radius")?, of("length")? / 2.0),
        _ => return Ok(None),
    };
    Ok(Some(Solid { shape, pose: pose::urdf(part)?, density: None }))
}
