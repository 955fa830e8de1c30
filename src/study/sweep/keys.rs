//! The numbers of a scene file by their keys, and the file with some of them changed.
//!
//! A key is a path: `body.mass`, `initial.angular_velocity.2`, `forces.0.stiffness`, lists counted from 0; `*` stands for every
//! item of a list, all of which get the same number. `body.scale` is a factor of every length of the body: points and pivot
//! by it, moments of inertia by its square.

use toml::{Table, Value};

use crate::model::forces::{Law, Parameter};

/// Factor of every length of the body.
const SCALE: &str = "body.scale";
/// A key that holds a whole number and not a quantity.
const INDEX: &str = Parameter::PLACES[0];

/// A scene file as it stands, open to changes.
#[derive(Clone, Debug)]
pub struct SceneText {
    table: Table,
}

impl SceneText {
    /// Opens the text of a scene file, with every default of its laws filled in; `None` where it is not TOML, which reading it as a scene tells better.
    pub fn open(text: &str) -> Option<SceneText> {
        let mut table: Table = text.parse().ok()?;
        if let Some(Value::Array(laws)) = table.get_mut("forces") {
            laws.iter_mut().filter_map(Value::as_table_mut).for_each(fill);
        }
        Some(SceneText { table })
    }

    /// The keys of every number in the file and of every parameter of its laws, and `body.scale`.
    pub fn keys(&self) -> Vec<String> {
        let mut keys = Vec::new();
        for (key, value) in &self.table {
            collect(key.clone(), value, &mut keys);
        }
        keys.push(SCALE.to_owned());
        keys
    }

    /// Whether a key names at least one number.
    pub fn has(&self, key: &str) -> bool {
        self.clone().set(key, 1.0)
    }

    /// Sets the numbers of a key; false where there is none.
    pub fn set(&mut self, key: &str, number: f64) -> bool {
        if key == SCALE {
            return self.scale(number);
        }
        let path: Vec<&str> = key.split('.').collect();
        let Some((first, rest)) = path.split_first() else { return false };
        self.table.get_mut(*first).is_some_and(|value| assign(value, rest, number))
    }

    /// The text of the file now.
    pub fn text(&self) -> String {
        self.table.to_string()
    }

    fn scale(&mut self, factor: f64) -> bool {
        let Some(Value::Table(body)) = self.table.get_mut("body") else { return false };
        if let Some(Value::Array(points)) = body.get_mut("points") {
            points.iter_mut().filter_map(|point| point.get_mut("position")).for_each(|p| multiply(p, factor));
        }
        for (key, power) in [("pivot", factor), ("inertia", factor * factor)] {
            if let Some(value) = body.get_mut(key) {
                multiply(value, power);
            }
        }
        true
    }
}

/// Gives a law the defaults of the parameters that its scene does not give.
fn fill(entry: &mut Table) {
    let name = entry.get("law").and_then(Value::as_str);
    let Some(law) = Law::ALL.iter().find(|law| Some(law.name) == name) else { return };
    for parameter in law.parameters {
        let line = parameter.default.as_ref().map(|default| format!("{} = {default}", parameter.key));
        for (key, value) in line.and_then(|line| line.parse::<Table>().ok()).into_iter().flatten() {
            entry.entry(key).or_insert(value);
        }
    }
}

fn collect(path: String, value: &Value, keys: &mut Vec<String>) {
    let is_index = path.rsplit('.').next() == Some(INDEX);
    match value {
        Value::Integer(_) | Value::Float(_) if !is_index => keys.push(path),
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(index, item)| collect(format!("{path}.{index}"), item, keys));
        }
        Value::Table(entries) => {
            entries.iter().for_each(|(key, entry)| collect(format!("{path}.{key}"), entry, keys));
        }
        _ => {}
    }
}

