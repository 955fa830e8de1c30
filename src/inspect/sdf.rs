//! SDF: links of models, in worlds or not, nested or not.
//!
//! A missing mass is 1 kg, a missing moment 1 kg m². `auto="true"` takes collision shapes by density: that of the collision, else that
//! of the inertial, else 1000 kg/m³; a mass beside it scales all. Source: the specification at sdformat.org, versions 1.4 to 1.12.

use nalgebra::Vector3;

use super::Stepping;
use super::element::{Element, Fault, Faults, finite, number};
use super::link::{Inertial, Link, Robot, SIX, Source};
use super::pose;
use super::printed::Printed;
use super::solid::{Part, Shape, Solid, compose};

/// Density where the file gives none [kg/m³].
const WATER: f64 = 1000.0;
/// Step where `<physics>` gives none [s].
const STEP: f64 = 0.001;

pub(super) fn read(root: &Element) -> Result<Robot, Faults> {
    let mut faults = Faults::default();
    let mut robot = Robot { format: "sdf", ..Robot::default() };
    let holders = || std::iter::once(root).chain(root.all("world"));
    let models: Vec<&Element> = holders().flat_map(|holder| holder.all("model")).collect();
    let several = models.len() > 1;
    for model in models {
        let prefix = if several { model.attribute("name").map(|name| format!("{name}::")) } else { None };
        read_model(model, &prefix.unwrap_or_default(), false, (&mut robot, &mut faults));
    }
    let links: Vec<&Element> = holders().flat_map(|holder| holder.all("link")).collect();
    robot.links.extend(links.into_iter().filter_map(|element| faults.keep(link(element, "", false))));
    robot.stepping = faults.keep(stepping(root)).flatten();
    faults.or(Some(robot))
}

fn read_model(model: &Element, prefix: &str, fixed: bool, (robot, faults): (&mut Robot, &mut Faults)) {
    let fixed = fixed || model.child("static").is_some_and(|given| ["true", "1"].contains(&given.text()));
    robot.links.extend(model.all("link").filter_map(|element| faults.keep(link(element, prefix, fixed))));
    for inner in model.all("model") {
        let name = inner.attribute("name").unwrap_or("model");
        read_model(inner, &format!("{prefix}{name}::"), fixed, (&mut *robot, &mut *faults));
    }
    for include in model.all("include") {
        let uri = include.child("uri").map_or("", Element::text);
        robot.notes.push(format!(
            "line {}: <include> of '{uri}' is not followed: inspect that file itself",
            include.line
        ));
    }
}

fn link(element: &Element, prefix: &str, fixed: bool) -> Result<Link, Faults> {
    let mut faults = Faults::default();
    let name = faults.keep(element.attribute("name").ok_or_else(|| Fault::at(element, "has no name")));
    let name = name.unwrap_or_default();
    let mut link = Link { name: format!("{prefix}{name}"), line: element.line, ..Link::default() };
    for part in element.children.iter().filter(|part| ["collision", "visual"].contains(&part.name.as_str())) {
        match faults.keep(solid(part)) {
            Some(Form::Solid(solid)) if part.name == "collision" => link.solids.push(solid),
            Some(Form::Solid(solid)) => link.drawn.push(solid),
            Some(Form::Unknown) => link.meshes += 1,
            Some(Form::Unbounded) | None => {}
        }
    }
    match element.child("inertial") {
        None if fixed => link.notes.push("static model: it has no motion".to_owned()),
        None => {
            link.notes.push("no <inertial>: a simulator takes 1 kg and 1 kg m² about every axis".to_owned())
        }
        Some(given) => {
            link.inertials = element.all("inertial").count();
            let auto = ["true", "1"].contains(&given.attribute("auto").unwrap_or_default());
            let read = if auto {
                automatic(given, &mut link).map_err(Faults::from)
            } else {
                explicit(given, &mut link)
            };
            faults.keep(read);
        }
    }
    faults.or(Some(link))
}

