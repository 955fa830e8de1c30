//! MJCF: bodies with `<inertial>`, or with geoms that have mass.
//!
//! Joints, sites and actuators are left alone. Settings of `<compiler>` and classes of `<default>` count as far as a body's mass does.
//! Source: the XML reference of MuJoCo, and values of MuJoCo 4.0.0.

mod classes;
mod geom;
mod hull;
mod include;
mod settings;

use std::path::Path;

use nalgebra::{Matrix3, Vector3};

use super::element::{Element, Fault, Faults, finite, number, printed};
use super::link::{Inertial, Link, Robot, Source, six_of};
use super::pose::Pose;
use super::printed::Printed;
use super::solid::{Part, compose};
use super::verdict::principal;
use classes::Classes;
use geom::Geom;
use hull::Hulls;
use settings::{FromGeom, Settings};

pub(super) fn read(root: &mut Element, path: &Path) -> Result<Robot, Faults> {
    let notes = include::resolve(root, path)?;
    let mut faults = Faults::default();
    let settings = Settings::read(root, &mut faults);
    let classes = Classes::read(root);
    let hulls = hull::all(root, &classes, &mut faults);
    let stepping = faults.keep(settings::stepping(root));
    let mut reader = Reader { classes, settings, hulls, links: Vec::new(), faults };
    for world in root.all("worldbody") {
        reader.children(world, None, &mut Holder::default());
    }
    let mut links = reader.links;
    settings::compile(&reader.settings, &mut links);
    reader.faults.or(Some(Robot { format: "mjcf", links, stepping, notes }))
}

struct Reader {
    classes: Classes,
    settings: Settings,
    hulls: Hulls,
    links: Vec<Link>,
    faults: Faults,
}

/// What stands in a body, its frames included.
#[derive(Default)]
struct Holder {
    geoms: Vec<Geom>,
    frame: Pose,
}

impl Reader {
    fn children(&mut self, element: &Element, class: Option<&str>, holder: &mut Holder) {
        for child in &element.children {
            let inner = child.attribute("childclass").or(class);
            match child.name.as_str() {
                "geom" => {
                    let given = self.classes.of("geom", child, class);
                    let read = geom::read(child, &given, &self.settings, &holder.frame, &self.hulls);
                    holder.geoms.extend(self.faults.keep(read));
                }
                "frame" => {
                    let outer = holder.frame;
                    let attributes = child.attributes().collect();
                    let placed = self.faults.keep(geom::placed(child, &attributes, &self.settings));
                    holder.frame = outer.then(&placed.unwrap_or_default());
                    self.children(child, inner, holder);
                    holder.frame = outer;
                }
                "body" => self.body(child, inner),
                "replicate" | "attach" | "composite" | "flexcomp" => {
                    let why = "is not read: save the compiled model (mj_saveLastXML) and inspect that";
                    self.faults.keep(Err::<(), _>(Fault::at(child, why)));
                }
                _ => {}
            }
        }
    }

    fn body(&mut self, element: &Element, class: Option<&str>) {
        let place = self.links.len();
        let name = element.attribute("name").map_or_else(|| format!("(body {place})"), ToOwned::to_owned);
        self.links.push(Link { name, line: element.line, ..Link::default() });
        let mut holder = Holder::default();
        self.children(element, class, &mut holder);
        let mut link = Link { ..self.links[place].clone() };
        link.inertials = element.all("inertial").count();
        if link.inertials > 1 {
            self.faults.keep(Err::<(), _>(Fault::at(element, "has two <inertial>: remove one")));
        }
        let given = element.child("inertial");
        if let Some(given) = given
            && self.settings.from_geom != FromGeom::Always
        {
            link.inertial = self.faults.keep(inertial(given, &self.settings));
            link.source = Source::Explicit;
        } else if self.settings.from_geom != FromGeom::Never {
            self.by_geoms(&holder.geoms, &mut link);
        }
        if given.is_some() && self.settings.from_geom == FromGeom::Always {
            link.notes.push("inertiafromgeom=\"true\": <inertial> is not read".to_owned());
        }
        link.meshes = holder.geoms.iter().filter(|geom| geom.mesh).count();
        // The size of a hull is not kept, so that no outline speaks of such a body.
        if holder.geoms.iter().all(|geom| geom.hull.is_none()) {
            link.solids = holder.geoms.into_iter().filter_map(|geom| geom.solid).collect();
        }
        self.links[place] = link;
    }