/// Puts the number wherever the path leads; false where that is nowhere.
fn assign(value: &mut Value, path: &[&str], number: f64) -> bool {
    let Some((first, rest)) = path.split_first() else {
        let is_number = matches!(value, Value::Integer(_) | Value::Float(_));
        if is_number {
            *value = Value::Float(number);
        }
        return is_number;
    };
    match value {
        Value::Array(items) if *first == "*" => {
            let mut any = false;
            for item in items {
                any |= assign(item, rest, number);
            }
            any
        }
        Value::Array(items) => first
            .parse::<usize>()
            .ok()
            .and_then(|index| items.get_mut(index))
            .is_some_and(|item| assign(item, rest, number)),
        Value::Table(_) if *first == INDEX => false,
        Value::Table(entries) => entries.get_mut(*first).is_some_and(|entry| assign(entry, rest, number)),
        _ => false,
    }
}

fn multiply(value: &mut Value, factor: f64) {
    match value {
        Value::Integer(integer) => *value = Value::Float(*integer as f64 * factor),
        Value::Float(float) => *float *= factor,
        Value::Array(items) => items.iter_mut().for_each(|item| multiply(item, factor)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::forces::Kind;

    const TEXT: &str = "name = \"a\"\nduration = 2\n[body]\npoints = [{ mass = 1, position = [1, 0, 0.5] }]\n\
                        [[forces]]\nlaw = \"spring\"\npoint = 0\nanchor = [0, 0, 0]\nstiffness = 4.0\n";

    #[test]
    fn numbers_are_named_by_their_paths_and_indices_are_none() {
        let keys = SceneText::open(TEXT).expect("TOML").keys();
        for key in ["duration", "body.points.0.mass", "body.points.0.position.2", "forces.0.stiffness", SCALE]
        {
            assert!(keys.iter().any(|known| known == key), "{key} in {keys:?}");
        }
        assert!(!keys.iter().any(|key| key.ends_with(".point") || key == "name"), "{keys:?}");
    }

    #[test]
    fn a_key_sets_what_it_names_and_nothing_else() {
        let mut scene = SceneText::open(TEXT).expect("TOML");
        let before = scene.clone();
        assert!(scene.set("forces.*.stiffness", 0.1));
        assert!(scene.text().contains("stiffness = 0.1"), "{}", scene.text());
        assert!(scene.set("forces.0.stiffness", 4.0));
        assert_eq!(scene.text(), before.text());
        for unknown in
            ["forces.1.stiffness", "forces.0.point", "forces.0.law", "mass", "body.points", "", "forces.-1"]
        {
            assert!(!scene.has(unknown), "{unknown}");
        }
    }

    #[test]
    fn a_scaled_body_has_scaled_lengths_and_its_own_masses() {
        let mut scene = SceneText::open(TEXT).expect("TOML");
        assert!(scene.set(SCALE, 3.0));
        let text = scene.text();
        assert!(text.contains("position = [3.0, 0.0, 1.5]") && text.contains("mass = 1"), "{text}");
        let inertia = "name = \"a\"\n[body]\nmass = 2.0\ninertia = [1.0, 2.0, 2.5]\n";
        let mut scene = SceneText::open(inertia).expect("TOML");
        assert!(scene.set(SCALE, 2.0));
        assert!(scene.text().contains("inertia = [4.0, 8.0, 10.0]") && scene.text().contains("mass = 2.0"));
    }

    #[test]
    fn every_parameter_of_every_law_has_a_key() {
        for law in &Law::ALL {
            let required = law.parameters.iter().filter(|p| p.default.is_none());
            let lines = required.map(|p| format!("{} = {}\n", p.key_of(&p.example), p.example));
            let text = format!("[body]\n[[forces]]\nlaw = \"{}\"\n{}", law.name, lines.collect::<String>());
            let keys = SceneText::open(&text).expect("TOML").keys();
            for parameter in law.parameters {
                let path = format!("forces.0.{}", parameter.key);
                let path = match parameter.kind {
                    Kind::Number | Kind::PerPoint => path,
                    Kind::Vector => format!("{path}.2"),
                    Kind::Matrix => format!("{path}.2.0"),
                    Kind::Attachment | Kind::Axes => continue,
                };
                assert!(keys.contains(&path), "{path} of {} in {keys:?}", law.name);
            }
        }
    }
}