fn explicit(given: &Element, link: &mut Link) -> Result<(), Faults> {
    let one = |element: Option<&Element>, default: &str| match element {
        Some(element) => number(element, element.text()),
        None => Printed::parse(default).ok_or_else(|| Fault::at(given, "")),
    };
    let mass = given.child("mass");
    let tensor = given.child("inertia");
    if mass.is_none() {
        link.notes.push("no <mass>: 1 kg is the default".to_owned());
    }
    if tensor.is_none() {
        link.notes.push("no <inertia>: 1 kg m² about every axis is the default".to_owned());
    }
    let (mut six, mut faults): ([Printed; 6], Faults) = Default::default();
    for (place, name) in SIX.into_iter().enumerate() {
        let default = if super::link::MOMENTS.contains(&place) { "1" } else { "0" };
        let read = one(tensor.and_then(|tensor| tensor.child(name)), default);
        six[place] = faults.keep(read).unwrap_or_default();
    }
    let mass = faults.keep(one(mass, "1"));
    let pose = faults.keep(pose::sdf(given));
    link.inertial = mass.zip(pose).map(|(mass, pose)| Inertial { mass, six, pose });
    link.source = Source::Explicit;
    faults.or(Some(()))
}

fn automatic(given: &Element, link: &mut Link) -> Result<(), Fault> {
    let density = given.child("density").map(|element| finite::<1>(element, element.text())).transpose()?;
    let density = density.map_or(WATER, |[value]| value);
    if link.meshes > 0 {
        link.notes.push("auto=\"true\" with meshes: their mass is not in the file".to_owned());
        return Ok(());
    }
    let own = |solid: &Solid| solid.of_mass(solid.density.unwrap_or(density) * solid.shape.volume());
    let parts: Vec<Part> = link.solids.iter().map(own).collect();
    let (mut mass, center, mut tensor) = compose(&parts);
    if let Some(wanted) = given.child("mass") {
        let [wanted] = finite::<1>(wanted, wanted.text())?;
        tensor *= wanted / mass;
        mass = wanted;
    }
    link.inertial = Some(Inertial::computed(mass, center, &tensor));
    link.source = Source::Auto;
    Ok(())
}

enum Form {
    Solid(Solid),
    /// A mesh or the like: its size is not in the file.
    Unknown,
    /// A plane, or nothing.
    Unbounded,
}

fn solid(part: &Element) -> Result<Form, Fault> {
    let Some(geometry) = part.child("geometry").and_then(|geometry| geometry.children.first()) else {
        return Ok(Form::Unbounded);
    };
    let of = |name: &str| {
        let child = inner(geometry, name)?;
        finite::<1>(child, child.text()).map(|[value]| value)
    };
    let three = |name: &str| {
        let child = inner(geometry, name)?;
        finite::<3>(child, child.text()).map(Vector3::from)
    };
    let shape = match geometry.name.as_str() {
        "box" => Shape::Box(three("size")? / 2.0),
        "sphere" => Shape::sphere(of("radius")?),
        "ellipsoid" => Shape::Ellipsoid(three("radii")?),
        "cylinder" => Shape::Cylinder(of("radius")?, of("length")? / 2.0),
        "capsule" => Shape::Capsule(of("radius")?, of("length")? / 2.0),
        "plane" | "empty" => return Ok(Form::Unbounded),
        _ => return Ok(Form::Unknown),
    };
    let density = part.child("density").map(|element| finite::<1>(element, element.text())).transpose()?;
    Ok(Form::Solid(Solid { shape, pose: pose::sdf(part)?, density: density.map(|[value]| value) }))
}

fn inner<'e>(element: &'e Element, name: &str) -> Result<&'e Element, Fault> {
    element.child(name).ok_or_else(|| Fault::at(element, format!("has no <{name}>")))
}

fn stepping(root: &Element) -> Result<Option<Stepping>, Fault> {
    let physics = root.all("world").flat_map(|world| world.all("physics")).next();
    let Some(physics) = physics else { return Ok(None) };
    let engine = physics.attribute("type").unwrap_or("ode");
    let step = physics.child("max_step_size");
    let value = step.map(|element| finite::<1>(element, element.text())).transpose()?;
    Ok(Some(Stepping {
        integrator: format!("the engine's own (<physics type=\"{engine}\">)"),
        step: value.map_or(STEP, |[value]| value),
        step_given: value.is_some(),
        scheme: match engine {
            // Both step velocities first, then places; the gyroscopic term is that of the old spin.
            "ode" | "dart" => Some("semi-implicit-euler-explicit-gyro"),
            "bullet" => Some("semi-implicit-euler-implicit-gyro"),
            _ => None,
        },
    }))
}