    fn by_geoms(&self, geoms: &[Geom], link: &mut Link) {
        let counted = || geoms.iter().filter(|geom| self.settings.groups.contains(&geom.group));
        if counted().any(|geom| geom.mesh && geom.hull.is_none() && geom.mass != Some(0.0)) {
            link.notes.push("its mass comes from a mesh, which is not read".to_owned());
            return;
        }
        let parts: Vec<Part> = counted().filter_map(Geom::part).collect();
        let (mass, center, tensor) = compose(&parts);
        if mass > 0.0 {
            link.inertial = Some(Inertial::computed(mass, center, &tensor));
            link.source = Source::Geoms;
        }
    }
}

/// `<inertial>`: fullinertia is M11 M22 M33 M12 M13 M23, in the axes of the body.
fn inertial(element: &Element, settings: &Settings) -> Result<Inertial, Faults> {
    let mut faults = Faults::default();
    faults.keep(one_form(element));
    let mass = element.attribute("mass").ok_or_else(|| Fault::at(element, "has no mass: write mass=\"1.0\""));
    let mass = faults.keep(mass.and_then(|mass| number(element, mass)));
    let attributes = element.attributes().collect();
    let pose = faults.keep(geom::placed(element, &attributes, settings));
    let six = faults.keep(six(element));
    let all = mass.zip(six).zip(pose);
    faults.or(all.map(|((mass, six), pose)| Inertial { mass, six, pose }))
}

/// Of several ways to say one thing MuJoCo takes one alone.
fn one_form(element: &Element) -> Result<(), Fault> {
    let turns = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];
    let turned: Vec<&str> = turns.into_iter().filter(|name| element.attribute(name).is_some()).collect();
    let full = element.attribute("fullinertia");
    if let Some(turn) = turned.first()
        && (full.is_some() || turned.len() > 1)
    {
        let other = if full.is_some() { "fullinertia" } else { turned[1] };
        return Err(Fault::at(
            element,
            format!("{turn} stands beside {other}, of which MuJoCo takes one: remove one"),
        ));
    }
    if full.is_some() && element.attribute("diaginertia").is_some() {
        return Err(Fault::at(
            element,
            "diaginertia stands beside fullinertia, of which MuJoCo takes one: remove one",
        ));
    }
    Ok(())
}

fn six(element: &Element) -> Result<[Printed; 6], Fault> {
    Ok(match (element.attribute("fullinertia"), element.attribute("diaginertia")) {
        (Some(text), _) => {
            let [xx, yy, zz, xy, xz, yz] = numbers(element, "fullinertia", text)?;
            [xx, xy, xz, yy, yz, zz]
        }
        (None, Some(text)) => {
            let [xx, yy, zz] = numbers(element, "diaginertia", text)?;
            [xx, Printed::default(), Printed::default(), yy, Printed::default(), zz]
        }
        (None, None) => six_of(&Matrix3::zeros()).map(Printed::computed),
    })
}

fn numbers<const N: usize>(element: &Element, key: &str, text: &str) -> Result<[Printed; N], Fault> {
    let found = printed(element, text)?;
    let count = found.len();
    <[Printed; N]>::try_from(found)
        .map_err(|_| Fault::at(element, format!("{key} has {count} numbers, expected {N}")))
}

/// Principal moments, ascending.
fn moments(link: &Link) -> Option<(f64, Vector3<f64>)> {
    let inertial = link.inertial.as_ref()?;
    Some((inertial.mass.value, principal(&inertial.tensor()).0))
}

/// Three numbers, or what stands before.
fn vector(element: &Element, text: Option<&str>) -> Result<Vector3<f64>, Fault> {
    text.map_or(Ok(Vector3::zeros()), |text| finite::<3>(element, text).map(Vector3::from))
}
