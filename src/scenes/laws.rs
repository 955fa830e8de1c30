//! The tables `[[forces]]` of a scene file, read and written by the tables of the laws' parameters.

use nalgebra::Vector3;

use super::table::Table;
use super::value::Value;
use super::wording;
use crate::fault::Fault;
use crate::model::forces::{Argument, Attachment, Described, Kind, Law, Parameter};

/// Reads one law, and notes all that is wrong with it. `origin` is the origin of the body in the frame of its points [m].
pub(super) fn read(entry: &Value, origin: &Vector3<f64>) -> Option<Law> {
    let document = entry.document();
    let name = document.keep(entry.member("law").ok_or_else(|| entry.lacks("law")))?;
    let given = document.keep(name.text())?;
    let known = Law::ALL.into_iter().find(|law| law.name == given);
    let described = document.keep(known.ok_or_else(|| unknown(&name, given)))?;
    let table = document.keep(entry.table(&keys(&described)))?;
    let read = described.parameters.iter().map(|p| document.keep(argument(&table, p, origin)));
    let arguments: Vec<Option<Argument>> = read.collect();
    let mut arguments = arguments.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
    let law = Law::build(given, |_| arguments.next().ok_or(())).and_then(Result::ok)?;
    if let Some((key, expected)) = law.contradiction()
        && let Some(value) = table.get(key)
    {
        document.note(value.expected(expected));
        return None;
    }
    Some(law)
}

/// The table of a law, to paste into a scene: an example of every parameter, with its unit, what it is and its default.
pub fn block(law: &Described) -> String {
    let mut text = format!("# {}\n# {}\n[[forces]]\nlaw = \"{}\"\n", law.formula, law.source, law.name);
    let lines: Vec<(String, &Parameter)> =
        law.parameters.iter().map(|p| (format!("{} = {}", p.key_of(&p.example), p.example), p)).collect();
    let width = lines.iter().map(|(line, _)| line.len()).max().unwrap_or_default();
    for (line, parameter) in &lines {
        let given = match (&parameter.default, parameter.kind) {
            (Some(default), _) => format!("; default {default}"),
            (None, Kind::Attachment) => "; or at = [x, y, z]".to_owned(),
            (None, Kind::PerPoint) => "; one for all points, or a list of one each".to_owned(),
            (None, _) => String::new(),
        };
        text += &format!("{line:width$}  # {} [{}]{given}\n", parameter.what, parameter.unit);
    }
    text
}

/// The keys that the table of a law may have.
fn keys(law: &Described) -> Vec<&'static str> {
    std::iter::once("law").chain(law.parameters.iter().flat_map(|p| p.keys().iter().copied())).collect()
}

fn unknown(name: &Value, given: &str) -> Fault {
    let known = || Law::ALL.iter().map(|law| law.name);
    let near = wording::nearest(given, known()).first().copied();
    let meant = near.map_or(String::new(), |near| format!("did you mean {near}? "));
    let laws = known().collect::<Vec<_>>().join(", ");
    let fault =
        name.refuse(format!("no such law as \"{}\": {meant}the laws are {laws}", wording::shortened(given)));
    match near {
        Some(near) => fault.replaced(format!("\"{near}\"")),
        None => fault,
    }
}

fn argument(table: &Table, parameter: &Parameter, origin: &Vector3<f64>) -> Result<Argument, Fault> {
    if parameter.kind == Kind::Attachment {
        return attachment(table, origin).map(Argument::Attachment);
    }
    let Some(value) = table.get(parameter.key) else {
        return match &parameter.default {
            Some(default) => Ok(default.clone()),
            None => Err(table.missing(parameter.key, &format!("{} = {}", parameter.key, parameter.example))),
        };
    };
    Ok(match parameter.kind {
        Kind::Vector if parameter.is_direction() => Argument::Vector(value.direction()?),
        Kind::Vector => Argument::Vector(value.vector()?),
        Kind::Matrix => Argument::Matrix(value.matrix("three numbers, or three rows of three numbers")?),
        Kind::PerPoint => Argument::PerPoint(value.per_point()?),
        Kind::Axes => Argument::Axes(value.axes()?),
        Kind::Number | Kind::Attachment => Argument::Number(value.number()?),
    })
}

fn attachment(table: &Table, origin: &Vector3<f64>) -> Result<Attachment, Fault> {
    let [point, at] = Parameter::PLACES;
    table.not_both(point, at)?;
    match (table.get(point), table.get(at)) {
        (Some(point), _) => Ok(Attachment::Point(point.index()?)),
        (None, Some(at)) => Ok(Attachment::At(at.vector()? - origin)),
        (None, None) => {
            let fault = table.missing(point, "point = 0");
            Err(fault.advised("write point = 0 for a mass point, or at = [x, y, z] for any place"))
        }
    }
}
