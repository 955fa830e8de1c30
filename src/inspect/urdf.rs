//! URDF: links with `<inertial>`, in the axes of the rpy of its origin.
//!
//! A link without `<inertial>` is a frame. Joints are left alone. Source: the URDF pages of the ROS wiki, urdfdom.

use super::element::{Element, Fault, Faults, finite, number};
use super::link::{Inertial, Link, Robot, SIX, Source};
use super::pose;
use super::printed::Printed;
use super::solid::{Shape, Solid};

pub(super) fn read(root: &Element) -> Result<Robot, Faults> {
    let mut faults = Faults::default();
    let links = root.all("link").filter_map(|element| faults.keep(link(element))).collect();
    faults.or(Some(Robot { format: "urdf", links, ..Robot::default() }))
}

fn link(element: &Element) -> Result<Link, Faults> {
    let mut faults = Faults::default();
    let name = faults.keep(element.attribute("name").ok_or_else(|| Fault::at(element, "has no name")));
    let name = name.unwrap_or_default().to_owned();
    let mut link = Link { name, line: element.line, ..Link::default() };
    if let Some(given) = element.child("inertial") {
        link.inertial = faults.keep(inertial(given));
        link.inertials = element.all("inertial").count();
        link.source = Source::Explicit;
    }
    for part in element.children.iter().filter(|part| ["collision", "visual"].contains(&part.name.as_str())) {
        match faults.keep(solid(part)) {
            Some(Some(solid)) if part.name == "collision" => link.solids.push(solid),
            Some(Some(solid)) => link.drawn.push(solid),
            _ => link.meshes += usize::from(part.child("geometry").is_some()),
        }
    }
    faults.or(Some(link))
}

fn inertial(element: &Element) -> Result<Inertial, Faults> {
    let mut faults = Faults::default();
    let mass = faults.keep(mass(element));
    let six = faults.keep(six(element));
    let pose = faults.keep(pose::urdf(element));
    let all = mass.zip(six).zip(pose);
    faults.or(all.map(|((mass, six), pose)| Inertial { mass, six, pose }))
}

fn missing(element: &Element, name: &str) -> Fault {
    Fault::at(element, format!("has no <{name}>: write one, or leave <inertial> out"))
}

fn mass(element: &Element) -> Result<Printed, Fault> {
    let mass = element.child("mass").ok_or_else(|| missing(element, "mass"))?;
    let value =
        mass.attribute("value").ok_or_else(|| Fault::at(mass, "has no value: write value=\"1.0\""))?;
    number(mass, value)
}

fn six(element: &Element) -> Result<[Printed; 6], Faults> {
    let tensor = element.child("inertia").ok_or_else(|| missing(element, "inertia"))?;
    let (mut six, mut faults): ([Printed; 6], Faults) = Default::default();
    for (place, name) in SIX.into_iter().enumerate() {
        // Old exports write the numbers below the diagonal.
        let transposed: String = [0, 2, 1].iter().filter_map(|i| name.chars().nth(*i)).collect();
        let text = tensor.attribute(name).or_else(|| tensor.attribute(&transposed));
        let text = text.ok_or_else(|| Fault::at(tensor, format!("has no {name}: write all six numbers")));
        let read = text.and_then(|text| number(tensor, text));
        six[place] = faults.keep(read).unwrap_or_default();
    }
    faults.or(Some(six))
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
