//! Scenes in and out: the body of a scene file, and a scene for a body of a robot.

use std::fmt::Write;

use nalgebra::Matrix3;
use toml::de::{DeTable, DeValue};

use super::InspectError;
use super::link::{Inertial, Link, Robot, Source};
use super::pose::Pose;
use super::printed::Printed;
use crate::scenes::{Scene, SceneError};

/// Start of a written scene [rad/s]: about no principal axis unless by chance, half a turn a second.
const SPIN: [f64; 3] = [1.0, 2.0, 3.0];
/// Length of a written scene [s].
const DURATION: f64 = 10.0;

/// The body of a scene file. An inertia is read as printed, so that an impossible one is judged rather than refused.
pub(super) fn read(text: &str, file: &str) -> Result<Robot, InspectError> {
    let printed = printed_inertia(text);
    let scene = match Scene::parse(text, file) {
        Ok(scene) => Some(scene),
        Err(error) if printed.is_none() => return Err(error.into()),
        Err(SceneError::Content { faults, .. })
            if faults.iter().all(|f| f.key.starts_with("body.inertia") || f.key.starts_with("body.mass")) =>
        {
            None
        }
        Err(error) => return Err(error.into()),
    };
    let inertial = match (printed, &scene) {
        (Some(inertial), _) => Some(inertial),
        (None, Some(scene)) => {
            let body = &scene.system.body;
            let away = crate::model::body::second_moment_inertia(&body.center) * body.mass;
            Some(Inertial::computed(body.mass, body.center, &(body.inertia - away)))
        }
        (None, None) => None,
    };
    let name = scene.map_or_else(|| "body".to_owned(), |scene| scene.name);
    let link = Link { name, line: 1, source: Source::Explicit, inertial, inertials: 1, ..Link::default() };
    Ok(Robot { format: "scene", links: vec![link], ..Robot::default() })
}

/// Mass and inertia of the table `[body]`, with their printed digits; `None` where there is no inertia or it is no list of numbers.
fn printed_inertia(text: &str) -> Option<Inertial> {
    let root = DeTable::parse(text).ok()?;
    let body = root.get_ref().get("body")?.get_ref().as_table()?;
    let number = |value: &DeValue| match value {
        DeValue::Integer(integer) => Printed::parse(integer.as_str()),
        DeValue::Float(float) => Printed::parse(float.as_str()),
        _ => None,
    };
    let mass = number(body.get("mass")?.get_ref())?;
    let rows = body.get("inertia")?.get_ref().as_array()?;
    let list: Option<Vec<Printed>> = rows.iter().map(|item| number(item.get_ref())).collect();
    let zero = Printed::default;
    let six = if let Some(moments) = list {
        let [xx, yy, zz] = <[Printed; 3]>::try_from(moments).ok()?;
        [xx, zero(), zero(), yy, zero(), zz]
    } else {
        let matrix: Option<Vec<Vec<Printed>>> = rows
            .iter()
            .map(|row| row.get_ref().as_array()?.iter().map(|item| number(item.get_ref())).collect())
            .collect();
        let flat: Vec<Printed> = matrix?.into_iter().flatten().collect();
        let nine = <[Printed; 9]>::try_from(flat).ok()?;
        // An asymmetric one is the scene's own fault.
        if [(1, 3), (2, 6), (5, 7)].iter().any(|(a, b)| nine[*a].value != nine[*b].value) {
            return None;
        }
        let [xx, xy, xz, _, yy, yz, _, _, zz] = nine;
        [xx, xy, xz, yy, yz, zz]
    };
    Some(Inertial { mass, six, pose: Pose::default() })
}

/// A scene of a free body; `why` says where it comes from.
pub(super) fn text(name: &str, why: &str, mass: f64, tensor: &Matrix3<f64>) -> String {
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let mut scene = format!(
        "name = {}\nwhy = {}\nduration = {DURATION:?}\n\n[body]\nmass = {mass:?}\n",
        quoted(name),
        quoted(why)
    );
    let symmetric = (tensor + tensor.transpose()) * 0.5;
    let row =
        |i: usize| format!("[{:?}, {:?}, {:?}]", symmetric[(i, 0)], symmetric[(i, 1)], symmetric[(i, 2)]);
    // Writing to a String does not fail.
    let _ = write!(scene, "inertia = [{}, {}, {}]\n\n", row(0), row(1), row(2));
    let _ = write!(scene, "[initial]\nangular_velocity = {SPIN:?}\n");
    scene
}

/// A name in kebab-case of at most 80 letters, which leaves room for an ending.
pub(super) fn name_of(robot: &str, link: &str) -> String {
    let words: String = format!("{robot} {link}")
        .chars()
        .map(|letter| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { ' ' })
        .collect();
    let mut name = words.split_whitespace().collect::<Vec<_>>().join("-");
    name.truncate(80);
    let name = name.trim_end_matches('-');
    if name.is_empty() { "body".to_owned() } else { name.to_owned() }
}
